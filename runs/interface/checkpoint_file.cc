#include "runs/interface/checkpoint_file.h"

#include "database/files/digest.h"
#include "database/files/files.h"
#include "database/files/json_text.h"
#include "database/files/regular_file.h"
#include "meshing/errors.h"

#include <cstdint>
#include <cstring>

namespace dpcontact
{
  namespace
  {
    const std::string title = "dpcontact checkpoint 1\n";

    constexpr std::size_t digest_length = 64;

    [[noreturn]] void refuse(const std::filesystem::path &file, const std::string &why)
    {
      throw CorruptData(file.string() + " " + why + ": remove it to start anew");
    }

    void
    compare_settings(const std::filesystem::path &file, const Json &stored, const Json &settings)
    {
      std::string text;
      for (const JsonDifference &entry : differences(stored, settings))
        text += (text.empty() ? "" : ", ") + entry.name;
      if (!text.empty())
        throw SettingsMismatch("the checkpoint " + file.string() +
                               " was written with other settings (" + text +
                               "): give those, or remove it to start anew");
    }

    /// The arrays whose names and sizes are listed, out of all their numbers.
    Arrays
    arrays_of(const std::filesystem::path &file, const Json &sizes, const std::string &numbers)
    {
      const auto wrong = [&file] {
        refuse(file, "is damaged: its sizes are not those of the numbers in it");
      };
      Arrays      state;
      std::size_t begin = 0;
      for (const auto &entry : sizes)
        {
          if (!entry.at(1).is_number_unsigned())
            wrong();
          const auto size = entry.at(1).get<std::uint64_t>();
          if (size > (numbers.size() - begin) / sizeof(double))
            wrong();
          std::vector<double> &array = state[entry.at(0).get<std::string>()];
          array.resize(size);
          const std::size_t bytes = size * sizeof(double);
          if (bytes > 0)
            std::memcpy(array.data(), numbers.data() + begin, bytes);
          begin += bytes;
        }
      if (begin != numbers.size())
        wrong();
      return state;
    }
  } // namespace

  void
  write_checkpoint(const std::filesystem::path &file, const Json &settings, const Arrays &state)
  {
    Json sizes = Json::array();
    for (const auto &[name, numbers] : state)
      sizes.push_back({name, numbers.size()});
    std::string content = Json{{"settings", settings}, {"sizes", sizes}}.dump() + "\n";
    for (const auto &[name, numbers] : state)
      content.append(reinterpret_cast<const char *>(numbers.data()),
                     numbers.size() * sizeof(double));
    write_file(file, title + sha256(content) + "\n" + content);
  }

  Arrays read_checkpoint(const std::filesystem::path &file, const Json &settings)
  {
    require_regular_file(file);
    const std::string text = read_file(file);
    if (text.compare(0, title.size(), title) != 0)
      refuse(file, "is not a checkpoint of this version of dpcontact");
    const std::size_t start = title.size() + digest_length + 1;
    if (text.size() < start)
      refuse(file, "is truncated");
    const std::string content = text.substr(start);
    if (sha256(content) != text.substr(title.size(), digest_length))
      refuse(file, "is damaged: its digest is not that of its content");

    const std::size_t header_end = content.find('\n');
    if (header_end == std::string::npos)
      refuse(file, "is truncated");
    try
      {
        const Json header = parse_json<Json>(content.substr(0, header_end), file.string());
        compare_settings(file, header.at("settings"), settings);
        return arrays_of(file, header.at("sizes"), content.substr(header_end + 1));
      }
    catch (const Json::exception &)
      {
        refuse(file, "is damaged: it does not name its settings and sizes");
      }
  }
} // namespace dpcontact
