// Memory that is available to this process.
#include "io/available_memory.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <optional>
#include <sstream>

namespace rubber_suspension::io {
namespace {

std::uint64_t lessOrNothing(std::uint64_t whole, std::uint64_t part) { return whole - std::min(whole, part); }

// Returns the number after a word in a file, or the first number if the word is empty. Returns nullopt if there is no
// number, as for the limit "max".
std::optional<std::uint64_t> numberIn(const std::string& path, const std::string& word = "") {
  std::ifstream file(path);
  std::string read;
  while (read != word && file >> read) {
  }
  std::uint64_t value = 0;
  return file >> value ? std::optional<std::uint64_t>(value) : std::nullopt;
}

struct GroupFiles {
  const char* limit;
  const char* usage;
  const char* reclaimable;  // key in memory.stat
};

constexpr GroupFiles kVersion1 = {"/memory.limit_in_bytes", "/memory.usage_in_bytes", "total_inactive_file"};
constexpr GroupFiles kVersion2 = {"/memory.max", "/memory.current", "inactive_file"};

std::uint64_t leftOfGroup(const std::string& folder, const GroupFiles& files) {
  const auto limit = numberIn(folder + files.limit);
  const auto usage = numberIn(folder + files.usage);
  const std::uint64_t reclaimable = numberIn(folder + "/memory.stat", files.reclaimable).value_or(0);
  return limit && usage ? lessOrNothing(*limit, lessOrNothing(*usage, reclaimable)) : kUnlimitedMemory;
}

// Returns the smallest free memory of a group and its ancestors. In a container the path may be the one of the host,
// which does not exist in the container. Then only the root of the mount counts.
std::uint64_t leftOfGroups(const std::string& mount, std::string path, const GroupFiles& files) {
  std::uint64_t left = leftOfGroup(mount, files);
  for (; path.size() > 1; path.erase(path.rfind('/'))) {
    left = std::min(left, leftOfGroup(mount + path, files));
  }
  return left;
}

// Returns the smallest free memory of the control groups of this process. The file contains lines
// "NUMBER:CONTROLLERS:PATH", where CONTROLLERS is empty for version 2.
std::uint64_t leftOfControlGroups(const std::string& root) {
  std::ifstream file(root + "/proc/self/cgroup");
  std::uint64_t left = kUnlimitedMemory;
  for (std::string line; std::getline(file, line);) {
    std::istringstream parts(line);
    std::string number;
    std::string controllers;
    std::string path;
    std::getline(std::getline(std::getline(parts, number, ':'), controllers, ':'), path);
    if (path[0] == '/' && controllers.empty()) {
      left = std::min(left, leftOfGroups(root + "/sys/fs/cgroup", path, kVersion2));
    } else if (path[0] == '/' && ("," + controllers + ",").find(",memory,") != std::string::npos) {
      left = std::min(left, leftOfGroups(root + "/sys/fs/cgroup/memory", path, kVersion1));
    }
  }
  return left;
}

std::uint64_t leftOfAddresses(const std::string& root) {
  rlimit limit{};
  const auto pages = numberIn(root + "/proc/self/statm");
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY || !pages) {
    return kUnlimitedMemory;
  }
  return lessOrNothing(limit.rlim_cur, *pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)));
}

}  // namespace

std::uint64_t availableMemory(const std::string& root) {
  constexpr std::uint64_t kKibibyte = 1024;
  const auto of_machine = numberIn(root + "/proc/meminfo", "MemAvailable:");
  return std::min(
      {of_machine ? *of_machine * kKibibyte : kUnlimitedMemory, leftOfControlGroups(root), leftOfAddresses(root)});
}

}  // namespace rubber_suspension::io
