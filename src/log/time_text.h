// Times that are written as a clock or a calendar shows them.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace rubber_suspension::log {

/// True for a clock time, a date with a clock time, or a duration: "14:31:07,123", "12.03.2025 14:31:07",
/// "2025-03-12T14:31:07.5Z", "0 days 00:00:00.001", "0.001 sec".
bool isTimeText(std::string_view text);

/// Reads times one after the other: a clock without a date that falls back by more than half a day has passed midnight.
class TimeTextReader {
 public:
  /// [ns], since 1970 in UTC with a date, since the first midnight without; a zone (Z, +01:00) is taken into account,
  /// AM and PM as well. 12/03/2025 is the 3rd of December where no other number forbids it. Nothing for other text.
  /// Throws std::runtime_error where a date of this form, which may be read in two ways, changes within the log.
  std::optional<std::int64_t> read(std::string_view text);

 private:
  std::int64_t last_of_day_ = 0;
  std::int64_t midnights_ = 0;
  std::optional<std::int64_t> doubtful_day_;
};

}  // namespace rubber_suspension::log
