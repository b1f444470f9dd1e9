// A new file is written under another name and then renamed, so that the older file stays whole until then.
#include "log/new_file.h"

#include <signal.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "rubber_suspension/log/log.h"
#include "support/files.h"
#include "support/kit.h"
#include "support/scratch_folder.h"

namespace rubber_suspension {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> namesIn(const std::string& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string errorOf(const std::function<void()>& work) {
  return messageOf<std::runtime_error>([&] { work(); });
}

TEST(NewFile, TakesTheNameWhenItIsCommitted) {
  const TemporaryFile file("out.svg", "older");
  {
    log::NewFile beside(file.path());
    EXPECT_EQ(fs::path(beside.writingPath()).parent_path(), fs::canonical(file.folder()));
    EXPECT_EQ(fs::path(beside.writingPath()).extension(), ".svg");
    std::ofstream(beside.writingPath()) << "newer";
    EXPECT_EQ(contentOf(file.path()), "older");
    beside.commit();
    EXPECT_EQ(contentOf(file.path()), "newer");
  }
  EXPECT_THAT(namesIn(file.folder()), ElementsAre("out.svg"));
}

TEST(NewFile, LeavesNothingWithoutCommit) {
  const TemporaryFile file("out.csv", "older");
  {
    log::NewFile beside(file.path());
    std::ofstream(beside.writingPath()) << "half";
  }
  EXPECT_EQ(contentOf(file.path()), "older");
  EXPECT_THAT(namesIn(file.folder()), ElementsAre("out.csv"));
}

TEST(NewFile, FollowsLinksAndKeepsPermissions) {
  const TemporaryFile file("real.csv", "older");
  chmod(file.path().c_str(), 0640);
  const fs::path link = fs::path(file.folder()) / "link.csv";
  fs::create_symlink("real.csv", link);
  log::writeNewFile(link.string(), "newer");
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(contentOf(file.path()), "newer");
  struct stat status{};
  ASSERT_EQ(stat(file.path().c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0640U);
  const fs::path dangling = fs::path(file.folder()) / "dangling.csv";
  fs::create_symlink("to_come.csv", dangling);
  log::writeNewFile(dangling.string(), "come");
  EXPECT_EQ(contentOf(fs::path(file.folder()) / "to_come.csv"), "come");
}

TEST(NewFile, ANewOneHasTheUsualPermissions) {
  const TemporaryFile folder("keep", "");
  const mode_t mask = umask(027);
  log::writeNewFile(folder.folder() + "/out.csv", "text");
  umask(mask);
  struct stat status{};
  ASSERT_EQ(stat((folder.folder() + "/out.csv").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0640U);
}

TEST(NewFile, WritesToDevicesAtOnce) {
  EXPECT_NO_THROW(log::writeNewFile("/dev/null", "text"));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_THAT(errorOf([] { log::writeNewFile("/dev/full", "text"); }), HasSubstr("/dev/full: cannot be written"));
}

TEST(NewFile, NamesWhatCannotBeWritten) {
  const TemporaryFile file("out.csv", "older");
  EXPECT_THAT(errorOf([] { log::NewFile("/nonexistent/out.csv"); }),
              HasSubstr("/nonexistent/out.csv: cannot be written: No such file or directory"));
  EXPECT_THAT(errorOf([&] { log::NewFile(file.folder() + ""); }), HasSubstr("Is a directory"));
  if (geteuid() != 0) {  // root may write to any file
    chmod(file.path().c_str(), 0400);
    EXPECT_THAT(errorOf([&] { log::NewFile(file.path()); }), HasSubstr("Permission denied"));
  }
}

// Runs the work in a child process and returns the exit status of the child.
int inChild(const std::function<void()>& work) {
  const pid_t child = fork();
  if (child == 0) {
    work();
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return status;
}

class NewFileOnSignal : public ::testing::TestWithParam<int> {};

TEST_P(NewFileOnSignal, IsRemovedAndTheOlderStays) {
  const TemporaryFile file("out.csv", "older");
  const int status = inChild([&] {
    signal(GetParam(), SIG_DFL);
    log::NewFile beside(file.path());
    std::ofstream(beside.writingPath()) << "half";
    raise(GetParam());
    std::ofstream(file.path()) << "not ended by the signal";
  });
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == GetParam());
  EXPECT_EQ(contentOf(file.path()), "older");
  EXPECT_THAT(namesIn(file.folder()), ElementsAre("out.csv"));
}

INSTANTIATE_TEST_SUITE_P(Signals, NewFileOnSignal, ::testing::Values(SIGINT, SIGTERM, SIGHUP));

log::Log longLog() {
  return logOf("", 20000, 1000000, [](int i) { return 1e-3 / 3.0 * i; });
}

// A limit on file sizes interrupts the writing, as a full disk does.
TEST(NewFile, AFileBeyondTheLimitLeavesTheOlder) {
  const TemporaryFile file("out.csv", "older");
  const int status = inChild([&] {
    const rlimit limit{65536, 65536};
    setrlimit(RLIMIT_FSIZE, &limit);
    const std::string error = errorOf([&] { log::writeLogCsv(file.path(), longLog()); });
    _exit(error.find("out.csv: cannot be written: File too large") == std::string::npos ? 1 : 0);
  });
  EXPECT_EQ(status, 0);
  EXPECT_EQ(contentOf(file.path()), "older");
  EXPECT_THAT(namesIn(file.folder()), ElementsAre("out.csv"));
}

// The file system of 64 KiB is full. The test is skipped where mounting is not permitted.
TEST(NewFile, AFullDiskLeavesTheOlder) {
  const TemporaryFile folder("keep", "");
  const std::string disk = folder.folder() + "/disk";
  fs::create_directory(disk);
  if (mount("none", disk.c_str(), "tmpfs", 0, "size=64k") != 0) {
    GTEST_SKIP() << "no file system may be mounted here";
  }
  std::ofstream(disk + "/out.csv") << "older";
  const std::string error = errorOf([&] { log::writeLogCsv(disk + "/out.csv", longLog()); });
  EXPECT_THAT(error, HasSubstr("/out.csv: cannot be written: No space left on device"));
  EXPECT_EQ(contentOf(disk + "/out.csv"), "older");
  EXPECT_THAT(namesIn(disk), ElementsAre("out.csv"));
  EXPECT_EQ(umount(disk.c_str()), 0);
}

}  // namespace
}  // namespace rubber_suspension
