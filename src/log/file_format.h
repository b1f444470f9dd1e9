// The format of a file, by its first bytes, and how to convert a file of a format that has no reader here.
#pragma once

#include <cstddef>
#include <string>

namespace rubber_suspension::log {

enum class FileFormat { text, gzip, bag, matlab, hdf5, rpc, foreign };

/// Number of first bytes that determine the format.
constexpr std::size_t kFormatHead = 256;

FileFormat formatOf(const std::string& head);

/// Returns true for a path that is neither a folder nor a pipe nor a device.
bool isRegularFile(const std::string& path);

/// Returns the format of a file, text if it is not regular or cannot be read. MATLAB's level 4 has no mark and is
/// recognised by the extension .mat.
FileFormat formatOfFile(const std::string& path);

/// Throws std::runtime_error for the head of a known format other than text, with its name and how to convert it.
void refuseForeignFormat(const std::string& head);

/// Throws std::runtime_error for data that expand to far more than their own bytes, unless the user states that they
/// are large. `packed`: bytes read so far; `size`: bytes of the whole file, for the error, if known.
void refuseUnpacked(std::size_t unpacked, std::size_t packed, bool large, std::size_t size = 0);

}  // namespace rubber_suspension::log
