// Fuzz target: any text of a state file is refused in one line, or read. What is read can be written and read back.
#include <cstdint>
#include <cstdlib>
#include <string>

#include "node/state_file.h"

using namespace rubber_suspension::node;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::vector<SavedState> states;
  try {
    states = parseStates(std::string(data, data + size), "fuzz.json");
  } catch (const FileError& error) {
    if (std::string(error.what()).find('\n') != std::string::npos) {
      std::abort();
    }
    return 0;
  }
  const std::string text = stateText(states);
  if (stateText(parseStates(text, "again.json")) != text) {
    std::abort();
  }
  return 0;
}
