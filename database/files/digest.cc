#include "database/files/digest.h"

#include "database/files/files.h"
#include "meshing/errors.h"

#include <openssl/evp.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <memory>
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

  void check_digest(const std::filesystem::path &file)
  {
    const std::string           remedy = "; restore both files, or make them again";
    const std::string           actual = sha256_of_file(file);
    const std::filesystem::path digest = digest_path_of(file);
    if (!std::filesystem::exists(digest))
      throw CorruptData("the digest " + digest.string() +
                        " is missing, so the database cannot be trusted" + remedy);
    const std::string stored = read_file(digest).substr(0, 65);
    if (stored.size() != 65 || stored.back() != ' ' ||
        stored.find_first_not_of("0123456789abcdef") != 64)
      throw CorruptData("the digest " + digest.string() + " is damaged" + remedy);
    if (stored.compare(0, 64, actual) != 0)
      throw CorruptData(file.string() + " is truncated or altered: its SHA-256 is " + actual +
                        ", its digest file says " + stored.substr(0, 64) + remedy);
  }

  void write_with_digest(const std::filesystem::path &file, const std::string &content)
  {
    TemporaryFile data(file);
    TemporaryFile digest(digest_path_of(file));
    data.write(content);
    data.sync();
    digest.write(sha256(content) + "  " + file.filename().string() + "\n");
    digest.sync();
    data.publish();
    digest.publish();
  }

  std::string read_with_digest(const std::filesystem::path &file)
  {
    check_digest(file);
    return read_file(file);
  }
} // namespace dpcontact
