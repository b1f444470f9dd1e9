// Even time steps of a log that is read block by block, or as a whole.
#include "log/even_blocks.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "log/samples.h"

namespace rubber_suspension::log {
namespace {

constexpr double kJitterAllowed = 0.02;      // of the median step; more is resampled
constexpr std::size_t kMostCounted = 16384;  // different steps

double seconds(std::int64_t nanoseconds) { return static_cast<double>(nanoseconds) * 1e-9; }

}  // namespace

EvenSteps evenStepsFor(double median, double largest_difference, double duration, std::size_t samples) {
  if (largest_difference <= kJitterAllowed * median) {
    return {duration / static_cast<double>(samples - 1), samples, true};
  }
  return {median, static_cast<std::size_t>(std::floor(duration / median)) + 1, false};
}

void TimeSteps::count(std::int64_t step) {
  ++counts_[step / width_];
  if (counts_.size() > kMostCounted) {
    widen();
  }
}

void TimeSteps::widen() {
  std::unordered_map<std::int64_t, std::uint64_t> wider;
  width_ *= 2;
  for (const auto& [step, number] : counts_) {
    wider[step / 2] += number;
  }
  counts_ = std::move(wider);
}

void TimeSteps::add(const Log& block) {
  for (const std::int64_t stamp : block.stamp) {
    if (samples_ == 0) {
      first_ = stamp;
    } else {
      const std::int64_t step = stamp - last_;
      smallest_ = samples_ == 1 ? step : std::min(smallest_, step);
      largest_ = std::max(largest_, step);
      count(step);
    }
    last_ = stamp;
    ++samples_;
  }
}

double TimeSteps::median() const {
  std::vector<std::pair<std::int64_t, std::uint64_t>> ascending(counts_.begin(), counts_.end());
  std::sort(ascending.begin(), ascending.end());
  const std::uint64_t middle = (samples_ - 1) / 2;
  std::uint64_t before = 0;
  auto found = ascending.begin();
  while (before + found->second <= middle) {
    before += found->second;
    ++found;
  }
  return seconds(found->first * width_ + width_ / 2);
}

EvenSteps TimeSteps::evenSteps() const {
  const double step = median();
  const double duration = seconds(last_ - first_);
  const double worst = std::max(std::abs(seconds(smallest_) - step), std::abs(seconds(largest_) - step));
  return evenStepsFor(step, worst, duration, samples_);
}

void EvenBlocks::keepLast(const Log& block) { last_ = samplesOf(block, block.size() - 1, 1); }

EvenBlocks::Piece EvenBlocks::interpolated() const {
  return {even_.displacement.size(), even_.displacement.data(), even_.force.data(),
          even_.temperature.empty() ? nullptr : even_.temperature.data()};
}

EvenBlocks::Piece EvenBlocks::add(const Log& block) {
  if (steps_.as_recorded) {
    return {block.size(), block.displacement.data(), block.force.data(),
            block.temperature.empty() ? nullptr : block.temperature.data()};
  }
  even_ = Log();
  first_stamp_ = seen_ == 0 ? block.stamp.front() : first_stamp_;
  const auto keep = [&](const Log& left, std::size_t l, std::size_t right, double share) {
    even_.displacement.push_back((1.0 - share) * left.displacement[l] + share * block.displacement[right]);
    even_.force.push_back((1.0 - share) * left.force[l] + share * block.force[right]);
    if (!block.temperature.empty()) {
      even_.temperature.push_back((1.0 - share) * left.temperature[l] + share * block.temperature[right]);
    }
  };
  for (std::size_t i = seen_ == 0 ? 1 : 0; i < block.size(); ++i) {
    const Log& left = i == 0 ? last_ : block;
    const std::size_t l = i == 0 ? 0 : i - 1;
    const double from = seconds(left.stamp[l] - first_stamp_);
    const double until = seconds(block.stamp[i] - first_stamp_);
    for (; done_ < steps_.samples && static_cast<double>(done_) * steps_.dt <= until; ++done_) {
      keep(left, l, i, std::clamp((static_cast<double>(done_) * steps_.dt - from) / (until - from), 0.0, 1.0));
    }
  }
  seen_ += block.size();
  keepLast(block);
  return interpolated();
}

EvenBlocks::Piece EvenBlocks::finish() {
  even_ = Log();
  if (!steps_.as_recorded) {
    for (; done_ < steps_.samples; ++done_) {
      appendSamples(last_, 0, 1, even_);
    }
  }
  return interpolated();
}

}  // namespace rubber_suspension::log
