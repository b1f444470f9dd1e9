// Times of repeated work: the clocks, and the median with its quartiles.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "rubber_suspension/io/figure.h"

namespace rubber_suspension::benchmark {

/// Seconds of the calling thread, so that other programs on the machine do not count, or of the wall.
enum class Clock { thread, wall };

/// Time of a run by the clock [s].
double secondsOf(const std::function<void()>& run, Clock clock);

/// Median and quartiles of repeated measurements, linear between the ranks. The list must not be empty.
io::Spread spreadOf(std::vector<double> values);

/// A time [s] with three digits and a unit from ns to s.
std::string readable(double seconds);

}  // namespace rubber_suspension::benchmark
