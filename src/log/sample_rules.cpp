// The rules by which rows of a file become samples of a log.
#include "log/sample_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "element/largest_number.h"
#include "element/refuse.h"
#include "log/text.h"
#include "numerics/median.h"

namespace rubber_suspension::log {
namespace {

constexpr double kBridged = 0.5;            // [s], as the node bridges by default
constexpr std::size_t kFewestPerGap = 100;  // rows for each that lacks a value, unless --bridge is given
constexpr double kRateAgrees = 0.01;
constexpr std::size_t kMostCollected = 100000;  // stamps

// The rate of a recording whose stamps are equal, swapped or rounded: from the usual step between different stamps, and
// how many rows share one. The first and the last of them need not be there from their first row to their last. 0 where
// they do not tell it.
double rateOfStamps(std::vector<std::int64_t> stamps) {
  std::sort(stamps.begin(), stamps.end());
  const auto first_rows = std::upper_bound(stamps.begin(), stamps.end(), stamps.front()) - stamps.begin();
  const auto last_rows = stamps.end() - std::lower_bound(stamps.begin(), stamps.end(), stamps.back());
  const auto all_rows = stamps.end() - stamps.begin();
  stamps.erase(std::unique(stamps.begin(), stamps.end()), stamps.end());
  if (stamps.size() < 2) {
    return 0.0;
  }
  const auto different = static_cast<double>(stamps.size());
  double share = stamps.size() == 2 ? static_cast<double>(std::max(first_rows, last_rows))
                                    : static_cast<double>(all_rows - first_rows - last_rows) / (different - 2.0);
  constexpr double kWhole = 0.02;
  share = std::abs(share - std::round(share)) < kWhole ? std::round(share) : share;
  for (std::size_t i = 0; i + 1 < stamps.size(); ++i) {
    stamps[i] = stamps[i + 1] - stamps[i];
  }
  stamps.pop_back();
  return share * 1e9 / static_cast<double>(numerics::medianOf(stamps));
}

const char* pluralOf(std::size_t count) { return count == 1 ? "" : "s"; }

}  // namespace

SampleRules::SampleRules(const LogFormat& format, const Columns& columns, const char* word)
    : format_(format), columns_(columns), word_(word) {}

void SampleRules::take(SampleRow& row, Log& to) {
  const auto require = [&](const Column& column, double value) {
    if (std::abs(value) > element::kLargestNumber) {
      throw RowError(row.place, fmt::format("{}: {:g} is out of range; accepted: at most {:g} in size", column.name,
                                            value, element::kLargestNumber));
    }
  };
  require(columns_.displacement, row.displacement);
  require(columns_.force, row.force);
  require(columns_.temperature, row.temperature);
  if (!collected_.empty()) {
    collected_.push_back(row.stamp.value_or(collected_.back()));
    if (collected_.size() >= kMostCollected) {
      refuseStamps();
    }
    return;
  }
  if (format_.rate) {
    compareWithRate(row);
  }
  ++rows_;
  if (lacksValue(row)) {
    first_missing_ = missing_ == 0 ? row : first_missing_;
    ++missing_;
    gap_ = gap_.value_or(row);
    return;
  }
  if (format_.rate) {
    row.stamp = stampAtRate(rows_ - 1, *format_.rate);
  }
  if (kept_ == 0 || *row.stamp > *last_.stamp) {
    keep(row, to);
  } else if (repeatsLast(row)) {
    first_merged_ = merged_ == 0 ? row.place : first_merged_;
    ++merged_;
  } else {
    refused_ = row;
    collected_ = to.stamp;  // those of the block
    collected_.push_back(*row.stamp);
  }
}

bool SampleRules::repeatsLast(const SampleRow& row) const {
  return row.stamp == last_.stamp && row.displacement == last_.displacement && row.force == last_.force &&
         row.temperature == last_.temperature;
}

void SampleRules::keep(const SampleRow& row, Log& to) {
  if (gap_ && kept_ > 0) {
    checkGap(row);
    longest_gap_ = std::max(longest_gap_, 1e-9 * static_cast<double>(*row.stamp - *last_.stamp));
  }
  gap_.reset();
  first_stamp_ = kept_ == 0 ? *row.stamp : first_stamp_;
  last_ = row;
  ++kept_;
  to.stamp.push_back(*row.stamp);
  to.displacement.push_back(row.displacement);
  if (columns_.force.found()) {
    to.force.push_back(row.force);
  }
  if (columns_.temperature.found()) {
    to.temperature.push_back(row.temperature);
  }
}

bool SampleRules::lacksValue(const SampleRow& row) const {
  return std::isnan(row.displacement) || std::isnan(row.force) || std::isnan(row.temperature) ||
         (!format_.rate && !row.stamp);
}

void SampleRules::checkGap(const SampleRow& row) const {
  const double gap = 1e-9 * static_cast<double>(*row.stamp - *last_.stamp);
  if (gap > format_.bridge.value_or(kBridged)) {
    throw RowError(gap_->place,
                   fmt::format("{}; accepted: a finite number, or --bridge {:.3g}, for {:.3g} s are without one",
                               gap_->unmeasured, std::ceil(100.0 * gap) / 100.0, gap));
  }
}

void SampleRules::compareWithRate(const SampleRow& row) {
  if (!row.stamp) {
    return;
  }
  if (own_stamps_ == 0) {
    first_own_ = *row.stamp;
  } else if (*row.stamp <= last_own_) {
    ++bad_stamps_;
  }
  ++own_stamps_;
  last_own_ = *row.stamp;
}

double SampleRules::ownRate() const {
  return static_cast<double>(own_stamps_ - 1) * 1e9 / static_cast<double>(last_own_ - first_own_);
}

void SampleRules::refuseStamps() const {
  const double rate = rateOfStamps(collected_);
  throw RowError(refused_.place,
                 fmt::format("{}: {} after {}; accepted: time that increases from row to row, by 1 ns at least, or "
                             "--sampling-rate{} in place of this column",
                             columns_.time.name, formatStamp(*refused_.stamp), formatStamp(*last_.stamp),
                             rate > 0.0 && rate <= 1e9 ? fmt::format(" {:.6g}", rate) : " and its value"));
}

void SampleRules::finish() const {
  if (!collected_.empty()) {
    refuseStamps();
  }
  if (missing_ > 0 && !format_.bridge && missing_ * kFewestPerGap > rows_) {
    throw RowError(first_missing_.place,
                   fmt::format("{}; accepted: a finite number, or --bridge {:g}, which leaves out {} of {} rows",
                               first_missing_.unmeasured, kBridged, missing_, rows_));
  }
  element::refuseIf<std::runtime_error>(kept_ < 2, "{} sample{}; accepted: at least 2", kept_, pluralOf(kept_));
  const bool good = format_.rate && own_stamps_ == rows_ && bad_stamps_ == 0;
  if (good && std::abs(ownRate() / *format_.rate - 1.0) > kRateAgrees) {
    throw std::runtime_error(
        fmt::format("--sampling-rate says {:g} Hz, the stamps of column {} {:.6g} Hz; accepted: no --sampling-rate, or "
                    "--sampling-rate {:.6g}",
                    *format_.rate, quoted(columns_.time.label), ownRate(), ownRate()));
  }
}

std::vector<std::string> SampleRules::notes() const {
  std::vector<std::string> notes;
  if (missing_ > 0) {
    notes.push_back(fmt::format(
        "{} row{} without a number, the first in {} {} ({}): left out, time gaps of at most "
        "{:.3g} s are bridged",
        missing_, pluralOf(missing_), word_, first_missing_.place, first_missing_.unmeasured, longest_gap_));
  }
  if (merged_ > 0) {
    notes.push_back(fmt::format("{} row{} that repeat{} the one before, stamp and values, the first in {} {}: left out",
                                merged_, pluralOf(merged_), merged_ == 1 ? "s" : "", word_, first_merged_));
  }
  if (own_stamps_ > 0) {
    notes.push_back(fmt::format(
        "the stamps of column {} are replaced by --sampling-rate {:g}{}", quoted(columns_.time.label), *format_.rate,
        bad_stamps_ == 0 ? "" : fmt::format(": {} of {} are not later than the one before", bad_stamps_, own_stamps_)));
  }
  return notes;
}

}  // namespace rubber_suspension::log
