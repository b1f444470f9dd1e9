// A log read from text, block by block.
#pragma once

#include <string>
#include <vector>

#include "rubber_suspension/log/log_source.h"

namespace rubber_suspension::log {

/// As readCsvLog(), of any number of rows, handing out blocks of kLogBlock samples; the notes. Throws LogError, and
/// what `take` throws.
std::vector<std::string> readCsvBlocks(const std::string& path, const LogFormat& format, const LogSource::Take& take);

}  // namespace rubber_suspension::log
