// Even time steps of a log that is read block by block, or as a whole.
#include "log/even_blocks.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "log/samples.h"

namespace rubber_suspension::log {
namespace {

constexpr double kJitterAllowed = 0.02;      // share of the median step by which a step may differ without resampling
constexpr std::size_t kMostCounted = 16384;  // largest number of different steps that are counted
constexpr double kLongestStep = 0.5;         // [s]; a shorter step is no time gap, because the node bridges it, too
constexpr std::int64_t kGapFactor = 20;      // a time gap is longer than the 90th percentile of the steps times this
constexpr double kMostGrowth = 2.0;          // largest number of even samples per sample of the log
constexpr double kFewSamples = 20000.0;      // number of even samples that is allowed for any log, such as a creep test

double seconds(std::int64_t nanoseconds) { return static_cast<double>(nanoseconds) * 1e-9; }

EvenBlocks::Piece pieceOf(double gap, const Log& log) {
  const auto begin = [](const std::vector<double>& values) { return values.empty() ? nullptr : values.data(); };
  return {gap,
          log.displacement.size(),
          begin(log.displacement),
          begin(log.force),
          begin(log.temperature),
          begin(log.across),
          begin(log.counts)};
}

}  // namespace

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

std::vector<std::pair<std::int64_t, std::uint64_t>> TimeSteps::ascending() const {
  std::vector<std::pair<std::int64_t, std::uint64_t>> steps(counts_.begin(), counts_.end());
  std::sort(steps.begin(), steps.end());
  for (auto& [step, number] : steps) {
    step = step * width_ + width_ / 2;
  }
  return steps;
}

EvenSteps TimeSteps::evenSteps() const {
  const auto steps = ascending();
  const auto at = [&steps](std::uint64_t place) {
    auto found = steps.begin();
    for (std::uint64_t before = 0; before + found->second <= place; ++found) {
      before += found->second;
    }
    return found->first;
  };
  EvenSteps even;
  even.median = seconds(at((samples_ - 1) / 2));
  const std::int64_t most = std::numeric_limits<std::int64_t>::max() / kGapFactor;
  even.longest_step =
      std::max(static_cast<std::int64_t>(kLongestStep * 1e9), kGapFactor * std::min(at((samples_ - 1) * 9 / 10), most));
  std::int64_t in_gaps = 0;
  std::int64_t largest = largest_;
  for (const auto& [step, number] : steps) {
    if (step > even.longest_step) {
      in_gaps += step * static_cast<std::int64_t>(number);
      even.gaps += number;
    } else if (largest_ > even.longest_step) {
      largest = step;
    }
  }
  even.duration = seconds(last_ - first_ - in_gaps);
  const bool slow = std::abs(seconds(largest) - even.median) > std::abs(seconds(smallest_) - even.median);
  even.worst = seconds(slow ? largest : smallest_);
  even.as_recorded = even.gaps == 0 && std::abs(even.worst - even.median) <= kJitterAllowed * even.median;
  if (even.as_recorded) {
    even.dt = even.duration / static_cast<double>(samples_ - 1);
    even.samples = samples_;
    return even;
  }
  even.dt = std::max(even.median, even.duration / std::max(kMostGrowth * static_cast<double>(samples_), kFewSamples));
  even.samples =
      even.gaps > 0 ? EvenSteps::kUnknown : static_cast<std::size_t>(std::floor(even.duration / even.dt)) + 1;
  return even;
}

std::vector<std::size_t> stretchesOf(const Log& log) {
  std::vector<std::size_t> first = {0};
  if (log.size() < 2) {
    return first;
  }
  TimeSteps steps;
  steps.add(log);
  const EvenSteps even = steps.evenSteps();
  for (std::size_t i = 1; even.gaps > 0 && i < log.size(); ++i) {
    if (log.stamp[i] - log.stamp[i - 1] > even.longest_step) {
      first.push_back(i);
    }
  }
  return first;
}

Log longestStretch(const Log& log) {
  std::vector<std::size_t> first = stretchesOf(log);
  if (first.size() == 1) {
    return log;
  }
  first.push_back(log.size());
  std::size_t longest = 0;
  for (std::size_t i = 0; i + 1 < first.size(); ++i) {
    longest = first[i + 1] - first[i] > first[longest + 1] - first[longest] ? i : longest;
  }
  return samplesOf(log, first[longest], first[longest + 1] - first[longest]);
}

void EvenBlocks::handOut(const Take& take) {
  if (even_.displacement.empty()) {
    return;
  }
  take(pieceOf(gap_, even_));
  gap_ = 0.0;
  even_ = Log();
}

void EvenBlocks::interpolate(const Log& left, std::size_t l, const Log& block, std::size_t right) {
  const double from = seconds(left.stamp[l] - first_stamp_);
  const double until = seconds(block.stamp[right] - first_stamp_);
  for (; done_ < steps_.samples && static_cast<double>(done_) * steps_.dt <= until; ++done_) {
    const double share = std::clamp((static_cast<double>(done_) * steps_.dt - from) / (until - from), 0.0, 1.0);
    for (const auto channel : kChannels) {
      if (!(block.*channel).empty()) {
        (even_.*channel).push_back((1.0 - share) * (left.*channel)[l] + share * (block.*channel)[right]);
      }
    }
    count(share < 0.5 ? isCounted(left, l) : isCounted(block, right));
  }
}

void EvenBlocks::endStretch(const Log& last, std::size_t sample) {
  constexpr double kRounding = 1e-6;  // share of a step
  const double steps = seconds(last.stamp[sample] - first_stamp_) / steps_.dt;
  const auto samples = std::min(static_cast<std::size_t>(std::floor(steps + kRounding)) + 1, steps_.samples);
  for (; done_ < samples; ++done_) {
    for (const auto channel : kChannels) {
      if (!(last.*channel).empty()) {
        (even_.*channel).push_back((last.*channel)[sample]);
      }
    }
    count(isCounted(last, sample));
  }
}

void EvenBlocks::count(bool measured) {
  if (!measured || !even_.counts.empty()) {
    even_.counts.resize(even_.displacement.size(), 1.0);
    even_.counts.back() = measured ? 1.0 : 0.0;
  }
}

void EvenBlocks::beginBehindGap(std::int64_t stamp) {
  gap_ = seconds(stamp - first_stamp_) - static_cast<double>(done_ - 1) * steps_.dt;
  first_stamp_ = stamp;
  done_ = 0;
}

void EvenBlocks::add(const Log& block, const Take& take) {
  if (steps_.as_recorded) {
    take(pieceOf(0.0, block));
    return;
  }
  for (std::size_t i = 0; i < block.size(); ++i) {
    const Log& left = i == 0 ? last_ : block;
    const std::size_t l = i == 0 ? 0 : i - 1;
    if (!started_) {
      started_ = true;
      first_stamp_ = block.stamp[i];
    } else if (block.stamp[i] - left.stamp[l] > steps_.longest_step) {
      endStretch(left, l);
      handOut(take);
      beginBehindGap(block.stamp[i]);
    } else {
      interpolate(left, l, block, i);
    }
  }
  last_ = samplesOf(block, block.size() - 1, 1);
  handOut(take);
}

void EvenBlocks::finish(const Take& take) {
  if (!steps_.as_recorded) {
    endStretch(last_, 0);
    handOut(take);
  }
}

}  // namespace rubber_suspension::log
