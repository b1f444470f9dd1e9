// Fuzz target: any bytes of a bag are refused with a LogError, or read as a valid log.
#include "bag/bag_log.h"
#include "fuzz/memory_file.h"
#include "fuzz/valid_log.h"

using namespace rubber_suspension;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const fuzz::MemoryFile file(data, size);
  fuzz::requireValidLogOrError([&] { return bag::readBagLog(file.path()); });
  return 0;
}
