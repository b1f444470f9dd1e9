// The work of the library whose time the command `benchmark` takes.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "benchmark/timing.h"

namespace rubber_suspension::benchmark {

struct Work {
  std::string name;
  std::string unit;    ///< what one of `count` is: step, sample, ...
  double count = 1.0;  ///< units of work in one run
  std::function<void()> run;
  Clock clock = Clock::thread;
};

/// Forces of one component, of 1000 and of six directions, and an estimation; logs of so many samples.
std::vector<Work> forces(std::size_t samples);

/// The diagnosis of six logs of that length [s], in one thread and in two, by the clock on the wall.
std::vector<Work> diagnoses(double duration);

/// Diagnoses a log of so many seconds [s] at 1 kHz that is made as it is read, of a component that hides friction, with
/// two threads. Returns JSON: samples, seconds of the clock, the largest resident memory of the process [bytes], and
/// the verdict.
std::string diagnoseLongLog(double duration);

/// One row of the table: median and quartiles over so many runs, after one that is not measured.
std::string row(const Work& work, int runs);

}  // namespace rubber_suspension::benchmark
