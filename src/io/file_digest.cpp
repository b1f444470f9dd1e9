// The SHA-256 of a file, by OpenSSL's libcrypto.
#include "io/file_digest.h"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <memory>
#include <stdexcept>

namespace rubber_suspension::io {
namespace {

using Context = std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)>;

void require(int success) {
  if (success != 1) {
    throw std::runtime_error("SHA-256 is not available in the OpenSSL library of this machine");
  }
}

}  // namespace

std::string sha256OfFile(const std::string& path) {
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  const Context context(EVP_MD_CTX_new(), EVP_MD_CTX_free);
  require(context ? EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr) : 0);
  std::array<char, 65536> portion{};
  while (file.read(portion.data(), portion.size()) || file.gcount() > 0) {
    require(EVP_DigestUpdate(context.get(), portion.data(), static_cast<std::size_t>(file.gcount())));
  }
  if (!file.eof()) {
    throw std::runtime_error(fmt::format("{}: cannot be read: {}", path, std::strerror(errno == 0 ? EIO : errno)));
  }
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int length = 0;
  require(EVP_DigestFinal_ex(context.get(), digest.data(), &length));
  std::string text;
  for (unsigned int i = 0; i < length; ++i) {
    text += fmt::format("{:02x}", digest[i]);
  }
  return text;
}

}  // namespace rubber_suspension::io
