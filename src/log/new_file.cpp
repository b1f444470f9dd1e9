// Writes a file under a temporary name and renames it when it is complete.
#include "log/new_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <random>

#include "rubber_suspension/log/log.h"

namespace rubber_suspension::log {
namespace {

// Paths that a signal handler has to remove. A handler may neither lock a mutex nor allocate memory, so whoever takes a
// path out of its slot by an atomic exchange owns it.
using Slot = std::atomic<const std::string*>;
std::array<Slot, 64> slots = {};

extern "C" void removeUnfinishedFiles(int signal) {
  std::array<const std::string*, slots.size()> paths = {};
  std::transform(slots.begin(), slots.end(), paths.begin(), [](Slot& slot) { return slot.exchange(nullptr); });
  for (const auto remove : {unlink, rmdir}) {  // unlink() comes first, so that rmdir() then finds empty folders
    for (const std::string* path : paths) {
      if (path != nullptr) {
        remove(path->c_str());
      }
    }
  }
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

// Installs the handler for each signal for which the program has none. For example, roscpp handles SIGINT itself.
void watchSignals() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGXFSZ}) {
    struct sigaction action{};
    sigaction(signal, nullptr, &action);
    if (action.sa_handler == SIG_DFL) {
      // If SIGXFSZ is ignored, a file that exceeds its size limit causes an ordinary write error.
      action.sa_handler = signal == SIGXFSZ ? SIG_IGN : removeUnfinishedFiles;
      sigaction(signal, &action, nullptr);
    }
  }
}

[[noreturn]] void fail(const std::string& path, int error) {
  throw LogError(fmt::format("{}: cannot be written: {}", path, std::strerror(error == 0 ? EIO : error)));
}

// Returns a path in the folder of the target with a random hidden name. The name is short enough for any file system
// and keeps the extension, because a writer may choose the format by it.
std::string nameBeside(const std::filesystem::path& target) {
  constexpr std::size_t kLongest = 100;
  std::random_device random;
  const std::string name = fmt::format(".{}.{:08x}{:08x}{}", target.stem().string().substr(0, kLongest), random(),
                                       random(), target.extension().string().substr(0, kLongest));
  return (target.parent_path() / name).string();
}

// Flushes a file or folder to the disk. Returns false and sets errno on failure, but not if fsync is unsupported.
bool sync(const std::string& path) {
  const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) {
    return false;
  }
  const bool synced = fsync(descriptor) == 0 || errno == EINVAL;
  const int error = errno;
  close(descriptor);
  errno = error;
  return synced;
}

}  // namespace

RemovedBySignal::RemovedBySignal(const std::string& path) {
  watchSignals();
  auto copy = std::make_unique<const std::string>(path);
  for (Slot& slot : slots) {
    const std::string* none = nullptr;
    if (slot.compare_exchange_strong(none, copy.get())) {
      slot_ = &slot;
      static_cast<void>(copy.release());
      return;
    }
  }
}

RemovedBySignal::~RemovedBySignal() {
  if (slot_ != nullptr) {
    delete slot_->exchange(nullptr);
  }
}

bool isStream(const std::string& path) {
  struct stat status{};
  const bool special = stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
  return special || path.compare(0, 5, "/dev/") == 0 || path.compare(0, 6, "/proc/") == 0;
}

std::string followedPath(const std::string& path) {
  constexpr int kMostLinks = 40;  // the limit of the Linux kernel
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
  struct stat status{};
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
  writing_path_ = nameBeside(target_);
  removal_.emplace(writing_path_);  // registered before the file exists, because a signal may arrive at any time
  const int descriptor = open(writing_path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, exists ? 0600 : 0666);
  if (descriptor < 0) {
    fail(path, errno);
  }
  if (exists) {
    fchmod(descriptor, status.st_mode & 07777U);  // may fail without harm on a file system without permissions
  }
  close(descriptor);
}

NewFile::~NewFile() {
  if (removal_) {
    unlink(writing_path_.c_str());
  }
}

std::ofstream& NewFile::stream() {
  if (!stream_.is_open()) {
    errno = 0;
    stream_.open(writing_path_, std::ios::binary);
  }
  return stream_;
}

void NewFile::requireStream() const {
  if (!stream_) {
    fail(path_, errno);
  }
}

void NewFile::line(std::string_view text) {
  stream() << text << '\n';
  requireStream();
}

void NewFile::write(const std::string& content) {
  stream() << content << std::flush;
  requireStream();
}

void NewFile::commit() {
  if (stream_.is_open()) {
    stream_.close();
    requireStream();
  }
  if (removal_) {
    if (!sync(writing_path_) || std::rename(writing_path_.c_str(), target_.c_str()) != 0) {
      fail(path_, errno);
    }
    removal_.reset();
    sync(std::filesystem::path(target_).parent_path().string());  // may fail, since the file is already renamed
  }
}

void writeNewFile(const std::string& path, const std::string& content) {
  NewFile file(path);
  file.write(content);
  file.commit();
}

}  // namespace rubber_suspension::log
