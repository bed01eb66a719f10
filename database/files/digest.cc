#include "database/files/digest.h"

#include "database/files/files.h"
#include "meshing/errors.h"

#include <openssl/evp.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <memory>
#include <unistd.h>
#include <vector>

namespace dpcontact
{
  namespace
  {
    class Sha256
    {
    public:
      Sha256()
        : context(EVP_MD_CTX_new(), &EVP_MD_CTX_free)
      {
        check(context && EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr) == 1);
      }

      void update(const char *data, const std::size_t size)
      {
        check(EVP_DigestUpdate(context.get(), data, size) == 1);
      }

      std::string hexadecimal()
      {
        std::array<unsigned char, EVP_MAX_MD_SIZE> bytes{};
        unsigned int                               size = 0;
        check(EVP_DigestFinal_ex(context.get(), bytes.data(), &size) == 1);

        const char *const digits = "0123456789abcdef";
        std::string       text;
        for (unsigned int i = 0; i < size; ++i)
          {
            text += digits[bytes[i] >> 4];
            text += digits[bytes[i] & 15];
          }
        return text;
      }

    private:
      static void check(const bool ok)
      {
        if (!ok)
          throw Error(ExitCode::internal, "libcrypto cannot compute SHA-256");
      }

      std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context;
    };
  } // namespace

  std::string sha256(const std::string &text)
  {
    Sha256 hash;
    hash.update(text.data(), text.size());
    return hash.hexadecimal();
  }

  std::string sha256_of_file(const std::filesystem::path &file)
  {
    errno = 0;
    std::ifstream in(file, std::ios::binary);
    if (!in)
      throw FileError("cannot read " + file.string() + ": " + std::strerror(errno));

    Sha256            hash;
    std::vector<char> buffer(1 << 20);
    do
      {
        in.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
        hash.update(buffer.data(), static_cast<std::size_t>(in.gcount()));
      }
    while (in);
    if (!in.eof())
      throw FileError("cannot read " + file.string() + " to its end");
    return hash.hexadecimal();
  }

  std::filesystem::path digest_path_of(const std::filesystem::path &file)
  {
    return file.string() + ".sha256";
  }

  namespace
  {
    constexpr std::size_t digits     = 64; ///< of a SHA-256
    constexpr std::size_t most_lines = 2;
    const char *const     remedy     = "; restore both files, or make them again";

    std::string digest_line(const std::string &sum, const std::filesystem::path &file)
    {
      return sum + "  " + file.filename().string() + "\n";
    }

    /// The digests of a digest file: one, or two while the file is being replaced.
    /// @throws CorruptData.
    std::vector<std::string> digests_in(const std::string           &text,
                                        const std::filesystem::path &digest)
    {
      std::vector<std::string> found;
      for (std::size_t at = 0; at < text.size() && found.size() < most_lines;)
        {
          const std::string line = text.substr(at, text.find('\n', at) - at);
          if (line.size() < digits + 1 || line[digits] != ' ' ||
              line.find_first_not_of("0123456789abcdef") != digits)
            break;
          found.push_back(line.substr(0, digits));
          at += line.size() + 1;
        }
      if (found.empty())
        throw CorruptData("the digest " + digest.string() + " is damaged" + remedy);
      return found;
    }

    /// What the program writes with a digest begins as HDF5, with a comment, or with the columns of
    /// a table.
    bool may_be_ours(const std::string &content)
    {
      return content.empty() || content.front() == '#' || begins_as_hdf5(content) ||
             content.substr(0, content.find('\n')).find("phi_deg") != std::string::npos;
    }

    /// @throws CorruptData as check_digest().
    void compare_with_digest(const std::filesystem::path &file,
                             const std::string           &content,
                             const std::string           &actual)
    {
      const std::filesystem::path digest = digest_path_of(file);
      if (!std::filesystem::exists(digest) && !may_be_ours(content))
        throw CorruptData(file.string() +
                          " is not a database or table that dpcontact wrote: it is another kind of "
                          "file, and has no digest beside it; give the .h5 file of a sweep, or the "
                          ".csv of `dpcontact table` or `dpcontact export`");
      if (!std::filesystem::exists(digest))
        throw CorruptData("the digest " + digest.string() +
                          " is missing, so the database cannot be trusted" + remedy);
      const std::vector<std::string> stored = digests_in(read_file(digest), digest);
      if (std::find(stored.begin(), stored.end(), actual) == stored.end())
        throw CorruptData(file.string() + " is truncated or altered: its SHA-256 is " + actual +
                          ", its digest file says " + stored.front() + remedy);
    }

    /// The line of the file that is about to be replaced, if its digest agrees; else nothing.
    std::string present_line(const std::filesystem::path &file)
    {
      try
        {
          const std::string content = read_file(file), sum = sha256(content);
          compare_with_digest(file, content, sum);
          return digest_line(sum, file);
        }
      catch (const Error &)
        {
          return {};
        }
    }
  } // namespace

  bool begins_as_hdf5(const std::string &content) { return content.rfind("\x89HDF\r\n", 0) == 0; }

  void check_digest(const std::filesystem::path &file) { read_with_digest(file); }

  void write_with_digest(const std::filesystem::path &file, const std::string &content)
  {
    const std::filesystem::path digest = digest_path_of(file);
    TemporaryFile               data(file);
    data.write(content);

    const DirectoryLock lock(parent_of(file));
    const bool          replaces = std::filesystem::exists(digest);
    const std::string   present  = present_line(file);
    const std::string   line     = digest_line(sha256(content), file);
    TemporaryFile       both(digest), only(digest), former(digest);
    both.write(line + (present == line ? "" : present));
    only.write(line);
    former.write(replaces ? read_file(digest) : "");
    both.publish();
    try
      {
        data.publish();
      }
    catch (const FileError &)
      {
        if (data.is_published())
          throw; // both digests hold
        if (replaces)
          former.publish();
        else
          ::unlink(digest.c_str());
        throw;
      }
    only.publish();
  }

  std::string read_with_digest(const std::filesystem::path &file)
  {
    // Somebody may replace the file between the reading of it and of its digest.
    constexpr unsigned int most_tries = 3;
    for (unsigned int i = 1; i < most_tries; ++i)
      {
        std::string content = read_file(file);
        try
          {
            compare_with_digest(file, content, sha256(content));
            return content;
          }
        catch (const Error &)
          {}
      }
    std::string content = read_file(file);
    compare_with_digest(file, content, sha256(content));
    return content;
  }
} // namespace dpcontact
