// SHA-256 of files and texts, by OpenSSL.
#include "io/sha256.h"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <vector>

namespace rubber_suspension::io {
namespace {

class Digest {
 public:
  Digest() : context_(EVP_MD_CTX_new(), EVP_MD_CTX_free) {
    require(context_ != nullptr && EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr) == 1);
  }

  void add(const char* bytes, std::size_t count) { require(EVP_DigestUpdate(context_.get(), bytes, count) == 1); }

  std::string finish() {
    std::array<unsigned char, EVP_MAX_MD_SIZE> bytes{};
    unsigned count = 0;
    require(EVP_DigestFinal_ex(context_.get(), bytes.data(), &count) == 1);
    std::string text;
    for (unsigned i = 0; i < count; ++i) {
      text += fmt::format("{:02x}", bytes[i]);
    }
    return text;
  }

 private:
  static void require(bool success) {
    if (!success) {
      throw std::runtime_error("SHA-256: OpenSSL refuses it");
    }
  }

  std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context_;
};

[[noreturn]] void fail(const std::string& path, int error) {
  throw std::runtime_error(fmt::format("{}: cannot be read: {}", path, std::strerror(error)));
}

}  // namespace

std::string sha256(const std::string& text) {
  Digest digest;
  digest.add(text.data(), text.size());
  return digest.finish();
}

FileHash hashFile(const std::string& path) {
  constexpr std::size_t kPiece = 256 * 1024;  // bytes
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rbe"), std::fclose);
  if (!file) {
    fail(path, errno);
  }
  std::setvbuf(file.get(), nullptr, _IONBF, 0);
  static thread_local std::vector<char> piece(kPiece);
  Digest digest;
  FileHash result;
  for (;;) {
    const std::size_t count = std::fread(piece.data(), 1, kPiece, file.get());
    digest.add(piece.data(), count);
    result.size += count;
    if (count < kPiece) {
      break;
    }
  }
  if (std::ferror(file.get()) != 0) {
    fail(path, errno);
  }
  result.sha256 = digest.finish();
  return result;
}

}  // namespace rubber_suspension::io
