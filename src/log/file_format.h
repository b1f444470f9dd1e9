// The format of a file, by its first bytes, and the program that makes a readable file of one without a reader here.
#pragma once

#include <cstddef>
#include <string>

namespace rubber_suspension::log {

enum class FileFormat { text, gzip, bag, matlab, hdf5, rpc, foreign };

/// The number of first bytes that tell the format.
constexpr std::size_t kFormatHead = 256;

FileFormat formatOf(const std::string& head);

/// True for what is neither a folder nor a pipe nor a device.
bool isRegularFile(const std::string& path);

/// The format of a regular file; text where it is none or cannot be read. MATLAB's level 4 has no mark: it goes by
/// .mat.
FileFormat formatOfFile(const std::string& path);

/// Throws std::runtime_error for the head of a known foreign format, with its name and a command that makes a readable
/// file.
void refuseForeignFormat(const std::string& head);

/// Refuses what claims far more memory or time than it has bytes itself, unless the user says that it is large. Throws
/// std::runtime_error. `packed`: bytes read so far; `size`: those of the whole file, for the error, where they are
/// known.
void refuseUnpacked(std::size_t unpacked, std::size_t packed, bool large, std::size_t size = 0);

}  // namespace rubber_suspension::log
