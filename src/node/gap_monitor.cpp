// Matches measured to simulated forces by stamp.
#include "node/gap_monitor.h"

#include <algorithm>
#include <boost/iterator/counting_iterator.hpp>
#include <cmath>

#include "element/largest_number.h"

namespace rubber_suspension::node {

GapMonitor::GapMonitor(std::size_t capacity) : capacity_(std::max(capacity, kCapacity)) {}

void GapMonitor::makeRoom(std::uint64_t number) {
  auto& block = blocks_[number % capacity_ / kBlock];
  if (!block) {
    block = std::make_unique<Block>();
  }
}

void GapMonitor::match(std::uint64_t number, double force) {
  MatchedSample& sample = at(number);
  if (!std::isnan(sample.measured)) {
    ++counters_.unmatched;  // a second force with the same stamp
    return;
  }
  sample.measured = force;
  matched_end_ = std::max(matched_end_, number + 1);
  ++counters_.matched;
  if (!std::isnan(sample.beside)) {
    ++paired_.samples;
    paired_.published += (force - sample.simulated) * (force - sample.simulated);
    paired_.other += (force - sample.beside) * (force - sample.beside);
  }
}

// Matches measured forces that came before their sample, and discards forces that can no longer be matched.
void GapMonitor::takeWaiting(std::uint64_t number) {
  const std::int64_t stamp = at(number).stamp;
  const auto is_past = [&](const Waiting& waiting) {
    if (waiting.stamp == stamp) {
      match(number, waiting.force);
    } else if (waiting.stamp < stamp) {
      ++counters_.unmatched;
    }
    return waiting.stamp <= stamp;
  };
  waiting_.erase(std::remove_if(waiting_.begin(), waiting_.end(), is_past), waiting_.end());
}

void GapMonitor::addSimulated(std::int64_t stamp, double displacement, double force, double beside) {
  const bool counts = std::abs(displacement) <= element::kLargestNumber && std::abs(force) <= element::kLargestNumber;
  if (!counts || !wanted_.load(std::memory_order_relaxed)) {
    return;
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  if (count_ > first_ && stamp <= at(count_ - 1).stamp) {
    first_ = count_;  // waiting forces are kept, because they may belong to the new replay
  }
  const std::uint64_t number = count_;
  makeRoom(number);
  ++count_;
  at(number) = {stamp, displacement, force, std::numeric_limits<double>::quiet_NaN(), beside};
  if (!waiting_.empty()) {
    takeWaiting(number);
  }
}

// Returns the number of the first sample at or after `stamp`. The stamps increase with the numbers.
std::uint64_t GapMonitor::firstFrom(std::int64_t stamp) const {
  using Number = boost::counting_iterator<std::uint64_t>;
  return *std::partition_point(Number(oldest()), Number(count_),
                               [&](std::uint64_t number) { return at(number).stamp < stamp; });
}

bool GapMonitor::addMeasured(std::int64_t stamp, double force) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!wanted_) {
    blocks_.resize((capacity_ + kBlock - 1) / kBlock);
    for (std::uint64_t number = 0; number < kCapacity; number += kBlock) {
      makeRoom(number);
    }
    waiting_.reserve(kWaiting);
    wanted_ = true;
  }
  if (!(std::abs(force) <= element::kLargestNumber)) {
    ++counters_.not_finite;
    return false;
  }
  const std::uint64_t number = firstFrom(stamp);
  if (number < count_ && at(number).stamp == stamp) {
    match(number, force);
  } else if (waiting_.size() < kWaiting && (count_ == first_ || stamp > at(count_ - 1).stamp)) {
    waiting_.push_back({stamp, force});
  } else {
    ++counters_.unmatched;
  }
  return true;
}

void GapMonitor::clear() {
  const std::lock_guard<std::mutex> lock(mutex_);
  first_ = count_;
  counters_.unmatched += waiting_.size();
  waiting_.clear();
}

std::vector<MatchedSample> GapMonitor::window(double window) const {
  std::uint64_t next = 0;
  std::uint64_t expected = 0;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!wanted_ || count_ == first_) {
      return {};
    }
    next = firstFrom(at(count_ - 1).stamp - static_cast<std::int64_t>(std::llround(window * 1e9)));
    expected = count_ - next;
  }
  return read(next, expected);
}

std::vector<MatchedSample> GapMonitor::read(std::uint64_t& next, std::size_t most) const {
  constexpr std::uint64_t kPiece = 512;
  std::vector<MatchedSample> samples;
  samples.reserve(most);
  for (bool more = true; more;) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (next < oldest()) {
      next = oldest();
      samples.clear();  // the samples were overwritten, or a new replay began
    }
    for (const std::uint64_t end = std::min(next + kPiece, matched_end_); next < end; ++next) {
      if (!std::isnan(at(next).measured)) {
        samples.push_back(at(next));
      }
    }
    more = next < matched_end_ && samples.size() < most;
  }
  return samples;
}

MatchCounters GapMonitor::counters() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return counters_;
}

PairedErrors GapMonitor::pairedErrors() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return paired_;
}

void GapMonitor::clearPairedErrors() {
  const std::lock_guard<std::mutex> lock(mutex_);
  paired_ = {};
}

}  // namespace rubber_suspension::node
