// A log read from HDF5, block by block.
#pragma once

#include <string>
#include <vector>

#include "rubber_suspension/log/log_source.h"

namespace rubber_suspension::log {

/// As readHdf5Log(), of any number of samples, handing out blocks of kLogBlock; the notes. No other thread reads a file
/// of HDF5 meanwhile, and `take` must not. Throws LogError, and what `take` throws.
std::vector<std::string> readHdf5Blocks(const std::string& path, const LogFormat& format, const LogSource::Take& take);

}  // namespace rubber_suspension::log
