#include "runs/interface/checkpoint_file.h"

#include "database/files/digest.h"
#include "database/files/files.h"
#include "meshing/errors.h"

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
    const Json        header     = Json::parse(content.substr(0, header_end));
    if (header.at("settings") != settings)
      {
        std::string differences;
        for (const auto &change : Json::diff(header.at("settings"), settings))
          differences +=
            (differences.empty() ? "" : ", ") + change.at("path").get<std::string>().substr(1);
        throw SettingsMismatch("the checkpoint " + file.string() +
                               " was written with other settings (" + differences +
                               "): give those, or remove it to start anew");
      }
    Arrays      state;
    const char *next = content.data() + header_end + 1;
    for (const auto &entry : header.at("sizes"))
      {
        std::vector<double> &numbers = state[entry.at(0).get<std::string>()];
        numbers.resize(entry.at(1).get<std::size_t>());
        if (!numbers.empty())
          std::memcpy(numbers.data(), next, numbers.size() * sizeof(double));
        next += numbers.size() * sizeof(double);
      }
    return state;
  }
} // namespace dpcontact
