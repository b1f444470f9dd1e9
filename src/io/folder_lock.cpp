// Lock of a folder, into which only one run at a time may write.
#include "io/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "io/output_files.h"

namespace rubber_suspension::io {

FolderLock::FolderLock(std::filesystem::path folder) : folder_(std::move(folder)) {
  made_ = makeFolder(folder_.string());
  if (made_) {
    removal_.emplace(folder_.string());
  }
  descriptor_ = open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor_ >= 0 && flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    close(descriptor_);
    throw OutputRefused(folder_.string() +
                        ": another run is writing into this folder; accepted: another folder, or this one later");
  }
}

FolderLock::~FolderLock() {
  if (made_) {
    std::error_code ignored;
    std::filesystem::remove(folder_, ignored);  // fails unless the folder is empty
  }
  if (descriptor_ >= 0) {
    close(descriptor_);
  }
}

}  // namespace rubber_suspension::io
