#include "database/digest.h"

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
} // namespace dpcontact
