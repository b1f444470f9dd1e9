// A diagnosis of a log of any length, which is made as it is read: how long it takes, and how much memory.
#pragma once

#include <string>

namespace rubber_suspension::benchmark {

/// Diagnoses a log of so many seconds [s] at 1 kHz, of a component that hides friction, with two threads. Returns JSON:
/// samples, seconds of the clock, the largest resident memory of the process [bytes], and the verdict.
std::string diagnoseLongLog(double duration);

}  // namespace rubber_suspension::benchmark
