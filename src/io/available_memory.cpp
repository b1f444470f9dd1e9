// Memory that this process may still take.
#include "io/available_memory.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <optional>
#include <sstream>

namespace rubber_suspension::io {
namespace {

constexpr std::uint64_t kKibibyte = 1024;

std::uint64_t lessOrNothing(std::uint64_t whole, std::uint64_t part) { return whole - std::min(whole, part); }

// The first number of a file; none where there is none, as where a limit says "max".
std::optional<std::uint64_t> numberIn(const std::string& path) {
  std::ifstream file(path);
  std::uint64_t value = 0;
  return file >> value ? std::optional<std::uint64_t>(value) : std::nullopt;
}

// The number beside a name, in a file of lines "NAME NUMBER ...".
std::optional<std::uint64_t> numberOf(const std::string& name, const std::string& path) {
  std::ifstream file(path);
  std::string line;
  while (std::getline(file, line)) {
    std::istringstream words(line);
    std::string word;
    std::uint64_t value = 0;
    if (words >> word >> value && word == name) {
      return value;
    }
  }
  return std::nullopt;
}

// Where a control group says what it may take and what it has taken.
struct GroupFiles {
  const char* limit;
  const char* usage;
  const char* reclaimable;  // of memory.stat
};

constexpr GroupFiles kVersion1 = {"/memory.limit_in_bytes", "/memory.usage_in_bytes", "total_inactive_file"};
constexpr GroupFiles kVersion2 = {"/memory.max", "/memory.current", "inactive_file"};

std::uint64_t leftOfGroup(const std::string& folder, const GroupFiles& files) {
  const auto limit = numberIn(folder + files.limit);
  const auto usage = numberIn(folder + files.usage);
  if (!limit || !usage) {
    return kUnlimitedMemory;
  }
  const std::uint64_t reclaimable = numberOf(files.reclaimable, folder + "/memory.stat").value_or(0);
  return lessOrNothing(*limit, lessOrNothing(*usage, reclaimable));
}

// Of a group and all above it. In a container the path may be that of the machine, which is not there: its own group is
// then the top.
std::uint64_t leftOfGroups(const std::string& mount, std::string path, const GroupFiles& files) {
  std::uint64_t left = leftOfGroup(mount, files);
  while (path.size() > 1) {
    left = std::min(left, leftOfGroup(mount + path, files));
    path.erase(path.rfind('/'));
  }
  return left;
}

// Lines "NUMBER:CONTROLLERS:PATH"; without controllers that of version 2.
std::uint64_t leftOfControlGroups(const std::string& root) {
  std::ifstream file(root + "/proc/self/cgroup");
  std::uint64_t left = kUnlimitedMemory;
  std::string line;
  while (std::getline(file, line)) {
    const std::size_t first = line.find(':');
    const std::size_t second = first == std::string::npos ? first : line.find(':', first + 1);
    if (second == std::string::npos || line.compare(second + 1, 1, "/") != 0) {
      continue;
    }
    const std::string controllers = "," + line.substr(first + 1, second - first - 1) + ",";
    const std::string path = line.substr(second + 1);
    if (controllers == ",,") {
      left = std::min(left, leftOfGroups(root + "/sys/fs/cgroup", path, kVersion2));
    } else if (controllers.find(",memory,") != std::string::npos) {
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

std::uint64_t leftOfMachine(const std::string& root) {
  const auto left = numberOf("MemAvailable:", root + "/proc/meminfo");
  return left ? *left * kKibibyte : kUnlimitedMemory;
}

}  // namespace

std::uint64_t availableMemory(const std::string& root) {
  return std::min({leftOfMachine(root), leftOfControlGroups(root), leftOfAddresses(root)});
}

}  // namespace rubber_suspension::io
