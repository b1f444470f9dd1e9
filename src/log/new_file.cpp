// A file that is written beside the one that it replaces and takes its name when it is complete.
#include "log/new_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <random>

namespace rubber_suspension::log {
namespace {

// Names of the files that a signal removes: a signal handler may neither lock nor take memory, so the names stand in
// fixed places.
constexpr int kSlots = 64;
struct Slot {
  std::atomic<bool> used{false};
  std::atomic<bool> filled{false};
  char path[PATH_MAX] = {};
};
Slot slots[kSlots];

extern "C" void removeUnfinishedFiles(int signal) {
  for (const auto remove : {unlink, rmdir}) {  // files first, then the folders that are empty without them
    for (Slot& slot : slots) {
      if (slot.filled.load()) {
        remove(slot.path);
      }
    }
  }
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

// Only where the program has no handler of its own: roscpp ends its programs in order on SIGINT.
void watchSignals() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGXFSZ}) {
    struct sigaction action {};
    sigaction(signal, nullptr, &action);
    if (action.sa_handler == SIG_DFL) {
      // A file beyond the limit of its size is an error of writing like others.
      action.sa_handler = signal == SIGXFSZ ? SIG_IGN : removeUnfinishedFiles;
      sigaction(signal, &action, nullptr);
    }
  }
}

// A slot that names the path; -1 where all are taken or the path does not fit: then a signal leaves the file.
int takeSlot(const std::string& path) {
  for (int i = 0; i < kSlots && path.size() < sizeof slots[0].path; ++i) {
    bool used = false;
    if (slots[i].used.compare_exchange_strong(used, true)) {
      std::memcpy(slots[i].path, path.c_str(), path.size() + 1);
      slots[i].filled.store(true);
      return i;
    }
  }
  return -1;
}

void freeSlot(int i) {
  if (i >= 0) {
    slots[i].filled.store(false);
    slots[i].used.store(false);
  }
}

[[noreturn]] void fail(const std::string& path, int error) {
  throw std::runtime_error(fmt::format("{}: cannot be written: {}", path, std::strerror(error)));
}

// Hidden, short enough for any file system, with the extension, by which some programs choose a format; random.
std::string nameBeside(const std::filesystem::path& target) {
  constexpr std::size_t kLongest = 100;
  const std::string letters = "abcdefghijklmnopqrstuvwxyz0123456789";
  std::random_device random;
  std::uniform_int_distribution<std::size_t> place(0, letters.size() - 1);
  std::string mark(8, ' ');
  std::generate(mark.begin(), mark.end(), [&] { return letters[place(random)]; });
  return (target.parent_path() / ("." + target.stem().string().substr(0, kLongest) + "." + mark +
                                  target.extension().string().substr(0, kLongest)))
      .string();
}

// The permissions of a new file (umask), which can only be read by setting them.
int permissionsOfNewFiles() {
  static std::mutex mutex;
  const std::lock_guard<std::mutex> lock(mutex);
  const mode_t mask = umask(0);
  umask(mask);
  return 0666 & ~static_cast<int>(mask);
}

void syncFolder(const std::string& folder) {
  const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor >= 0) {
    fsync(descriptor);  // some file systems cannot; the rename stands nevertheless
    close(descriptor);
  }
}

}  // namespace

bool isStream(const std::string& path) {
  struct stat status {};
  const bool special = stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
  return special || path.compare(0, 5, "/dev/") == 0 || path.compare(0, 6, "/proc/") == 0;
}

std::string followedPath(const std::string& path) {
  constexpr int kMostLinks = 40;  // as the kernel follows
  namespace fs = std::filesystem;
  std::error_code error;
  fs::path result = fs::absolute(path, error);
  for (int i = 0; i < kMostLinks && fs::is_symlink(fs::symlink_status(result, error)); ++i) {
    result = result.parent_path() / fs::read_symlink(result, error);
  }
  const fs::path canonical = fs::weakly_canonical(result, error);
  return error ? result.string() : canonical.string();
}

NewFile::NewFile(const std::string& path) : path_(path), target_(followedPath(path)) {
  struct stat status {};
  const bool exists = stat(path.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) {
    fail(path, EISDIR);
  }
  if (isStream(path)) {
    writing_path_ = path;
    return;
  }
  if (exists && access(path.c_str(), W_OK) != 0) {
    fail(path, errno);
  }
  createBeside(exists ? static_cast<int>(status.st_mode & 07777) : permissionsOfNewFiles());
}

void NewFile::createBeside(int permissions) {
  constexpr int kAttempts = 100;
  watchSignals();
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    writing_path_ = nameBeside(target_);
    slot_ = takeSlot(writing_path_);  // before the file is there: a signal may come at any time
    const int descriptor = open(writing_path_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, S_IRUSR | S_IWUSR);
    const int error = errno;
    if (descriptor >= 0) {
      fchmod(descriptor, static_cast<mode_t>(permissions));  // a file system without permissions has none to set
      close(descriptor);
      return;
    }
    freeSlot(slot_);
    slot_ = -1;
    writing_path_.clear();
    if (error != EEXIST) {
      fail(path_, error);
    }
  }
  fail(path_, EEXIST);
}

NewFile::~NewFile() { discard(); }

void NewFile::discard() {
  if (!writing_path_.empty() && writing_path_ != path_) {
    unlink(writing_path_.c_str());
  }
  freeSlot(slot_);
  slot_ = -1;
  writing_path_.clear();
}

void NewFile::write(const std::string& content) const {
  errno = 0;
  std::ofstream stream(writing_path_, std::ios::binary);
  stream << content;
  stream.close();
  if (!stream) {
    fail(path_, errno == 0 ? EIO : errno);
  }
}

void NewFile::commit() {
  if (writing_path_ != path_) {
    const int descriptor = open(writing_path_.c_str(), O_RDONLY | O_CLOEXEC);
    const bool synced = descriptor >= 0 && (fsync(descriptor) == 0 || errno == EINVAL);
    const int error = errno;
    if (descriptor >= 0) {
      close(descriptor);
    }
    if (!synced) {
      fail(path_, error);
    }
    if (std::rename(writing_path_.c_str(), target_.c_str()) != 0) {
      fail(path_, errno);
    }
    syncFolder(std::filesystem::path(target_).parent_path().string());
  }
  freeSlot(slot_);
  slot_ = -1;
  writing_path_.clear();
}

RemovedBySignal::RemovedBySignal(const std::string& folder) {
  watchSignals();
  slot_ = takeSlot(followedPath(folder));
}

RemovedBySignal::~RemovedBySignal() { freeSlot(slot_); }

void writeNewFile(const std::string& path, const std::string& content) {
  NewFile file(path);
  file.write(content);
  file.commit();
}

}  // namespace rubber_suspension::log
