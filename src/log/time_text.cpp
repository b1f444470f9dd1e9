// Reads times of day, dates and durations that are written as text.
#include "log/time_text.h"

#include <algorithm>
#include <boost/date_time/gregorian/gregorian_types.hpp>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <utility>

#include "element/refuse.h"
#include "log/text.h"
#include "rubber_suspension/log/units.h"

namespace rubber_suspension::log {
namespace {

constexpr std::int64_t kNanoseconds = 1000000000;  // nanoseconds per second
constexpr std::int64_t kDay = 86400 * kNanoseconds;

bool isDigitOfTime(char c) { return c >= '0' && c <= '9'; }

// Parses a text from its beginning.
class TimeText {
 public:
  explicit TimeText(std::string_view text) : rest_(text) {}

  bool atEnd() const { return rest_.empty(); }
  char front() const { return rest_.empty() ? '\0' : rest_.front(); }

  bool take(std::string_view accepted) {
    const bool found = !rest_.empty() && accepted.find(rest_.front()) != std::string_view::npos;
    rest_.remove_prefix(found ? 1 : 0);
    return found;
  }

  void skipBlanks() { rest_.remove_prefix(std::min(rest_.find_first_not_of(' '), rest_.size())); }

  // Reads a number. Returns -1 if there are no digits or more than `most`.
  int number(std::size_t most) {
    std::size_t digits = 0;
    int value = 0;
    while (digits < rest_.size() && isDigitOfTime(rest_[digits]) && digits <= most) {
      value = 10 * value + (rest_[digits++] - '0');
    }
    rest_.remove_prefix(digits);
    return digits == 0 || digits > most ? -1 : value;
  }

  // Reads the digits after the decimal mark of a second [ns]. Digits below one nanosecond are ignored.
  std::int64_t fraction() {
    std::int64_t value = 0;
    std::int64_t unit = kNanoseconds / 10;
    while (!rest_.empty() && isDigitOfTime(rest_.front())) {
      value += unit == 0 ? 0 : (rest_.front() - '0') * unit;
      unit /= 10;
      rest_.remove_prefix(1);
    }
    return value;
  }

 private:
  std::string_view rest_;
};

struct CalendarDay {
  std::int64_t days = 0;  // days since 1970
  bool doubtful = false;  // true if day and month may be exchanged
  bool exists = true;
};

std::optional<CalendarDay> takeDate(TimeText& text) {
  int parts[3];
  parts[0] = text.number(4);
  const char separator = text.front();
  if (parts[0] < 0 || !text.take("-./") || (parts[1] = text.number(2)) < 0 || !text.take({&separator, 1}) ||
      (parts[2] = text.number(4)) < 0) {
    return std::nullopt;
  }
  if (parts[0] <= 31) {  // the year is the last of the three numbers
    std::swap(parts[0], parts[2]);
    const bool month_first = separator == '/' && parts[2] <= 12;
    if (month_first) {
      std::swap(parts[1], parts[2]);
    }
  }
  const int year = parts[0] + (parts[0] < 100 ? 2000 : 0);
  const bool doubtful = separator == '/' && parts[0] != 0 && parts[1] <= 12 && parts[2] <= 12;
  try {
    const boost::gregorian::date day(static_cast<unsigned short>(year), static_cast<unsigned short>(parts[1]),
                                     static_cast<unsigned short>(parts[2]));
    const bool in_range = year >= 1900 && year <= 2200;
    return CalendarDay{(day - boost::gregorian::date(1970, 1, 1)).days(), doubtful && in_range, in_range};
  } catch (const std::out_of_range&) {
    return CalendarDay{0, false, false};
  }
}

// Converts the hour with AM or PM to 24 hours: 12 PM is noon, 12 AM midnight.
int hourOf(int hour, TimeText& text) {
  text.skipBlanks();
  const bool after_noon = text.take("Pp");
  const bool before_noon = !after_noon && text.take("Aa");
  if (!after_noon && !before_noon) {
    return hour;
  }
  return text.take("Mm") && hour >= 1 && hour <= 12 ? hour % 12 + (after_noon ? 12 : 0) : -1;
}

std::optional<std::int64_t> takeClock(TimeText& text) {
  int hour = text.number(2);
  const int minute = text.take(":") ? text.number(2) : -1;
  if (hour < 0 || minute < 0) {
    return std::nullopt;
  }
  std::int64_t nanoseconds = 0;
  if (text.take(":")) {
    const int second = text.number(2);
    if (second < 0 || second > 60) {
      return std::nullopt;
    }
    nanoseconds = second * kNanoseconds + (text.take(".,:") ? text.fraction() : 0);
  } else if (text.take(".,")) {  // "minutes:seconds.fraction", as spreadsheets show a time
    return (hour * 60 + minute) * kNanoseconds + text.fraction();
  }
  hour = hourOf(hour, text);
  if (hour < 0 || hour > 24 || minute > 59) {
    return std::nullopt;
  }
  return (hour * 60 + minute) * 60 * kNanoseconds + nanoseconds;
}

// Returns the offset of the time zone [ns], positive east of Greenwich; 0 if none is stated, nullopt for other text.
std::optional<std::int64_t> takeZone(TimeText& text) {
  text.skipBlanks();
  if (text.atEnd() || text.take("Zz")) {
    return 0;
  }
  const bool west = text.front() == '-';
  if (!text.take("+-")) {
    return std::nullopt;
  }
  const int hours = text.number(2);
  text.take(":");
  const int minutes = text.atEnd() ? 0 : text.number(2);
  if (hours < 0 || minutes < 0) {
    return std::nullopt;
  }
  return (west ? -1 : 1) * (hours * 60 + minutes) * 60 * kNanoseconds;
}

// Reads a duration as pandas writes it: "0 days 00:00:00.001", or "-1 days +23:59:59" if negative.
std::optional<std::int64_t> takeDays(std::string_view text) {
  TimeText whole(text);
  const bool before = whole.take("-");
  const int days = whole.number(5);
  whole.skipBlanks();
  if (days < 0 || !whole.take("d") || !whole.take("a") || !whole.take("y")) {
    return std::nullopt;
  }
  whole.take("s");
  whole.skipBlanks();
  whole.take("+");
  const auto of_day = takeClock(whole);
  return of_day && whole.atEnd() ? std::optional((before ? -days : days) * kDay + *of_day) : std::nullopt;
}

// Reads a number with its unit, "0.001 sec".
std::optional<std::int64_t> takeQuantity(std::string_view text) {
  const std::size_t blank = text.find_first_of(kBlanks);
  if (blank == std::string_view::npos || blank == 0 || !(isDigitOfTime(text[blank - 1]) || text[blank - 1] == '.')) {
    return std::nullopt;
  }
  const std::string unit = trimmed(text.substr(blank));
  std::string number(text.substr(0, blank));
  std::replace(number.begin(), number.end(), ',', '.');
  const auto spelled = unitOfSuffix(unit);
  const auto value = parseNumber(number);
  if (!spelled || !value) {
    return std::nullopt;
  }
  try {
    const double seconds = UnitConversion(*spelled, "s")(1.0);
    const long double nanoseconds = std::strtold(number.c_str(), nullptr) * static_cast<long double>(seconds) * 1e9L;
    constexpr long double kMost = 9e18L;
    return std::abs(nanoseconds) < kMost ? std::optional<std::int64_t>(std::llroundl(nanoseconds)) : std::nullopt;
  } catch (const std::invalid_argument&) {  // the unit does not measure time
    return std::nullopt;
  }
}

}  // namespace

bool isTimeText(std::string_view text) {
  try {
    return TimeTextReader().read(text).has_value();
  } catch (const std::runtime_error&) {  // the text is a date, but no such day exists
    return true;
  }
}

std::optional<std::int64_t> TimeTextReader::read(std::string_view text) {
  TimeText whole(text);
  std::optional<CalendarDay> day;
  if (text.find(':') == std::string_view::npos) {
    return takeQuantity(text);
  }
  if (const auto days = takeDays(text)) {
    return days;
  }
  if (text.find_first_of("-./") < text.find(':')) {
    day = takeDate(whole);
    if (!day || !whole.take(" T_")) {
      return std::nullopt;
    }
    whole.skipBlanks();
  }
  const auto of_day = takeClock(whole);
  const auto zone = of_day ? takeZone(whole) : std::nullopt;
  if (!zone || !whole.atEnd()) {
    return std::nullopt;
  }
  if (day) {
    element::refuseIf<std::runtime_error>(
        !day->exists, "{} is no date of the calendar; accepted: a day from 1900 to 2200 that exists",
        quoted(std::string(text)));
    element::refuseIf<std::runtime_error>(
        day->doubtful && doubtful_day_ && *doubtful_day_ != day->days,
        "the dates change, and may have the day or the month first; accepted: dates of ISO 8601");
    doubtful_day_ = day->doubtful ? std::optional(day->days) : doubtful_day_;
    return day->days * kDay + *of_day - *zone;
  }
  midnights_ += *of_day < last_of_day_ - kDay / 2 ? 1 : 0;
  last_of_day_ = *of_day;
  return midnights_ * kDay + *of_day - *zone;
}

}  // namespace rubber_suspension::log
