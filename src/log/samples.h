// Stretches of a log.
#pragma once

#include <cstddef>

#include "rubber_suspension/log/log.h"

namespace rubber_suspension::log {

/// Appends samples [first, first + count) of a log to those of another with the same columns, or with none.
void appendSamples(const Log& from, std::size_t first, std::size_t count, Log& to);

/// These samples under the log's name, without its notes.
Log samplesOf(const Log& log, std::size_t first, std::size_t count);

}  // namespace rubber_suspension::log
