#include "database/rows/row_json.h"

#include "database/rows/schema.h"
#include "meshing/errors.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace dpcontact
{
  namespace
  {
    using nlohmann::json;

    template <typename T>
    json encode(const T &value)
    {
      if constexpr (std::is_same_v<T, std::string>)
        return clean_text(value);
      else if constexpr (std::is_floating_point_v<T>)
        {
          if (std::isfinite(value))
            return value;
          return std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
        }
      else
        return value;
    }

    /// Whether a signed integer holds the number without loss.
    template <typename T>
    bool fits(const json &entry)
    {
      if (entry.is_number_unsigned()) // nlohmann's kind of every integer that is not negative
        return entry.get<std::uint64_t>() <=
               static_cast<std::uint64_t>(std::numeric_limits<T>::max());
      return entry.is_number_integer() &&
             entry.get<std::int64_t>() >= std::numeric_limits<T>::min();
    }

    template <typename T>
    void decode(const json &entry, const std::string &name, T &value)
    {
      bool ok = false;
      if constexpr (std::is_same_v<T, std::string>)
        ok = entry.is_string();
      else if constexpr (std::is_floating_point_v<T>)
        {
          if (entry.is_string())
            {
              const auto &text = entry.get_ref<const std::string &>();
              const bool  inf  = text == "inf" || text == "-inf";
              if (!inf && text != "nan")
                throw CorruptData("a row's entry '" + name + "' is not a number: " + text);
              value = !inf                  ? std::numeric_limits<T>::quiet_NaN()
                      : text.front() == '-' ? -std::numeric_limits<T>::infinity()
                                            : std::numeric_limits<T>::infinity();
              return;
            }
          ok = entry.is_number();
        }
      else if constexpr (std::is_unsigned_v<T>)
        ok =
          entry.is_number_unsigned() && entry.get<std::uint64_t>() <= std::numeric_limits<T>::max();
      else
        ok = fits<T>(entry);
      if (!ok)
        throw CorruptData("a row's entry '" + name + "' has the wrong type");
      value = entry.get<T>();
    }

    const json &entry_of(const json &object, const std::string &name)
    {
      if (!object.is_object() || !object.contains(name))
        throw CorruptData("a row lacks its entry '" + name + "'");
      return object.at(name);
    }

    template <typename Member, typename Points>
    json encode_member(const Points &points, const Member member)
    {
      json values = json::array();
      for (const auto &point : points)
        values.push_back(encode(point.*member));
      return values;
    }

    template <typename Member, typename Points>
    void decode_member(const json        &object,
                       const std::string &name,
                       const Member       member,
                       const bool         first,
                       Points            &points)
    {
      const json &values = entry_of(object, name);
      if (!values.is_array())
        throw CorruptData("a row's entry '" + name + "' is not an array");
      if (first)
        points.resize(values.size());
      if (values.size() != points.size())
        throw CorruptData("a row's entry '" + name + "' has another length than its neighbours");
      for (std::size_t i = 0; i < points.size(); ++i)
        decode(values[i], name, points[i].*member);
    }

    json encode_branch(const std::vector<CurvePoint> &points)
    {
      json branch = json::object();
      for (const CurveQuantity &quantity : curve_quantities())
        std::visit(
          [&](const auto member) { branch[quantity.name] = encode_member(points, member); },
          quantity.member);
      return branch;
    }

    std::vector<CurvePoint> decode_branch(const json &branch)
    {
      std::vector<CurvePoint> points;
      bool                    first = true;
      for (const CurveQuantity &quantity : curve_quantities())
        {
          std::visit(
            [&](const auto member) { decode_member(branch, quantity.name, member, first, points); },
            quantity.member);
          first = false;
        }
      return points;
    }
  } // namespace

  std::string clean_text(const std::string &text)
  {
    // nlohmann's serialiser replaces invalid UTF-8 on the way out; its parser takes that back in.
    using Handler     = json::error_handler_t;
    std::string valid = json::parse(json(text).dump(-1, ' ', false, Handler::replace));
    for (auto at = valid.find('\0'); at != std::string::npos; at = valid.find('\0', at))
      valid.replace(at, 1, "\xEF\xBF\xBD");
    return valid;
  }

  json to_json(const Record &record)
  {
    json object = json::object();
    for (const auto &column : schema::columns())
      std::visit([&](const auto &value) { object[column.name] = encode(value); },
                 column.get(record));
    object["curve"] = {{"loading", encode_branch(record.curve.loading)},
                       {"unloading", encode_branch(record.curve.unloading)}};
    json profile    = json::object();
    for (const auto &column : schema::profile_columns())
      profile[column.name] = encode_member(record.peak_profile, column.member);
    object["peak_profile"] = profile;
    return object;
  }

  Record record_from_json(const json &object)
  {
    Record record;
    for (const auto &column : schema::columns())
      {
        schema::Cell cell = column.get(record);
        std::visit([&](auto &value) { decode(entry_of(object, column.name), column.name, value); },
                   cell);
        schema::enter(column, cell, record);
      }
    const json &curve      = entry_of(object, "curve");
    record.curve.loading   = decode_branch(entry_of(curve, "loading"));
    record.curve.unloading = decode_branch(entry_of(curve, "unloading"));
    const json &profile    = entry_of(object, "peak_profile");
    bool        first      = true;
    for (const auto &column : schema::profile_columns())
      {
        decode_member(profile, column.name, column.member, first, record.peak_profile);
        first = false;
      }
    return record;
  }
} // namespace dpcontact
