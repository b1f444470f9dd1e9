// Times that are written as a clock or a calendar shows them.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace rubber_suspension::log {

/// Returns true for a clock time, a date with a clock time, or a duration: "14:31:07,123", "12.03.2025 14:31:07",
/// "2025-03-12T14:31:07.5Z", "0 days 00:00:00.001", "0.001 sec".
bool isTimeText(std::string_view text);

/// Reads consecutive times. A clock without a date that falls back by more than half a day has passed midnight.
class TimeTextReader {
 public:
  /// Returns the time [ns] by zone (Z, +01:00), AM and PM: since 1970 in UTC with a date, since the first midnight
  /// without; nullopt for other text. 12/03/2025 is the 3rd of December unless its first number exceeds 12. Throws
  /// std::runtime_error if such an ambiguous date changes within the log, or a date does not exist.
  std::optional<std::int64_t> read(std::string_view text);

 private:
  std::int64_t last_of_day_ = 0;
  std::int64_t midnights_ = 0;
  std::optional<std::int64_t> doubtful_day_;
};

}  // namespace rubber_suspension::log
