#include "database/files/regular_file.h"

#include "meshing/errors.h"

#include <string>
#include <system_error>

namespace dpcontact
{
  void require_regular_file(const std::filesystem::path &file, const std::uintmax_t largest)
  {
    std::error_code error;
    const auto      status = std::filesystem::status(file, error);
    const auto      refuse = [&file](const std::string &why) {
      throw FileError("cannot read " + file.string() + ": " + why);
    };
    if (error)
      refuse(error.message());
    if (status.type() == std::filesystem::file_type::directory)
      refuse("it is a directory");
    if (status.type() != std::filesystem::file_type::regular)
      refuse("it is no regular file (a pipe, a socket or a device)");
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    if (error)
      refuse(error.message());
    if (size > largest)
      throw InputError(file.string() + " has " + std::to_string(size) +
                       " bytes; a file of its kind may have at most " + std::to_string(largest));
  }
} // namespace dpcontact
