// Recognises the format of a file by its first bytes, and states how to convert formats without a reader.
#pragma once

#include <cstddef>
#include <string>

namespace rubber_suspension::log {

enum class FileFormat { text, gzip, bag, matlab, hdf5, rpc, foreign };

/// Number of first bytes from which the format is determined.
constexpr std::size_t kFormatHead = 256;

FileFormat formatOf(const std::string& head);

/// Returns true if the path refers to a file, and not to a folder, a pipe or a device.
bool isRegularFile(const std::string& path);

/// Returns the format of a file; text if the path is not a regular file or cannot be read. A path that ends in .mat is
/// taken as MATLAB if no other format is recognised, because level 4 of MATLAB has no signature.
FileFormat formatOfFile(const std::string& path);

/// Throws std::runtime_error, which states how to convert the file, if the head is that of a known format except text.
void refuseForeignFormat(const std::string& head);

/// Throws std::runtime_error if more than 64 MiB are unpacked and these are more than a hundred times the `packed`
/// bytes read so far, unless `large` is true. `size` is the size of the whole file for the error, or 0 if unknown.
void refuseUnpacked(std::size_t unpacked, std::size_t packed, bool large, std::size_t size = 0);

}  // namespace rubber_suspension::log
