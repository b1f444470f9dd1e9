// Reads times of day, dates and durations that are written as text.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace rubber_suspension::log {

/// Returns true for a time of day, a date with a time of day, or a duration: "14:31:07,123", "12.03.2025 14:31:07",
/// "2025-03-12T14:31:07.5Z", "0 days 00:00:00.001", "0.001 sec".
bool isTimeText(std::string_view text);

/// Reads consecutive times. If a time of day without a date falls back by more than half a day, midnight has passed.
class TimeTextReader {
 public:
  /// Returns the time [ns] with respect to the time zone (Z, +01:00), if any; nullopt for other text. A time with a
  /// date counts from 1970 in UTC, a time without a date from the first midnight. 12/03/2025 means the 3rd of December,
  /// because the month stands first unless the first number exceeds 12. Throws std::runtime_error if such an ambiguous
  /// date changes within the log, or a date does not exist.
  std::optional<std::int64_t> read(std::string_view text);

 private:
  std::int64_t last_of_day_ = 0;
  std::int64_t midnights_ = 0;
  std::optional<std::int64_t> doubtful_day_;
};

}  // namespace rubber_suspension::log
