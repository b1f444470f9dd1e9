// Makes the samples of a log from the rows of a file.
#include "log/sample_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "element/refuse.h"
#include "log/text.h"
#include "numerics/median.h"

namespace rubber_suspension::log {
namespace {

constexpr double kRateAgrees = 0.01;
constexpr std::size_t kMostCollected = 100000;  // largest number of stamps that are kept
constexpr std::size_t kFewestOfLog = 10;        // after fewer rows, an apparent restart may be rows out of order
constexpr double kAtBeginning = 3.0;            // a restart lies within this many steps of the first stamp
constexpr double kLongestPause = 3.0;           // largest number of steps between the blocks of one log

// Returns the sampling rate [Hz] of stamps that may be equal, rounded or out of order; 0 if unknown. The rate is the
// number of rows per stamp divided by the median step between different stamps. The first and the last stamp are not
// counted, because some of their rows may be missing.
double rateOfBlock(std::vector<std::int64_t> stamps) {
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

// Splits the stamps where the time falls back far. Returns the median rate [Hz] of the resulting blocks.
double rateOfStamps(const std::vector<std::int64_t>& stamps) {
  std::vector<std::int64_t> forward;
  for (std::size_t i = 1; i < stamps.size(); ++i) {
    if (stamps[i] > stamps[i - 1]) {
      forward.push_back(stamps[i] - stamps[i - 1]);
    }
  }
  const double far = kAtBeginning * static_cast<double>(numerics::medianOf(forward));
  std::vector<double> rates;
  std::vector<std::int64_t> block;
  for (std::size_t i = 0; i <= stamps.size(); ++i) {
    if (i == stamps.size() || (i > 0 && static_cast<double>(stamps[i - 1] - stamps[i]) > far)) {
      rates.push_back(rateOfBlock(std::exchange(block, {})));
    }
    if (i < stamps.size()) {
      block.push_back(stamps[i]);
    }
  }
  return numerics::medianOf(rates);
}

}  // namespace

SampleRules::SampleRules(const LogFormat& format, const Columns& columns, const char* word)
    : format_(format), columns_(columns), signals_(format, columns, word), word_(word) {}

bool SampleRules::restarts(const SampleRow& row) const {
  if (format_.rate || !row.stamp || refused_place_ != 0 || stamped_ < kFewestOfLog) {
    return false;
  }
  const double step = static_cast<double>(last_stamp_ - first_stamp_) / static_cast<double>(stamped_ - 1);
  return std::abs(static_cast<double>(*row.stamp - first_stamp_)) <= kAtBeginning * step;
}

bool SampleRules::continues(const std::optional<std::int64_t>& stamp) const {
  const std::size_t rows = format_.rate ? own_stamps_ : stamped_;
  if (!stamp || refused_place_ != 0 || rows < 2) {
    return false;
  }
  const std::int64_t first = format_.rate ? first_own_ : first_stamp_;
  const std::int64_t last = format_.rate ? last_own_ : last_stamp_;
  const double step = static_cast<double>(last - first) / static_cast<double>(rows - 1);
  return *stamp > last && static_cast<double>(*stamp - last) <= kLongestPause * step;
}

void SampleRules::take(SampleRow& row, Log& to) {
  if (refused_place_ != 0) {
    recent_.push_back(row.stamp.value_or(recent_.back()));
    if (recent_.size() >= 2 * kMostCollected) {
      refuseStamps();
    }
    return;
  }
  if (format_.rate) {
    compareWithRate(row);
    row.stamp = stampAtRate(rows_, *format_.rate);
  }
  ++rows_;
  if (!row.stamp) {
    signals_.addTimeless(row.place, row.unmeasured[0], to);
    return;
  }
  if (stamped_ > 0 && *row.stamp <= last_stamp_) {
    if (repeatsLast(row)) {
      first_merged_ = merged_ == 0 ? row.place : first_merged_;
      ++merged_;
      return;
    }
    if (!completesLast(row)) {
      refused_place_ = row.place;
      refused_stamp_ = *row.stamp;
      recent_.push_back(*row.stamp);
      return;
    }
  }
  if (recent_.size() == kMostCollected) {
    recent_.erase(recent_.begin(), recent_.begin() + kMostCollected / 2);
  }
  recent_.push_back(*row.stamp);
  first_stamp_ = stamped_ == 0 ? *row.stamp : first_stamp_;
  last_stamp_ = *row.stamp;
  ++stamped_;
  last_ = row.value;
  signals_.add({*row.stamp, row.place, row.value, row.faulty, false},
               {row.unmeasured[1], row.unmeasured[2], row.unmeasured[3]}, to);
}

bool SampleRules::repeatsLast(const SampleRow& row) const {
  const auto same = [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); };
  return row.stamp == last_stamp_ && std::equal(last_.begin(), last_.end(), row.value.begin(), same);
}

// Returns true if a row has the stamp of the last row and values only where the last row has none.
bool SampleRules::completesLast(const SampleRow& row) const {
  const auto complement = [](double a, double b) { return std::isnan(a) || std::isnan(b); };
  return row.stamp == last_stamp_ && std::equal(last_.begin(), last_.end(), row.value.begin(), complement);
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

double SampleRules::rate() const { return rateOfStamps(recent_); }

void SampleRules::refuseStamps() const {
  const double told = rate();
  throw RowError(refused_place_,
                 fmt::format("{}: the time {} follows {}; accepted: time that increases from row to row by at least 1 "
                             "ns, or --sampling-rate{} instead of this column",
                             columns_.time.name, formatStamp(refused_stamp_), formatStamp(last_stamp_),
                             told > 0.0 && told <= 1e9 ? fmt::format(" {:.6g}", told) : " and its value"));
}

void SampleRules::finish(Log& to) {
  if (refused_place_ != 0) {
    refuseStamps();
  }
  signals_.finish(to);
  const bool good = format_.rate && own_stamps_ == rows_ && bad_stamps_ == 0;
  if (good && std::abs(ownRate() / *format_.rate - 1.0) > kRateAgrees) {
    throw std::runtime_error(
        fmt::format("--sampling-rate is {:g} Hz, but the stamps of column {} have {:.6g} Hz; accepted: no "
                    "--sampling-rate, or --sampling-rate {:.6g}",
                    *format_.rate, quoted(columns_.time.label), ownRate(), ownRate()));
  }
}

std::vector<std::string> SampleRules::notes() const {
  std::vector<std::string> notes = signals_.notes();
  if (merged_ > 0) {
    notes.push_back(fmt::format("{} row{} that repeat{} the preceding row exactly, the first in {} {}: omitted",
                                merged_, pluralOf(merged_), merged_ == 1 ? "s" : "", word_, first_merged_));
  }
  if (own_stamps_ > 0) {
    notes.push_back(fmt::format(
        "the stamps of column {} are replaced by --sampling-rate {:g}{}", quoted(columns_.time.label), *format_.rate,
        bad_stamps_ == 0
            ? ""
            : fmt::format(": {} of {} stamps are not later than the preceding stamp", bad_stamps_, own_stamps_)));
  }
  return notes;
}

}  // namespace rubber_suspension::log
