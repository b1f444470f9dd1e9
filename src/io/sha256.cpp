// SHA-256 of files and texts, computed by OpenSSL.
#include "io/sha256.h"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "element/refuse.h"

namespace rubber_suspension::io {
namespace {

void require(bool success) { element::refuseIf<std::runtime_error>(!success, "OpenSSL failed to compute SHA-256"); }

// Hashes the pieces that `next` returns one after the other, up to the first empty piece.
template <class Next>
std::string hashOf(Next next) {
  const std::unique_ptr<EVP_MD_CTX, void (*)(EVP_MD_CTX*)> context(EVP_MD_CTX_new(), EVP_MD_CTX_free);
  require(context != nullptr && EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr) == 1);
  for (std::string_view piece = next(); !piece.empty(); piece = next()) {
    require(EVP_DigestUpdate(context.get(), piece.data(), piece.size()) == 1);
  }
  std::array<unsigned char, EVP_MAX_MD_SIZE> bytes{};
  unsigned count = 0;
  require(EVP_DigestFinal_ex(context.get(), bytes.data(), &count) == 1);
  return fmt::format("{:02x}", fmt::join(bytes.data(), bytes.data() + count, ""));
}

}  // namespace

std::string sha256(const std::string& text) {
  return hashOf([left = std::string_view(text)]() mutable { return std::exchange(left, std::string_view()); });
}

FileHash hashFile(const std::string& path) {
  constexpr std::size_t kPiece = 256 * 1024;  // bytes
  const auto require_file = [&](bool success) {
    element::refuseIf<std::runtime_error>(!success, "{}: cannot be read: {}", path, std::strerror(errno));
  };
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rbe"), std::fclose);
  require_file(file != nullptr);
  std::setvbuf(file.get(), nullptr, _IONBF, 0);
  static thread_local std::vector<char> piece(kPiece);
  FileHash result;
  result.sha256 = hashOf([&] {
    const std::size_t count = std::fread(piece.data(), 1, kPiece, file.get());
    require_file(std::ferror(file.get()) == 0);
    result.size += count;
    return std::string_view(piece.data(), count);
  });
  return result;
}

}  // namespace rubber_suspension::io
