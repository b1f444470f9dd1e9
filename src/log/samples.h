// Functions on the samples and channels of a log.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "rubber_suspension/log/log.h"
#include "rubber_suspension/log/log_source.h"

namespace rubber_suspension::log {

/// The channels of a log with values per sample. Each of them may be empty.
inline constexpr std::array<std::vector<double> Log::*, 4> kChannels = {&Log::displacement, &Log::force,
                                                                        &Log::temperature, &Log::across};

inline bool isCounted(const Log& log, std::size_t i) { return log.counts.empty() || log.counts[i] > 0.0; }

/// Appends the samples [first, first + count) of a log to another log, which has the same channels or is empty.
inline void appendSamples(const Log& from, std::size_t first, std::size_t count, Log& to) {
  if (!from.counts.empty() && to.counts.empty()) {
    to.counts.assign(to.size(), 1.0);
  }
  const auto append = [&](const auto& values, auto& end) {
    if (!values.empty()) {
      const auto begin = values.begin() + static_cast<std::ptrdiff_t>(first);
      end.insert(end.end(), begin, begin + static_cast<std::ptrdiff_t>(count));
    }
  };
  append(from.counts, to.counts);
  append(from.stamp, to.stamp);
  for (const auto channel : kChannels) {
    append(from.*channel, to.*channel);
  }
  if (!to.counts.empty()) {
    to.counts.resize(to.size(), 1.0);
  }
  to.units = from.units;
}

/// Returns the samples [first, first + count) as a log of the same name, without notes.
inline Log samplesOf(const Log& log, std::size_t first, std::size_t count) {
  Log result;
  result.name = log.name;
  appendSamples(log, first, count, result);
  return result;
}

/// Passes the samples to `take` in blocks of at most `block` samples. `first` is the index of the first sample in the
/// whole log and is advanced. Returns false as soon as `take` returns false.
inline bool handOutBlocks(const Log& log, std::size_t block, const LogSource::Take& take, std::size_t& first) {
  bool more = true;
  for (std::size_t done = 0; more && done < log.size(); done += block) {
    const std::size_t count = std::min(block, log.size() - done);
    more = count == log.size() ? take(log, first) : take(samplesOf(log, done, count), first);
    first += count;
  }
  return more;
}

}  // namespace rubber_suspension::log
