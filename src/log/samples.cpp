// Stretches of a log.
#include "log/samples.h"

#include <vector>

namespace rubber_suspension::log {
namespace {

template <class T>
void append(const std::vector<T>& from, std::size_t first, std::size_t count, std::vector<T>& to) {
  if (!from.empty()) {
    const auto begin = from.begin() + static_cast<std::ptrdiff_t>(first);
    to.insert(to.end(), begin, begin + static_cast<std::ptrdiff_t>(count));
  }
}

}  // namespace

void appendSamples(const Log& from, std::size_t first, std::size_t count, Log& to) {
  append(from.stamp, first, count, to.stamp);
  append(from.displacement, first, count, to.displacement);
  append(from.force, first, count, to.force);
  append(from.temperature, first, count, to.temperature);
  append(from.across, first, count, to.across);
  to.units = from.units;
}

Log samplesOf(const Log& log, std::size_t first, std::size_t count) {
  Log result;
  result.name = log.name;
  appendSamples(log, first, count, result);
  return result;
}

}  // namespace rubber_suspension::log
