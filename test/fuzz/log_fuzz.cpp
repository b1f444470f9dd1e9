// Fuzz target: whatever bytes are given as a CSV log are refused by LogError or taken; what is taken is a valid log.
#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "rubber_suspension/io/log.h"

namespace {

/// A file in memory with the given content, gone when this is.
class MemoryFile {
 public:
  MemoryFile(const std::uint8_t* data, std::size_t size) : descriptor_(memfd_create("log.csv", 0)) {
    if (descriptor_ < 0 || write(descriptor_, data, size) != static_cast<ssize_t>(size)) {
      std::abort();
    }
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() { close(descriptor_); }

  std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const MemoryFile file(data, size);
  try {
    const rubber_suspension::Log log = rubber_suspension::readCsvLog(file.path());
    try {
      rubber_suspension::checkLog(log);
    } catch (const rubber_suspension::LogError& error) {
      std::fprintf(stderr, "violated: a log that was read is valid: %s\n", error.what());
      std::abort();
    }
  } catch (const rubber_suspension::LogError& error) {
    if (std::string(error.what()).find('\n') != std::string::npos) {
      std::fprintf(stderr, "violated: an error is one line: %s\n", error.what());
      std::abort();
    }
  }
  return 0;
}
