#ifndef DPCONTACT_TESTS_SUPPORT_RECORDS_H
#define DPCONTACT_TESTS_SUPPORT_RECORDS_H

#include "database/rows/schema.h"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <unistd.h>

namespace dpcontact::testing_database
{
  namespace fs = std::filesystem;

  /// A directory of its own for every test, removed afterwards.
  class InDirectory : public ::testing::Test
  {
  protected:
    InDirectory()
    {
      std::string name = (fs::temp_directory_path() / "dpcontact-database-XXXXXX").string();
      directory        = ::mkdtemp(name.data());
    }
    ~InDirectory() override { fs::remove_all(directory); }

    fs::path directory;
  };

  inline std::string slurp(const fs::path &file)
  {
    std::ifstream      in(file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
  }

  inline void spill(const fs::path &file, const std::string &text)
  {
    std::ofstream(file, std::ios::binary) << text;
  }

  /// A double of any magnitude, with all its bits in use; now and then a special one.
  inline double any_double(std::mt19937_64 &generator)
  {
    const double special[] = {std::numeric_limits<double>::quiet_NaN(),
                              std::numeric_limits<double>::infinity(),
                              -std::numeric_limits<double>::infinity(),
                              -0.0,
                              5e-324,
                              2.2250738585072011e-308,
                              std::numeric_limits<double>::max(),
                              0.1};
    if (generator() % 8 == 0)
      return special[generator() % 8];
    while (true)
      {
        const std::uint64_t bits = generator();
        double              value;
        std::memcpy(&value, &bits, sizeof value);
        if (value == value)
          return value;
      }
  }

  /// A row whose every number is arbitrary and whose texts are awkward. Its inputs are those of a
  /// rock.
  inline Record any_record(const std::uint64_t seed, const std::size_t points = 7)
  {
    std::mt19937_64 generator(seed);
    Record          record;
    for (const schema::Column &column : schema::columns())
      if (column.is_number())
        column.set(record, any_double(generator));
      else if (!column.is_text())
        column.set(record, std::uint64_t(generator()));
    record.input.material.youngs_modulus       = 1e10 + static_cast<double>(seed);
    record.input.material.poisson_ratio        = 0.1;
    record.input.material.friction_angle       = Angle(20);
    record.input.material.compressive_strength = 5e6;
    record.input.scene                         = {0.1, 100, {}};
    record.status                              = seed % 2 == 0 ? "converged" : "failed";
    record.reason   = seed % 2 == 0 ? "" : "δ ≥ 2 µm, \"cut\" back\nthen # gave up; 停止";
    record.warnings = "a/R > 0.1, really";

    for (auto *branch : {&record.curve.loading, &record.curve.unloading})
      for (std::size_t i = 0; i < points; ++i)
        {
          CurvePoint point;
          for (const CurveQuantity &quantity : curve_quantities())
            if (const auto *number = std::get_if<double CurvePoint::*>(&quantity.member))
              point.**number = any_double(generator);
          point.newton_iterations = static_cast<int>(generator() % 50);
          branch->push_back(point);
        }
    for (std::size_t i = 0; i < 3 * points; ++i)
      record.peak_profile.push_back({any_double(generator), any_double(generator)});
    return record;
  }

  /// The same bits, or both NaN (its payload has no meaning).
  inline bool same(const double x, const double y)
  {
    return (x != x && y != y) || std::memcmp(&x, &y, sizeof x) == 0;
  }

  template <typename T>
  bool same(const T &x, const T &y)
  {
    return x == y;
  }

  inline bool same(const schema::Cell &x, const schema::Cell &y)
  {
    return x.index() == y.index() &&
           std::visit(
             [&](const auto &value) {
               return same(value, std::get<std::decay_t<decltype(value)>>(y));
             },
             x);
  }

  inline void expect_same(const Record &x, const Record &y)
  {
    for (const auto &column : schema::columns())
      EXPECT_TRUE(same(column.get(x), column.get(y))) << column.name;
    using Branch = std::vector<CurvePoint> Curve::*;
    for (const Branch branch : {&Curve::loading, &Curve::unloading})
      {
        ASSERT_EQ((x.curve.*branch).size(), (y.curve.*branch).size());
        for (std::size_t i = 0; i < (x.curve.*branch).size(); ++i)
          for (const CurveQuantity &quantity : curve_quantities())
            std::visit(
              [&](const auto member) {
                EXPECT_TRUE(same((x.curve.*branch)[i].*member, (y.curve.*branch)[i].*member))
                  << quantity.name << ' ' << i;
              },
              quantity.member);
      }
    ASSERT_EQ(x.peak_profile.size(), y.peak_profile.size());
    for (std::size_t i = 0; i < x.peak_profile.size(); ++i)
      {
        EXPECT_TRUE(same(x.peak_profile[i].radius, y.peak_profile[i].radius)) << i;
        EXPECT_TRUE(same(x.peak_profile[i].pressure, y.peak_profile[i].pressure)) << i;
      }
  }

  /// The message of the Exception that @p action must throw.
  template <typename Exception, typename Action>
  std::string message_of(const Action &action)
  {
    try
      {
        action();
      }
    catch (const Exception &error)
      {
        return error.what();
      }
    ADD_FAILURE() << "nothing of the expected type was thrown";
    return {};
  }
} // namespace dpcontact::testing_database

#endif
