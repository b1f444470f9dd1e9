// One piece of work of the library alone, for scripts that time others by turns with it.
#pragma once

#include <string>

namespace rubber_suspension::benchmark {

/// Time `simulate` (the force of a log, median of some runs) or `fit` (of the only component of the file to the log,
/// from one start), in seconds of the thread. Returns JSON: seconds, and of a fit its cost, the sum of squared
/// residuals [N^2]. Throws ComponentFileError, LogError and std::invalid_argument.
std::string singleWork(const std::string& work, const std::string& component_file, const std::string& log);

/// Diagnoses a log of so many seconds [s] at 1 kHz that is made as it is read, of a component that hides friction, with
/// two threads. Returns JSON: samples, seconds of the clock, the largest resident memory of the process [bytes], and
/// the verdict.
std::string diagnoseLongLog(double duration);

}  // namespace rubber_suspension::benchmark
