// Times of repeated work: clocks, median and quartiles.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "rubber_suspension/io/figure.h"

namespace rubber_suspension::benchmark {

/// Kinds of clock: the CPU time of the calling thread, which excludes other programs, or the wall clock.
enum class Clock { thread, wall };

/// Returns the time of a run by the clock [s].
double secondsOf(const std::function<void()>& run, Clock clock);

/// Returns median and quartiles of repeated measurements, interpolated between the ranks. The list must not be empty.
io::Spread spreadOf(std::vector<double> values);

/// Returns a time [s] as text with three digits and a unit from ns to s.
std::string readable(double seconds);

}  // namespace rubber_suspension::benchmark
