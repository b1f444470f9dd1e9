// Units of work of the library, whose duration the command `benchmark` measures.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "benchmark/timing.h"

namespace rubber_suspension::benchmark {

struct Work {
  std::string name;
  std::string unit;    ///< what is counted: step, sample, ...
  double count = 1.0;  ///< number of these units in one run
  std::function<void()> run;
  Clock clock = Clock::thread;
};

/// Returns an estimation, and simulations of one component, of 1000 components and of a bush of six directions.
std::vector<Work> forces(std::size_t samples);

/// Returns two diagnoses of six logs of this duration [s], in one thread and in two threads, timed by the wall clock.
std::vector<Work> diagnoses(double duration);

/// Diagnoses a log of this duration [s] at 1 kHz with two threads. The log is generated while it is read, for a test
/// piece with friction that its description lacks. Returns JSON with the number of samples, the seconds of the wall
/// clock, the largest resident memory of the process [bytes] and the verdict.
std::string diagnoseLongLog(double duration);

/// Returns one row of the table: median and quartiles of `runs` runs, which follow one run that is not measured.
std::string row(const Work& work, int runs);

}  // namespace rubber_suspension::benchmark
