// Builds the lead-in of an excerpt of a long log: the motion of the component since the previous excerpt.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "rubber_suspension/log/record.h"

namespace rubber_suspension::diagnosis::prepare {

/// Builds the lead-in of a stretch of a log from the samples of the stretch in the order of recording. Each step of the
/// lead-in is the mean of a fixed number of samples. If a step is not much shorter than a cycle, the means lose motion.
/// Each pair of steps is then replaced by its smallest and its largest sample in the order in which they occurred.
/// These extremes preserve the amplitudes but may omit cycles.
class LeadInBuilder {
 public:
  /// Builds the lead-in of samples [first, last) of a log, with `coarse` samples per step; samples at the beginning
  /// that do not fill a step are dropped. Motion with a standard deviation below `standstill` [m] is averaged as noise.
  /// Time steps of the log longer than `longest_step` [ns] are time gaps, whose duration is omitted.
  LeadInBuilder(std::size_t first, std::size_t last, std::size_t coarse, double standstill, std::int64_t longest_step);

  /// Adds a sample. Samples have to be added in the order of recording; samples outside the stretch are ignored.
  void add(std::size_t sample, std::int64_t stamp, double displacement);

  log::LeadIn finish() const;

 private:
  void beginStep(double displacement);
  bool losesMotion() const;

  std::size_t first_;
  std::size_t last_;
  std::size_t coarse_;
  std::size_t steps_;
  double standstill_;
  std::int64_t longest_step_;
  std::int64_t paused_ = 0;  // sum of the time gaps [ns]
  std::int64_t first_stamp_ = 0;
  std::int64_t last_stamp_ = 0;
  double offset_ = 0.0;   // first displacement, which is subtracted before squaring
  double sum_ = 0.0;      // sum of all samples minus offset_
  double squares_ = 0.0;  // sum of the squares of all samples minus offset_
  std::vector<double> means_;
  std::vector<double> extremes_;  // smallest and largest sample of each pair of steps
  double low_ = 0.0;
  double high_ = 0.0;
  bool low_first_ = false;
};

}  // namespace rubber_suspension::diagnosis::prepare
