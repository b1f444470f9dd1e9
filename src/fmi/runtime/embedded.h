// The place in the binary of an FMU where the exporter writes the component.
#pragma once

#include <cstddef>
#include <cstdint>

/// Begins the block; once in the whole binary.
#define RUBBER_SUSPENSION_BLOCK_MARKER "rubber_suspension:component:001"

namespace rubber_suspension::fmi {

/// Bytes of text that fit.
constexpr std::size_t kCapacity = 1024 * 1024;

/// Marker, size of the text and text, one after the other, in the file as in memory. The loader of the operating system
/// maps them together with the code: there is nothing to open, wherever an importer puts the binary.
struct EmbeddedBlock {
  char marker[sizeof(RUBBER_SUSPENSION_BLOCK_MARKER)];
  std::uint64_t size;  // of the text [bytes]
  char text[kCapacity];
};

}  // namespace rubber_suspension::fmi
