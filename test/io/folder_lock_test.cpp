// Only one run at a time writes to a folder.
#include "io/folder_lock.h"

#include <sys/wait.h>
#include <unistd.h>

#include "io/output_files.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

namespace fs = std::filesystem;

class FolderLock : public testing::Test {
 protected:
  FolderLock() : folder_(fs::path(testing::TempDir()) / "folder_lock" / "report") {
    fs::remove_all(folder_.parent_path());
  }
  ~FolderLock() override { fs::remove_all(folder_.parent_path()); }

  std::string refusal() const {
    return messageOf<io::OutputRefused>([&] { const io::FolderLock lock(folder_); });
  }

  // Returns true if another process can lock the folder.
  bool otherProcessGetsIt() const {
    const pid_t child = fork();
    if (child == 0) {
      _exit(refusal().empty() ? 0 : 1);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return status == 0;
  }

  fs::path folder_;
};

TEST_F(FolderLock, TheSecondIsRefusedAsLongAsTheFirstRuns) {
  {
    const io::FolderLock lock(folder_);
    EXPECT_THAT(refusal(), testing::AllOf(testing::StartsWith(folder_.string() + ": another run is writing"),
                                          testing::HasSubstr("accepted: another folder")));
    EXPECT_FALSE(otherProcessGetsIt());
  }
  EXPECT_TRUE(otherProcessGetsIt());
  EXPECT_EQ(refusal(), "");
}

TEST_F(FolderLock, ByAnyNameOfTheFolder) {
  fs::create_directories(folder_);
  fs::create_symlink(folder_, folder_.parent_path() / "link");
  const io::FolderLock lock(folder_.parent_path() / "link");
  EXPECT_NE(refusal(), "");
}

TEST_F(FolderLock, AFolderThatItMadeForNothingGoes) {
  std::make_unique<io::FolderLock>(folder_).reset();
  EXPECT_FALSE(fs::exists(folder_));
  fs::create_directories(folder_);
  std::make_unique<io::FolderLock>(folder_).reset();
  EXPECT_TRUE(fs::exists(folder_));  // the folder existed before the lock
}

TEST_F(FolderLock, AFolderWithAReportStays) {
  {
    const io::FolderLock lock(folder_);
    std::ofstream(folder_ / "report.json") << "{}";
  }
  EXPECT_TRUE(fs::exists(folder_ / "report.json"));
}

TEST_F(FolderLock, WhatCannotBeMadeIsSaid) {
  fs::create_directories(folder_.parent_path());
  std::ofstream(folder_) << "a file";
  EXPECT_THROW(io::FolderLock{folder_}, std::runtime_error);
}

}  // namespace
}  // namespace rubber_suspension
