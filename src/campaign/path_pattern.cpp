// Patterns by glob(3) of the C library.
#include "campaign/path_pattern.h"

#include <fmt/format.h>
#include <glob.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

namespace rubber_suspension::campaign {
namespace {

struct Matches : glob_t {
  Matches() : glob_t{} {}
  Matches(const Matches&) = delete;
  Matches& operator=(const Matches&) = delete;
  ~Matches() { globfree(this); }
};

// A folder's own name is no pattern, whatever letters it has.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '*' || c == '?' || c == '[' || c == '\\') {
      result += '\\';
    }
    result += c;
  }
  return result;
}

}  // namespace

std::vector<std::string> matchPattern(const std::string& folder, const std::string& pattern) {
  namespace fs = std::filesystem;
  const std::string base = fs::absolute(folder.empty() ? "." : folder).lexically_normal().string();
  Matches matches;
  const std::string full = pattern.front() == '/' ? pattern : escaped(base) + "/" + pattern;
  const int status = glob(full.c_str(), GLOB_NOSORT, nullptr, &matches);
  if (status != 0 && status != GLOB_NOMATCH) {
    throw std::runtime_error(fmt::format("{}: a folder cannot be read", full));
  }
  std::vector<std::string> paths;
  for (std::size_t i = 0; i < matches.gl_pathc; ++i) {
    std::string path = fs::path(matches.gl_pathv[i]).lexically_normal().string();
    if (path.size() > 1 && path.back() == '/') {
      path.pop_back();
    }
    paths.push_back(std::move(path));
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

}  // namespace rubber_suspension::campaign
