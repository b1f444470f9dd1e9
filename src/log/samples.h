// Stretches of a log.
#pragma once

#include <array>
#include <cstddef>

#include "rubber_suspension/log/log.h"

namespace rubber_suspension::log {

/// Each of them may be empty.
inline constexpr std::array<std::vector<double> Log::*, 4> kChannels = {&Log::displacement, &Log::force,
                                                                        &Log::temperature, &Log::across};

/// Appends samples [first, first + count) of a log to those of another with the same columns, or with none.
inline void appendSamples(const Log& from, std::size_t first, std::size_t count, Log& to) {
  const auto append = [&](const auto& values, auto& end) {
    if (!values.empty()) {
      const auto begin = values.begin() + static_cast<std::ptrdiff_t>(first);
      end.insert(end.end(), begin, begin + static_cast<std::ptrdiff_t>(count));
    }
  };
  append(from.stamp, to.stamp);
  for (const auto channel : kChannels) {
    append(from.*channel, to.*channel);
  }
  to.units = from.units;
}

/// These samples under the log's name, without its notes.
inline Log samplesOf(const Log& log, std::size_t first, std::size_t count) {
  Log result;
  result.name = log.name;
  appendSamples(log, first, count, result);
  return result;
}

}  // namespace rubber_suspension::log
