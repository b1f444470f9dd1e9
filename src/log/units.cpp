// Physical units by UDUNITS-2, whose system of units is read once and guarded by a lock: it is not safe for threads.
#include "rubber_suspension/log/units.h"

#include <fmt/format.h>
#include <stdlib.h>
#include <udunits2.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <stdexcept>

#include "log/text.h"

namespace rubber_suspension::log {
namespace {

using UnitPointer = std::unique_ptr<ut_unit, void (*)(ut_unit*)>;
using ConverterPointer = std::unique_ptr<cv_converter, void (*)(cv_converter*)>;

std::mutex& unitMutex() {
  static std::mutex mutex;
  return mutex;
}

void mapName(ut_system* system, const char* name, const char* unit) {
  const UnitPointer parsed(ut_parse(system, unit, UT_ASCII), ut_free);
  if (parsed) {
    ut_map_name_to_unit(name, UT_ASCII, parsed.get());
  }
}

ut_system* unitSystem() {
  static ut_system* const system = [] {
    ut_set_error_message_handler(ut_ignore);
    ut_system* made = ut_read_xml(nullptr);
    if (made == nullptr) {
      throw std::invalid_argument("UDUNITS-2 found no unit database; install libudunits2-data");
    }
    mapName(made, "deg", "arc_degree");
    mapName(made, "tonf", "1000 kgf");
    mapName(made, "Sek", "s");
    mapName(made, "sek", "s");
    return made;
  }();
  return system;
}

UnitPointer parseUnit(const std::string& text) {
  UnitPointer unit(ut_parse(unitSystem(), text.c_str(), UT_UTF8), ut_free);
  if (!unit) {
    throw std::invalid_argument(fmt::format("unit {} is unknown", quoted(text)));
  }
  return unit;
}

// UDUNITS takes the radian for the number 1; the definition of the unit shows whether it is in there.
bool containsAngle(const ut_unit* unit) {
  char text[256];
  const int length = ut_format(unit, text, sizeof text, UT_ASCII | UT_DEFINITION);
  return length > 0 && std::string(text, std::min<std::size_t>(length, sizeof text)).find("rad") != std::string::npos;
}

// The length of the decimal number that the text begins with: strtod would take "0x1p3", "infinity" and the like too.
std::size_t numberLength(const std::string& text) {
  std::size_t i = !text.empty() && (text[0] == '+' || text[0] == '-') ? 1 : 0;
  const auto digits = [&] {
    const std::size_t start = i;
    while (i < text.size() && text[i] >= '0' && text[i] <= '9') {
      ++i;
    }
    return i - start;
  };
  std::size_t mantissa = digits();
  if (i < text.size() && text[i] == '.') {
    ++i;
    mantissa += digits();
  }
  if (mantissa == 0) {
    return 0;
  }
  const std::size_t before_exponent = i;
  if (i < text.size() && (text[i] == 'e' || text[i] == 'E')) {
    ++i;
    i += i < text.size() && (text[i] == '+' || text[i] == '-') ? 1 : 0;
    if (digits() == 0) {
      return before_exponent;
    }
  }
  return i;
}

std::optional<double> parseNonFinite(std::string text) {
  const double sign = !text.empty() && text[0] == '-' ? -1.0 : 1.0;
  if (!text.empty() && (text[0] == '-' || text[0] == '+')) {
    text.erase(0, 1);
  }
  if (!text.empty() && text[0] == '.') {
    text.erase(0, 1);
  }
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  if (text == "nan") {
    return std::numeric_limits<double>::quiet_NaN();
  }
  if (text == "inf" || text == "infinity") {
    return sign * std::numeric_limits<double>::infinity();
  }
  return std::nullopt;
}

}  // namespace

std::optional<double> parseNumber(const std::string& text) {
  const std::size_t length = numberLength(text);
  if (length == 0 || length != text.size()) {
    return parseNonFinite(text);
  }
  return strtod_l(text.c_str(), nullptr, cLocale());
}

bool isUnit(const std::string& text) {
  const std::lock_guard<std::mutex> lock(unitMutex());
  const UnitPointer unit(ut_parse(unitSystem(), text.c_str(), UT_UTF8), ut_free);
  return unit != nullptr;
}

UnitConversion::UnitConversion(const std::string& from, const std::string& to) {
  const std::lock_guard<std::mutex> lock(unitMutex());
  const UnitPointer source = parseUnit(from);
  const UnitPointer target = parseUnit(to);
  if (ut_are_convertible(source.get(), target.get()) == 0 ||
      containsAngle(source.get()) != containsAngle(target.get())) {
    throw std::invalid_argument(
        fmt::format("unit {} cannot be converted to {}", quoted(from), to == "1" ? "a number" : to));
  }
  const ConverterPointer converter(ut_get_converter(source.get(), target.get()), cv_free);
  offset_ = cv_convert_double(converter.get(), 0.0);
  if (!std::isfinite(offset_)) {  // the library turns Hz into s
    throw std::invalid_argument(fmt::format("unit {} is the reciprocal of one that converts to {}", quoted(from), to));
  }
  scale_ = cv_convert_double(converter.get(), 1.0) - offset_;
  const double reciprocal = std::round(1.0 / scale_);
  const bool whole = std::abs(reciprocal * scale_ - 1.0) < 4.0 * std::numeric_limits<double>::epsilon();
  if (std::abs(scale_) < 1.0 && whole) {
    scale_ = reciprocal;
    inverse_ = true;
  }
}

double parseQuantity(const std::string& text, const std::string& unit) {
  const std::string quantity = trimmed(text);
  if (const std::optional<double> number = parseNumber(quantity)) {
    return *number;
  }
  const std::size_t length = numberLength(quantity);
  if (length == 0) {
    throw std::invalid_argument("not a number");
  }
  const double value = strtod_l(quantity.substr(0, length).c_str(), nullptr, cLocale());
  return UnitConversion(trimmed(quantity.substr(length)), unit)(value);
}

}  // namespace rubber_suspension::log
