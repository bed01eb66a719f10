#include "runs/interface/outputs.h"

#include "database/files/digest.h"
#include "database/files/files.h"
#include "database/files/regular_file.h"
#include "meshing/errors.h"

#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>
#include <unistd.h>

namespace dpcontact
{
  namespace
  {
    using Path = std::filesystem::path;

    /// What the name of a temporary file has more than that of the file: dots, the digest's
    /// ending, and numbers or letters that make it unique.
    constexpr std::size_t longest_addition = 40;

    /// Whether two names are one file. Names of files that are not there yet are compared after the
    /// links in them have been followed.
    bool same_file(const Path &one, const Path &other)
    {
      std::error_code error;
      if (std::filesystem::equivalent(one, other, error) && !error)
        return true;
      std::error_code one_error, other_error;
      const Path      one_place   = std::filesystem::weakly_canonical(one, one_error);
      const Path      other_place = std::filesystem::weakly_canonical(other, other_error);
      return !one_error && !other_error &&
             std::filesystem::absolute(one_place, one_error) ==
               std::filesystem::absolute(other_place, other_error);
    }

    /// Whether one of them, or its digest, is the other or the other's digest.
    bool meet(const Path &one, const Path &other)
    {
      return same_file(one, other) || same_file(digest_path_of(one), other) ||
             same_file(one, digest_path_of(other));
    }

    [[noreturn]] void refuse_place(const Path &file, const std::string &why)
    {
      throw FileError("cannot write " + file.string() + ": " + why);
    }

    void check_place(const Path &file)
    {
      std::error_code error;
      const auto      status = std::filesystem::status(file, error);
      if (status.type() == std::filesystem::file_type::directory)
        refuse_place(file, "it is a directory");
      if (status.type() == std::filesystem::file_type::none)
        refuse_place(file, error.message());
      if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
        refuse_place(file, "it is no regular file (a pipe, a socket or a device)");

      const Path directory = parent_of(file);
      if (!std::filesystem::is_directory(directory, error))
        refuse_place(file, error ? error.message() : std::strerror(ENOTDIR));
      if (::access(directory.c_str(), W_OK | X_OK) != 0)
        refuse_place(file, std::strerror(errno));
      const auto fits = [&directory](const std::size_t length, const int limit) {
        const long most = ::pathconf(directory.c_str(), limit);
        return most < 0 || length + longest_addition <= static_cast<std::size_t>(most);
      };
      if (!fits(file.filename().string().size(), _PC_NAME_MAX) ||
          !fits(file.string().size(), _PC_PATH_MAX))
        refuse_place(file, "the name is too long for the file and the temporary one beside it");
    }
  } // namespace

  void check_files(const CommandFiles &files)
  {
    for (auto output = files.outputs.begin(); output != files.outputs.end(); ++output)
      {
        if (output->empty())
          continue;
        for (const Path &input : files.inputs)
          if (!input.empty() && meet(*output, input))
            throw InputError("the output " + output->string() + " is the input " + input.string() +
                             " or the digest of it: give another name");
        for (auto other = files.outputs.begin(); other != output; ++other)
          if (!other->empty() && meet(*output, *other))
            throw InputError("the outputs " + other->string() + " and " + output->string() +
                             " are one file, or one is the other's digest: give another name");
      }
    for (const Path &input : files.inputs)
      if (!input.empty())
        require_regular_file(input);
    for (const Path &output : files.outputs)
      if (!output.empty())
        check_place(output);
  }
} // namespace dpcontact
