// Builds the lead-in of an excerpt of a long log.
#include "diagnosis/prepare/lead_in.h"

#include <cmath>

namespace rubber_suspension::diagnosis::prepare {
namespace {

// Largest accepted share of the variance that averaging may lose. Means over a tenth of a cycle lose 1.6 % of the
// amplitude of a sine, and therefore 3.2 % of its variance.
constexpr double kMostLost = 0.032;

double varianceOf(double sum, double squares, double count) { return squares / count - (sum / count) * (sum / count); }

}  // namespace

LeadInBuilder::LeadInBuilder(std::size_t first, std::size_t last, std::size_t coarse, double standstill,
                             std::int64_t longest_step)
    : first_(first + (last - first) % coarse),
      last_(last),
      coarse_(coarse),
      steps_((last - first) / coarse),
      standstill_(standstill),
      longest_step_(longest_step) {
  means_.reserve(steps_);
  extremes_.reserve(steps_ + 1);
}

// Steps form pairs that are counted from the last step, so that the first step may be single.
void LeadInBuilder::beginStep(double displacement) {
  const bool first_of_pair = (steps_ - means_.size()) % 2 == 0 || means_.empty();
  means_.push_back(0.0);
  if (first_of_pair) {
    low_ = high_ = displacement;
    low_first_ = false;
  }
}

void LeadInBuilder::add(std::size_t sample, std::int64_t stamp, double displacement) {
  if (sample < first_ || sample >= last_) {
    return;
  }
  if (sample == first_) {
    first_stamp_ = stamp;
    offset_ = displacement;
  }
  paused_ += sample > first_ && stamp - last_stamp_ > longest_step_ ? stamp - last_stamp_ : 0;
  last_stamp_ = stamp;
  if ((sample - first_) % coarse_ == 0) {
    beginStep(displacement);
  }
  const double z = displacement - offset_;
  sum_ += z;
  squares_ += z * z;
  means_.back() += displacement / static_cast<double>(coarse_);
  if (displacement < low_) {
    low_ = displacement;
    low_first_ = false;
  } else if (displacement > high_) {
    high_ = displacement;
    low_first_ = true;
  }
  if ((sample + 1 - first_) % coarse_ == 0 && (steps_ - means_.size()) % 2 == 0) {
    if (means_.size() == 1) {
      extremes_.push_back(means_.front());
    } else {
      extremes_.push_back(low_first_ ? low_ : high_);
      extremes_.push_back(low_first_ ? high_ : low_);
    }
  }
}

bool LeadInBuilder::losesMotion() const {
  double sum = 0.0;
  double squares = 0.0;
  for (const double mean : means_) {
    sum += mean - offset_;
    squares += (mean - offset_) * (mean - offset_);
  }
  const auto steps = static_cast<double>(steps_);
  const double all = varianceOf(sum_, squares_, steps * static_cast<double>(coarse_));
  return all > standstill_ * standstill_ && varianceOf(sum, squares, steps) < (1.0 - kMostLost) * all;
}

log::LeadIn LeadInBuilder::finish() const {
  log::LeadIn result;
  const std::size_t samples = steps_ * coarse_;
  if (samples > 1) {
    result.dt = static_cast<double>(last_stamp_ - first_stamp_ - paused_) * 1e-9 / static_cast<double>(samples - 1) *
                static_cast<double>(coarse_);
  }
  result.displacement = losesMotion() ? extremes_ : means_;
  return result;
}

}  // namespace rubber_suspension::diagnosis::prepare
