// Fuzz target: whatever bytes are given as a CSV log are refused by LogError or taken; what is taken is a valid log.
#include "fuzz/memory_file.h"
#include "fuzz/valid_log.h"

using namespace rubber_suspension;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const fuzz::MemoryFile file(data, size);
  fuzz::requireValidLogOrError([&] { return log::readCsvLog(file.path()); });
  return 0;
}
