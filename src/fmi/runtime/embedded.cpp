// The block of the component: empty until the exporter writes to it, or filled where an FMU is built from its sources.
#include "fmi/runtime/embedded.h"

#include <algorithm>

#ifdef RUBBER_SUSPENSION_BUILT_IN
#include "component_text.h"
#else
#define RUBBER_SUSPENSION_COMPONENT_TEXT ""
#endif

namespace rubber_suspension::fmi {

static_assert(sizeof(RUBBER_SUSPENSION_COMPONENT_TEXT) <= kCapacity, "more text than the block holds");

std::string embeddedText() {
  // Volatile: what the compiler sees here is not what the binary will hold. Not constant: so it lies in a section that
  // the file holds as it is.
  static volatile EmbeddedBlock block = {RUBBER_SUSPENSION_BLOCK_MARKER, sizeof(RUBBER_SUSPENSION_COMPONENT_TEXT) - 1,
                                         RUBBER_SUSPENSION_COMPONENT_TEXT};
  const std::uint64_t written = block.size;
  return {block.text, block.text + std::min<std::uint64_t>(written, kCapacity)};
}

}  // namespace rubber_suspension::fmi
