// The memory that is available to the computer and its control groups, from files in the kernel's format.
#include "io/available_memory.h"

#include <sys/resource.h>
#include <unistd.h>

#include "support/test.h"

namespace rubber_suspension {
namespace {

constexpr std::uint64_t kMebibyte = 1024 * 1024;

class AvailableMemory : public testing::Test {
 protected:
  AvailableMemory() : root_(testing::TempDir() + "/available_memory") {
    std::filesystem::remove_all(root_);
    write("/proc/meminfo", "MemTotal:  8388608 kB\nMemFree:  1024 kB\nMemAvailable:  4194304 kB\nSwapFree: 99 kB\n");
  }
  ~AvailableMemory() override { std::filesystem::remove_all(root_); }

  void write(const std::string& path, const std::string& text) const {
    std::filesystem::create_directories(std::filesystem::path(root_ + path).parent_path());
    std::ofstream(root_ + path) << text;
  }

  std::uint64_t mebibytes() const { return io::availableMemory(root_) / kMebibyte; }

  std::string root_;
};

TEST_F(AvailableMemory, OfTheMachine) { EXPECT_EQ(mebibytes(), 4096U); }

TEST_F(AvailableMemory, NothingIsKnown) {
  EXPECT_EQ(io::availableMemory(root_ + "/nowhere"), io::kUnlimitedMemory);
  write("/proc/meminfo", "");
  EXPECT_EQ(io::availableMemory(root_), io::kUnlimitedMemory);
}

TEST_F(AvailableMemory, OfControlGroupsOfVersion2) {
  write("/proc/self/cgroup", "0::/user.slice/job.scope\n");
  const std::string group = "/sys/fs/cgroup/user.slice/job.scope";
  write(group + "/memory.max", "max\n");
  write(group + "/memory.current", "104857600\n");
  EXPECT_EQ(mebibytes(), 4096U);
  write(group + "/memory.max", "1073741824\n");
  EXPECT_EQ(mebibytes(), 924U);
  write(group + "/memory.stat", "anon 5\ninactive_file 52428800\nactive_file 7\n");
  EXPECT_EQ(mebibytes(), 974U);
  write("/sys/fs/cgroup/user.slice/memory.max", "209715200\n");  // the parent group has a lower limit
  write("/sys/fs/cgroup/user.slice/memory.current", "104857600\n");
  EXPECT_EQ(mebibytes(), 100U);
  write("/sys/fs/cgroup/user.slice/memory.current", "999999999\n");  // all of it is used
  EXPECT_EQ(mebibytes(), 0U);
}

TEST_F(AvailableMemory, OfControlGroupsOfVersion1) {
  write("/proc/self/cgroup", "5:cpu,cpuacct:/a\n4:memory:/job\n0::/\n");
  write("/sys/fs/cgroup/memory/memory.limit_in_bytes", "9223372036854771712\n");
  write("/sys/fs/cgroup/memory/memory.usage_in_bytes", "104857600\n");
  EXPECT_EQ(mebibytes(), 4096U);
  write("/sys/fs/cgroup/memory/job/memory.limit_in_bytes", "1073741824\n");
  write("/sys/fs/cgroup/memory/job/memory.usage_in_bytes", "104857600\n");
  write("/sys/fs/cgroup/memory/job/memory.stat", "inactive_file 1\ntotal_inactive_file 52428800\n");
  EXPECT_EQ(mebibytes(), 974U);
}

TEST_F(AvailableMemory, InAContainerThatSeesItsOwnGroupAsTheTop) {
  write("/proc/self/cgroup", "0::/docker/0123\n");
  write("/sys/fs/cgroup/memory.max", "536870912\n");
  write("/sys/fs/cgroup/memory.current", "0\n");
  EXPECT_EQ(mebibytes(), 512U);
}

TEST_F(AvailableMemory, LinesThatAreNoGroups) {
  write("/proc/self/cgroup", "\n:\n::\nmemory\n1:memory:\n2:memory:relative\n");
  EXPECT_EQ(mebibytes(), 4096U);
}

TEST_F(AvailableMemory, OfTheLimitOfAddresses) {
  // The limit applies to the test itself, so it must exceed the address space that a build with sanitizers reserves.
  constexpr std::uint64_t kLimit = std::uint64_t{64} << 40U;
  write("/proc/self/statm", "1000 10 1\n");
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_AS, &before), 0);
  const rlimit lower{kLimit, before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_AS, &lower), 0);
  write("/proc/meminfo", "");
  const std::uint64_t left = io::availableMemory(root_);
  EXPECT_EQ(setrlimit(RLIMIT_AS, &before), 0);
  EXPECT_EQ(left, kLimit - 1000 * static_cast<std::uint64_t>(getpagesize()));
}

TEST(AvailableMemoryOfThisMachine, IsSome) { EXPECT_GT(io::availableMemory(), kMebibyte); }

}  // namespace
}  // namespace rubber_suspension
