// The place in the binary of an FMU where the exporter writes the component.
#pragma once

#include <cstddef>
#include <cstdint>

/// Marks the beginning of the block; occurs once in the binary.
#define RUBBER_SUSPENSION_BLOCK_MARKER "rubber_suspension:component:001"

namespace rubber_suspension::fmi {

constexpr std::size_t kCapacity = 1024 * 1024;

/// Marker, size of the text, and text, with the same layout in the file and in memory. The operating system maps the
/// block together with the code. So the binary opens no file, and an importer may put it in any folder.
struct EmbeddedBlock {
  char marker[sizeof(RUBBER_SUSPENSION_BLOCK_MARKER)];
  std::uint64_t size;  // size of the text [bytes]
  char text[kCapacity];
};

}  // namespace rubber_suspension::fmi
