// Merges displacement, force and temperature, which may be sampled at different times.
#include "log/signals.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "element/largest_number.h"
#include "element/refuse.h"
#include "log/text.h"
#include "numerics/median.h"

namespace rubber_suspension::log {
namespace {

constexpr std::size_t kLookAhead = 262144;     // rows examined first, and samples that may wait for a slow signal
constexpr std::int64_t kLongestSteps = 3;      // a signal is interpolated over at most this many of its median steps
constexpr double kBridged = 0.5;               // [s], the default of the node
constexpr std::size_t kFewestPerGap = 100;     // without --bridge, one of this many rows may lack a displacement
constexpr std::size_t kFewestPerAdvised = 10;  // an option is suggested if it omits at most one of this many rows
constexpr std::size_t kMostPlaces = 4;         // largest number of positions in a note
constexpr double kFarOff = 100.0;              // a code of missing values is off by this multiple of the others' range

bool isMeasured(double value) { return !std::isnan(value); }

void requireSize(std::size_t place, const Column& column, double value) {
  if (std::abs(column.toSi(value)) > element::kLargestNumber) {
    throw RowError(place, fmt::format("{}: {:g} is out of range; accepted: at most {:g} in size", column.name,
                                      column.toSi(value), element::kLargestNumber));
  }
}

// Returns true if the range of all values exceeds kFarOff times that of the middle three quarters. Otherwise no value
// can be a code of missing values.
bool mayHoldSentinel(const std::vector<double>& values) {
  constexpr std::size_t kSampled = 1000;
  const std::size_t stride = values.size() / kSampled + 1;
  std::vector<double> sampled;
  for (std::size_t i = 0; i < values.size(); i += stride) {
    sampled.push_back(values[i]);
  }
  std::sort(sampled.begin(), sampled.end());
  const std::size_t tail = sampled.size() / 8;
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return *high - *low > kFarOff * (sampled[sampled.size() - 1 - tail] - sampled[tail]);
}

// Returns true if `value` is a code of missing values. Each run of a code lies between values from `low` to `high`. The
// code fills at most a tenth of the rows, or all rows between the samples of a slow signal. A signal that steps to a
// value and remains there, or reaches it through other values out of range, has measured it.
bool isMissingValueCode(const std::vector<double>& values, double value, double low, double high) {
  std::size_t cells = 0;
  std::size_t other_runs = 0;
  std::size_t left_again = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const bool here = values[i] == value;
    const bool before = i > 0 && values[i - 1] == value;
    const double neighbour = here || i == 0 ? values[i == 0 ? 0 : i - 1] : values[i];
    if (i > 0 && here != before && !(neighbour >= low && neighbour <= high)) {
      return false;
    }
    cells += here ? 1 : 0;
    other_runs += !here && (i == 0 || before) ? 1 : 0;
    left_again += !here && before && cells < i ? 1 : 0;
  }
  const std::size_t others = values.size() - cells;
  return left_again > 0 && (10 * cells <= values.size() || others < 2 * other_runs);
}

struct Peeled {
  std::vector<double> values;
  double low = 0.0;  // range of the other values
  double high = 0.0;
};

// Returns repeated lowest and highest values that are farther from all others than kFarOff times the others' range.
Peeled peel(const std::vector<double>& ascending) {
  constexpr std::size_t kMostDistinct = 4;  // at each end
  const auto peelable = [&](auto begin, auto end) {
    std::vector<std::pair<double, std::size_t>> values;
    for (auto at = begin; at != end && values.size() < kMostDistinct;) {
      const auto next = std::find_if(at, end, [&](double value) { return value != *at; });
      if (next - at < 2) {
        break;
      }
      values.emplace_back(*at, next - at);
      at = next;
    }
    return values;
  };
  const auto bottom = peelable(ascending.begin(), ascending.end());
  const auto top = peelable(ascending.rbegin(), ascending.rend());
  for (std::size_t peeled = 1; peeled <= bottom.size() + top.size(); ++peeled) {
    for (std::size_t below = peeled - std::min(peeled, top.size()); below <= std::min(peeled, bottom.size()); ++below) {
      const std::size_t above = peeled - below;
      std::size_t first = 0;
      std::size_t last = ascending.size();
      Peeled result;
      for (std::size_t i = 0; i < below; ++i) {
        first += bottom[i].second;
        result.values.push_back(bottom[i].first);
      }
      for (std::size_t i = 0; i < above; ++i) {
        last -= std::min(last, top[i].second);
        result.values.push_back(top[i].first);
      }
      if (first + 1 >= last) {
        continue;
      }
      result.low = ascending[first];
      result.high = ascending[last - 1];
      const double far = kFarOff * (result.high - result.low);
      const bool all_far = far > 0.0 && std::all_of(result.values.begin(), result.values.end(), [&](double value) {
                             return value - result.high > far || result.low - value > far;
                           });
      if (all_far) {
        return result;
      }
    }
  }
  return {};
}

}  // namespace

Signals::Signals(const LogFormat& format, const Columns& columns, const char* word)
    : format_(format), columns_(columns), word_(word) {
  for (std::size_t s = 0; s < kSignals; ++s) {
    signals_[s].there = columnOf(s).found();
  }
}

const Column& Signals::columnOf(std::size_t signal) const { return *columns_.all()[signal + 1]; }

void Signals::add(const SignalRow& row, const std::array<std::string, kSignals>& reason, Log& to) {
  ++rows_;
  for (std::size_t s = 0; s < kSignals; ++s) {
    if (columnOf(s).found() && !isMeasured(row.value[s]) && signals_[s].first_place == 0) {
      signals_[s].first_place = row.place;
      signals_[s].first_reason = reason[s];
    }
  }
  if (settled_) {
    merge(row, to);
    return;
  }
  ahead_.push_back(row);
  if (ahead_.size() == kLookAhead) {
    settle(to);
  }
}

void Signals::addTimeless(std::size_t place, const std::string& reason, Log& to) {
  ++rows_;
  first_timeless_ = timeless_ == 0 ? place : first_timeless_;
  timeless_reason_ = timeless_ == 0 ? reason : timeless_reason_;
  ++timeless_;
  SignalRow row;
  row.place = place;
  row.timeless = true;
  if (settled_) {
    merge(row, to);
  } else {
    ahead_.push_back(row);
  }
}

void Signals::settle(Log& to) {
  settled_ = true;
  for (std::size_t s = 0; s < kSignals; ++s) {
    if (signals_[s].there) {
      findSentinels(s);
      measureSteps(s);
    }
  }
  for (const SignalRow& row : std::exchange(ahead_, {})) {
    merge(row, to);
  }
}

void Signals::findSentinels(std::size_t signal) {
  std::vector<double> values;
  for (const SignalRow& row : ahead_) {
    if (isMeasured(row.value[signal])) {
      values.push_back(row.value[signal]);
    }
  }
  if (values.empty()) {
    return;
  }
  Signal& state = signals_[signal];
  if (!format_.sentinel && mayHoldSentinel(values)) {
    std::vector<double> ascending = values;
    std::sort(ascending.begin(), ascending.end());
    const Peeled peeled = peel(ascending);
    for (const double value : peeled.values) {
      if (isMissingValueCode(values, value, peeled.low, peeled.high)) {
        state.sentinels.push_back({value, peeled.low, peeled.high, {}, 0});
      }
    }
  } else if (format_.sentinel && isMeasured(*format_.sentinel)) {
    state.sentinels.push_back({*format_.sentinel, 0.0, 0.0, {}, 0});
  }
  for (const double value : values) {
    const bool stands_for_none = std::any_of(state.sentinels.begin(), state.sentinels.end(),
                                             [&](const Sentinel& sentinel) { return sentinel.value == value; });
    if (!stands_for_none) {
      state.low = std::min(state.low, value);
      state.high = std::max(state.high, value);
    }
  }
}

void Signals::measureSteps(std::size_t signal) {
  Signal& state = signals_[signal];
  std::vector<std::int64_t> steps;
  std::optional<std::int64_t> last;
  for (SignalRow& row : ahead_) {
    dropSentinels(row);
    if (!row.timeless && isMeasured(row.value[signal])) {
      if (last) {
        steps.push_back(row.stamp - *last);
      }
      last = row.stamp;
    }
  }
  state.there = last.has_value();
  state.step = numerics::medianOf(std::move(steps));
}

void Signals::dropSentinels(SignalRow& row) {
  for (std::size_t s = 0; s < kSignals; ++s) {
    for (Sentinel& sentinel : signals_[s].sentinels) {
      if (row.value[s] == sentinel.value) {
        row.value[s] = kNotMeasured;
        row.faulty[s] = true;
        ++sentinel.cells;
        if (sentinel.places.size() < kMostPlaces) {
          sentinel.places.push_back(row.place);
        }
      }
    }
  }
}

// Throws if a value far outside the range occurs twice after the first kLookAhead rows, because among those rows it
// would have been taken for a code of missing values.
void Signals::watchRange(std::size_t signal, const SignalRow& row) {
  Signal& state = signals_[signal];
  const double value = row.value[signal];
  const double far = kFarOff * (state.high - state.low);
  if (format_.sentinel || !isMeasured(value) || !(far > 0.0) ||
      !(value - state.high > far || state.low - value > far)) {
    return;
  }
  constexpr std::size_t kMostSuspects = 16;
  const auto same = std::find_if(state.suspects.begin(), state.suspects.end(),
                                 [&](const Sentinel& suspect) { return suspect.value == value; });
  if (same == state.suspects.end()) {
    if (state.suspects.size() < kMostSuspects) {
      state.suspects.push_back({value, state.low, state.high, {row.place}, 1});
    }
    return;
  }
  throw RowError(
      row.place,
      fmt::format("{}: the value {:g}, as in {} {}, is far outside the range of all others, {:g} to {:g}; accepted: "
                  "--sentinel {} if it marks missing values, or --sentinel none if it was measured",
                  columnOf(signal).name, value, word_, same->places.front(), state.low, state.high, value));
}

void Signals::merge(SignalRow row, Log& to) {
  if (row.timeless) {
    addMissing(row, true);
    return;
  }
  if (!signals_[kMotion].sentinels.empty() || !signals_[kForce].sentinels.empty() ||
      !signals_[kTemperature].sentinels.empty()) {
    dropSentinels(row);
  }
  for (std::size_t s = 0; s < kSignals; ++s) {
    Signal& state = signals_[s];
    state.rows += isMeasured(row.value[s]) ? 1 : 0;
    requireSize(row.place, columnOf(s), row.value[s]);
    if (rows_ > kLookAhead) {
      watchRange(s, row);
      if (!state.there && columnOf(s).found() && isMeasured(row.value[s])) {
        throw RowError(
            row.place,
            fmt::format(
                "{}: no number in the first {} rows; accepted: a log with numbers in each column from the beginning",
                columnOf(s).name, kLookAhead));
      }
    }
  }
  if (isMeasured(row.value[kMotion])) {
    addSample(row);
  } else {
    addMissing(row, row.faulty[kMotion]);
  }
  for (const std::size_t s : {kForce, kTemperature}) {
    if (signals_[s].there && isMeasured(row.value[s])) {
      arrive(s, row);
    }
  }
  handOut(to, false);
}

void Signals::addSample(const SignalRow& row) {
  Signal& motion = signals_[kMotion];
  if (gap_rows_ > 0 && motion.begun) {
    const std::int64_t gap = row.stamp - motion.last_stamp;
    if (gap_faults_ > 0 || gap > kLongestSteps * motion.step) {
      lost_rows_ += gap_rows_;
      const double seconds = 1e-9 * static_cast<double>(gap);
      longest_place_ = seconds > longest_gap_ ? gap_place_ : longest_place_;
      longest_gap_ = std::max(longest_gap_, seconds);
    }
  } else {
    lost_rows_ += gap_faults_;
  }
  gap_rows_ = gap_faults_ = 0;
  motion.begun = true;
  motion.last_stamp = row.stamp;
  Sample sample{row.stamp, row.value, true};
  for (const std::size_t s : {kForce, kTemperature}) {  // a row of the same stamp may have had the value
    Signal& state = signals_[s];
    if (state.begun && state.last_stamp == row.stamp && !isMeasured(row.value[s]) &&
        state.next == passed_ + pending_.size()) {
      sample.value[s] = state.last_value;
      state.last_shared = true;
      ++state.next;
    }
  }
  pending_.push_back(sample);
}

void Signals::addMissing(const SignalRow& row, bool faulty) {
  gap_place_ = gap_rows_ == 0 ? row.place : gap_place_;
  ++gap_rows_;
  gap_faults_ += faulty ? 1 : 0;
}

// Interpolates a signal at the samples that wait for its next value. If the force has a clock of its own, these samples
// count as measured. If its values share stamps with the displacement, the force was not measured in between.
void Signals::arrive(std::size_t signal, const SignalRow& row) {
  Signal& state = signals_[signal];
  const double value = row.value[signal];
  const bool shared = signals_[kMotion].begun && signals_[kMotion].last_stamp == row.stamp;
  const std::int64_t step = row.stamp - state.last_stamp;
  const bool own_clock = !shared && !state.last_shared && step <= kLongestSteps * state.step;
  for (std::size_t i = std::max(state.next, passed_); i < passed_ + pending_.size(); ++i) {
    Sample& sample = pending_[i - passed_];
    const bool exact = sample.stamp == row.stamp;
    const double share =
        state.begun && !exact ? static_cast<double>(sample.stamp - state.last_stamp) / static_cast<double>(step) : 1.0;
    sample.value[signal] = exact ? value : (1.0 - share) * (state.begun ? state.last_value : value) + share * value;
    sample.counts = sample.counts && (signal != kForce || exact || (state.begun && own_clock));
  }
  state.next = passed_ + pending_.size();
  state.begun = true;
  state.last_stamp = row.stamp;
  state.last_value = value;
  state.last_shared = shared;
}

void Signals::handOut(Log& to, bool all) {
  while (!pending_.empty()) {
    Sample& sample = pending_.front();
    for (const std::size_t s : {kForce, kTemperature}) {
      Signal& state = signals_[s];
      if (!state.there || state.next > passed_) {
        continue;
      }
      if (!all && pending_.size() <= kLookAhead) {
        return;
      }
      sample.value[s] = state.last_value;  // holds the last value, because no further one follows
      sample.counts = sample.counts && s != kForce;
      state.next = passed_ + 1;
    }
    append(sample, to);
    pending_.pop_front();
    ++passed_;
  }
}

void Signals::append(const Sample& sample, Log& to) {
  first_stamp_ = handed_out_ == 0 ? sample.stamp : first_stamp_;
  last_stamp_ = sample.stamp;
  ++handed_out_;
  to.stamp.push_back(sample.stamp);
  to.displacement.push_back(columns_.displacement.toSi(sample.value[kMotion]));
  if (signals_[kForce].there) {
    to.force.push_back(columns_.force.toSi(sample.value[kForce]));
    compared_ += sample.counts ? 1 : 0;
  }
  if (signals_[kTemperature].there) {
    to.temperature.push_back(columns_.temperature.toSi(sample.value[kTemperature]));
  }
  if (!sample.counts || !to.counts.empty()) {
    to.counts.resize(to.stamp.size(), 1.0);
    to.counts.back() = sample.counts ? 1.0 : 0.0;
  }
}

void Signals::finish(Log& to) {
  if (!settled_) {
    settle(to);
  }
  handOut(to, true);
  lost_rows_ += gap_faults_;
  refuseGaps();
  const Signal& motion = signals_[kMotion];
  if (handed_out_ < 2 && !motion.first_reason.empty()) {
    throw RowError(motion.first_place, motion.first_reason + "; accepted: a finite number");
  }
  element::refuseIf<std::runtime_error>(handed_out_ < 2, "{} sample{}; accepted: at least 2", handed_out_,
                                        pluralOf(handed_out_));
}

void Signals::refuseGaps() const {
  const Signal& motion = signals_[kMotion];
  const bool too_long = longest_gap_ > format_.bridge.value_or(kBridged);
  const bool too_many = !format_.bridge && lost_rows_ * kFewestPerGap > rows_;
  if (!too_long && !too_many && (motion.there || rows_ == 0)) {
    return;
  }
  const bool by_time = timeless_ > 0 && (motion.first_place == 0 || first_timeless_ < motion.first_place);
  const std::string reason = by_time ? timeless_reason_ : motion.first_reason;
  const std::size_t first = by_time ? first_timeless_ : motion.first_place;
  for (const Sentinel& sentinel : motion.sentinels) {
    if (reason.empty() && sentinel.cells > 0) {
      throw RowError(sentinel.places.front(), sentinelText(kMotion, sentinel) +
                                                  "; accepted: --sentinel none if this value was measured" + advice());
    }
  }
  throw RowError(too_long ? longest_place_ : first, reason + "; accepted: a finite number" + advice());
}

// Returns the suggestion of an option for the error, provided that it would omit at most a tenth of the rows.
std::string Signals::advice() const {
  if (lost_rows_ * kFewestPerAdvised > rows_ || !signals_[kMotion].there) {
    return signals_[kMotion].there
               ? fmt::format(" in nine of ten rows, but {} of {} rows lack a number", lost_rows_, rows_)
               : "";
  }
  return fmt::format(", or --bridge {:.6g}, which omits {} of {} rows, at most {:.3g} s in a row",
                     std::max(kBridged, std::ceil(100.0 * longest_gap_) / 100.0), lost_rows_, rows_, longest_gap_);
}

std::string Signals::sentinelText(std::size_t signal, const Sentinel& sentinel) const {
  return fmt::format("{}: {} cell{} of {:g}{}, in {} {}{}", columnOf(signal).name, sentinel.cells,
                     pluralOf(sentinel.cells), sentinel.value,
                     format_.sentinel ? "" : fmt::format(", far outside {:g} to {:g}", sentinel.low, sentinel.high),
                     word_, fmt::format("{}", fmt::join(sentinel.places, ", ")),
                     sentinel.cells > sentinel.places.size() ? ", ..." : "");
}

void Signals::noteSignal(std::size_t signal, std::vector<std::string>& notes) const {
  const Signal& state = signals_[signal];
  const Column& column = columnOf(signal);
  for (const Sentinel& sentinel : state.sentinels) {
    if (sentinel.cells > 0) {
      notes.push_back(fmt::format("{}: read as missing values{}", sentinelText(signal, sentinel),
                                  format_.sentinel ? "" : "; --sentinel none keeps them"));
    }
  }
  if (!column.found() || state.rows == rows_) {
    return;
  }
  if (!state.there) {
    notes.push_back(fmt::format("column {} has no number and is omitted", quoted(column.label)));
    return;
  }
  const std::string rate = state.step > 0 ? fmt::format(" at {:.4g} Hz", 1e9 / static_cast<double>(state.step)) : "";
  const std::string first = state.first_reason.empty() ? ""
                                                       : fmt::format(" (the first row without a value is {} {}: {})",
                                                                     word_, state.first_place, state.first_reason);
  const std::string came =
      fmt::format("column {} has values{} in only {} of {} rows", quoted(column.label), rate, state.rows, rows_);
  if (signal == kTemperature) {
    notes.push_back(came + ": interpolated");
  } else if (signal == kForce) {
    notes.push_back(fmt::format("{}{}: only {} of {} samples have a force; the others are simulated but not compared",
                                came, first, compared_, handed_out_));
  } else if (lost_rows_ == 0) {
    notes.push_back(came + first);
  }
}

std::vector<std::string> Signals::notes() const {
  std::vector<std::string> notes;
  if (lost_rows_ > 0) {
    const bool by_time =
        timeless_ > 0 && (signals_[kMotion].first_place == 0 || first_timeless_ < signals_[kMotion].first_place);
    const std::string& reason = by_time ? timeless_reason_ : signals_[kMotion].first_reason;
    notes.push_back(fmt::format("{} row{} without a number{}: omitted; time gaps of at most {:.3g} s are bridged",
                                lost_rows_, pluralOf(lost_rows_),
                                reason.empty()
                                    ? ""
                                    : fmt::format(", the first in {} {} ({})", word_,
                                                  by_time ? first_timeless_ : signals_[kMotion].first_place, reason),
                                longest_gap_));
  }
  for (std::size_t s = 0; s < kSignals; ++s) {
    noteSignal(s, notes);
  }
  return notes;
}

}  // namespace rubber_suspension::log
