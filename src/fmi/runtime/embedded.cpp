// The block of the component: empty until the exporter writes to it, or filled where an FMU is built from its sources.
#include "fmi/runtime/embedded.h"

#include <algorithm>

#ifdef RUBBER_SUSPENSION_BUILT_IN
#include "component_text.h"
#else
#define RUBBER_SUSPENSION_COMPONENT_TEXT ""
#endif

namespace rubber_suspension::fmi {
namespace {

static_assert(sizeof(RUBBER_SUSPENSION_COMPONENT_TEXT) <= kCapacity, "more text than the block holds");

// Volatile: what the compiler sees here is not what the binary will hold. Not constant: so it lies in a section that
// the file holds as it is.
volatile EmbeddedBlock block = {RUBBER_SUSPENSION_BLOCK_MARKER, sizeof(RUBBER_SUSPENSION_COMPONENT_TEXT) - 1,
                                RUBBER_SUSPENSION_COMPONENT_TEXT};

}  // namespace

std::string embeddedText() {
  const std::uint64_t written = block.size;
  const std::size_t size = std::min<std::size_t>(written, kCapacity);
  std::string text(size, '\0');
  for (std::size_t i = 0; i < size; ++i) {
    text[i] = block.text[i];
  }
  return text;
}

}  // namespace rubber_suspension::fmi
