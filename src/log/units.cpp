// Converts physical units by means of UDUNITS-2. The library is not thread-safe, so a mutex guards its data.
#include "rubber_suspension/log/units.h"

#include <fmt/format.h>
#include <stdlib.h>
#include <udunits2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <tuple>

#include "element/refuse.h"
#include "element/suggestion.h"
#include "log/text.h"

namespace rubber_suspension::log {
namespace {

using UnitPointer = std::unique_ptr<ut_unit, void (*)(ut_unit*)>;
using ConverterPointer = std::unique_ptr<cv_converter, void (*)(cv_converter*)>;

std::mutex& unitMutex() {
  static std::mutex mutex;
  return mutex;
}

ut_system* unitSystem() {
  static ut_system* const system = [] {
    ut_set_error_message_handler(ut_ignore);
    ut_system* made = ut_read_xml(nullptr);
    element::refuseIf(made == nullptr, "UDUNITS-2 found no unit database; install libudunits2-data");
    for (const auto& [name, unit, is_symbol] :
         {std::tuple("deg", "arc_degree", false),
          // German for degree. As a symbol it is case-sensitive; otherwise it would be read as giga-radian.
          std::tuple("Grad", "arc_degree", true), std::tuple("tonf", "1000 kgf", false),
          std::tuple("kip", "1000 lbf", false), std::tuple("mil", "0.001 in", false),
          // Laboratories write the unit of a damping constant without a blank, also with a prefix: kNs/m.
          std::tuple("Ns", "N s", true)}) {
      const UnitPointer parsed(ut_parse(made, unit, UT_ASCII), ut_free);
      (is_symbol ? ut_map_symbol_to_unit : ut_map_name_to_unit)(name, UT_ASCII, parsed.get());
    }
    return made;
  }();
  return system;
}

// A unit as headers of logs write it, in lower case, and the same unit as UDUNITS-2 spells it.
struct Spelling {
  const char* written;
  const char* unit;
};

constexpr Spelling kSpellings[] = {
    {"c", "degC"},        {"deg c", "degC"},  {"deg. c", "degC"},  {"degc", "degC"},  {"\u00b0c", "degC"},
    {"\u00b0 c", "degC"}, {"grad c", "degC"}, {"f", "degF"},       {"deg f", "degF"}, {"degf", "degF"},
    {"\u00b0f", "degF"},  {"kn", "kN"},       {"dan", "daN"},      {"newtons", "N"},  {"lb", "lbf"},
    {"lbs", "lbf"},       {"pounds", "lbf"},  {"lbsf", "lbf"},     {"klbf", "kip"},   {"klb", "kip"},
    {"klbs", "kip"},      {"kips", "kip"},    {"kp", "kgf"},       {"kgf", "kgf"},    {"nm", "N m"},
    {"knm", "kN m"},      {"mm", "mm"},       {"cm", "cm"},        {"m", "m"},        {"um", "um"},
    {"micron", "um"},     {"microns", "um"},  {"mils", "mil"},     {"thou", "mil"},   {"inch", "in"},
    {"inches", "in"},     {"\"", "in"},       {"s", "s"},          {"sec", "s"},      {"secs", "s"},
    {"sec.", "s"},        {"seconds", "s"},   {"sek", "s"},        {"sek.", "s"},     {"sekunden", "s"},
    {"ms", "ms"},         {"msec", "ms"},     {"msek", "ms"},      {"usec", "us"},    {"us", "us"},
    {"mins", "min"},      {"minuten", "min"}, {"hrs", "h"},        {"std", "h"},      {"min", "min"},
    {"minutes", "min"},   {"h", "h"},         {"hr", "h"},         {"hours", "h"},    {"second", "s"},
    {"n", "N"},           {"newton", "N"},    {"cn", "cN"},        {"gf", "gf"},      {"lbf", "lbf"},
    {"ozf", "ozf"},       {"tf", "tonf"},     {"tonf", "tonf"},    {"kip", "kip"},    {"pond", "pond"},
    {"nmm", "N mm"},      {"g", "g"},         {"kg", "kg"},        {"t", "t"},        {"mg", "mg"},
    {"gram", "g"},        {"grams", "g"},     {"kilograms", "kg"}, {"tonnes", "t"},   {"\u00b5m", "um"},
    {"\u03bcm", "um"},    {"mil", "mil"},     {"ft", "ft"},        {"ns", "ns"},      {"\u00b5s", "us"},
};

// Symbols that mean another unit in lower case.
constexpr const char* kSymbols[] = {"mN", "MN", "GN", "uN",   "\u00b5N", "dN",  "hN",
                                    "nm", "km", "dm", "degC", "degF",    "rad", "deg"};

const Spelling* spellingOf(const std::string& text) {
  const std::string written = lowerCase(text);
  const auto* const row = std::find_if(std::begin(kSpellings), std::end(kSpellings),
                                       [&](const Spelling& spelling) { return spelling.written == written; });
  return row == std::end(kSpellings) ? nullptr : row;
}

bool isUnitByte(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '%' || c == '_' ||
         static_cast<unsigned char>(c) >= 0x80;
}

// Returns the position after the exponent at `at`, if any; nullopt for a sign or ^ without digits.
std::optional<std::size_t> behindExponent(const std::string& text, std::size_t at) {
  const std::size_t power = at + (text.compare(at, 1, "^") == 0 ? 1 : 0);
  const std::size_t digits = power + (text.compare(power, 1, "-") == 0 ? 1 : 0);
  const std::size_t end = std::min(text.find_first_not_of("0123456789", digits), text.size());
  return end == digits && digits > at ? std::nullopt : std::optional(end);
}

// Returns true for a product or quotient of words with integer exponents, written with blanks, `*` and `/`. UDUNITS
// also accepts numbers, origins ("since") and logarithms, which are refused here.
bool isUnitExpression(const std::string& text) {
  static const std::array<const char*, 5> kOrigins = {"since", "from", "after", "ref", "per"};
  if (text.find('%') != std::string::npos) {
    return text == "%";
  }
  bool word_needed = true;
  for (std::size_t at = startsWith(text, "1/") ? 2 : 0; at < text.size();) {
    const auto begin = text.begin() + static_cast<std::ptrdiff_t>(at);
    const std::string word(begin, std::find_if_not(begin, text.end(), isUnitByte));
    if (!word.empty()) {
      const auto end = behindExponent(text, at + word.size());
      if (!end || std::find(kOrigins.begin(), kOrigins.end(), lowerCase(word)) != kOrigins.end()) {
        return false;
      }
      at = *end;
      word_needed = false;
    } else if (text[at] == ' ') {
      ++at;
    } else if ((text[at] == '*' || text[at] == '/') && !word_needed) {
      ++at;
      word_needed = true;
    } else {
      return false;
    }
  }
  return !word_needed;
}

UnitPointer parseUnit(const std::string& text) {
  const bool is_unit = text == "1" || isUnitExpression(text);
  return {is_unit ? ut_parse(unitSystem(), text.c_str(), UT_UTF8) : nullptr, ut_free};
}

// Returns true if the definition of a unit contains the radian. UDUNITS itself converts the radian to the number 1.
bool containsAngle(const ut_unit* unit) {
  char text[256];
  const int length = ut_format(unit, text, sizeof text, UT_ASCII | UT_DEFINITION);
  return length > 0 && std::string(text, std::min<std::size_t>(length, sizeof text)).find("rad") != std::string::npos;
}

bool areConvertible(const ut_unit* from, const ut_unit* to) {
  return ut_are_convertible(from, to) != 0 && containsAngle(from) == containsAngle(to);
}

bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

// Returns the text with each word replaced by the common unit that it resembles, if there is one.
std::string respelt(const std::string& text) {
  static const std::vector<std::string> kUnits = {"N",   "kN",   "MN",     "m",     "mm",     "um",  "cm", "s",
                                                  "ms",  "Hz",   "kHz",    "rad",   "deg",    "kg",  "J",  "min",
                                                  "rpm", "degC", "newton", "metre", "degree", "Grad"};
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const auto end = static_cast<std::size_t>(
        std::find_if_not(text.begin() + static_cast<std::ptrdiff_t>(at), text.end(), isLetter) - text.begin());
    const std::string word = text.substr(at, std::max<std::size_t>(end - at, 1));
    result += element::nearestWord(word, kUnits).value_or(word);
    at += word.size();
  }
  return result;
}

// Returns " (did you mean 'kN/mm'?)" for "kn/mm" if the corrected unit converts to `wanted`; otherwise an empty text.
std::string spellingHint(const std::string& text, const ut_unit* wanted) {
  constexpr std::size_t kLongestUnit = 20;
  const std::string other = text.size() <= kLongestUnit ? respelt(text) : text;
  if (other == text) {
    return "";
  }
  const UnitPointer unit = parseUnit(other);
  return unit && areConvertible(unit.get(), wanted) ? fmt::format(" (did you mean '{}'?)", other) : "";
}

bool isDigit(char c) { return c >= '0' && c <= '9'; }

// Returns true if three digits follow each separator from position `first` on.
bool endsInGroups(const std::string& digits, std::size_t first, char separator) {
  for (std::size_t i = first; i < digits.size(); ++i) {
    if ((digits[i] == separator) != ((i - first) % 4 == 0)) {
      return false;
    }
  }
  return (digits.size() - first) % 4 == 0;
}

// Throws if the number is followed by a decimal comma or by separators of thousands instead of a unit.
void refuseSeparators(const std::string& text, std::size_t length) {
  const char separator = length < text.size() ? text[length] : ' ';
  if (text.compare(length, 3, " 1/") == 0) {  // a unit follows, as in "2e-4 1/J"
    return;
  }
  if (length + 1 >= text.size() || !isDigit(text[length + 1]) ||
      std::string(",_' ").find(separator) == std::string::npos) {
    return;
  }
  std::size_t end = length;
  while (end < text.size() && (isDigit(text[end]) || text[end] == separator)) {
    ++end;
  }
  end = text.find_last_not_of(separator, end - 1) + 1;
  const bool groups = endsInGroups(text.substr(0, end), length, separator);
  std::string digits = text.substr(0, end);
  std::string point = digits;
  point[length] = '.';
  digits.erase(std::remove(digits.begin(), digits.end(), separator), digits.end());
  const std::string rest = text.substr(end);
  const bool several = std::count(text.begin() + static_cast<std::ptrdiff_t>(length),
                                  text.begin() + static_cast<std::ptrdiff_t>(end), separator) > 1;
  const bool thousands = separator != ',' || several;
  if (thousands && !groups) {
    return;  // the text is a list of numbers
  }
  element::refuseIf(thousands, "separators of thousands (did you mean '{}{}'?)", digits, rest);
  const bool three = end - length == 4;  // the comma in "3,000" may be decimal or separate thousands
  throw std::invalid_argument(three ? fmt::format("a comma (did you mean '{0}{2}' or '{1}{2}'?)", point, digits, rest)
                                    : fmt::format("a decimal comma (did you mean '{}{}'?)", point, rest));
}

std::size_t signLength(const std::string& text) { return !text.empty() && (text[0] == '+' || text[0] == '-') ? 1 : 0; }

// Returns the length of the decimal number at the beginning. strtod() alone would accept "0x1p3" and "infinity".
std::size_t numberLength(const std::string& text) {
  const std::size_t begin = signLength(text);
  if (begin == text.size() || !(isDigit(text[begin]) || text[begin] == '.')) {
    return 0;
  }
  if (text[begin] == '0' && (text[begin + 1] == 'x' || text[begin + 1] == 'X')) {
    return begin + 1;
  }
  char* end = nullptr;
  strtod_l(text.c_str(), &end, cLocale());
  return static_cast<std::size_t>(end - text.c_str());
}

std::optional<double> parseNonFinite(const std::string& text) {
  const std::size_t sign = signLength(text);
  const std::string word = lowerCase(text.substr(sign + (text.compare(sign, 1, ".") == 0 ? 1 : 0)));
  if (word == "nan") {
    return std::numeric_limits<double>::quiet_NaN();
  }
  if (word == "inf" || word == "infinity") {
    return std::copysign(std::numeric_limits<double>::infinity(), text[0] == '-' ? -1.0 : 1.0);
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
  return parseUnit(text) != nullptr;
}

std::string spelledUnit(const std::string& text, const std::string& wanted) {
  const std::lock_guard<std::mutex> lock(unitMutex());
  const UnitPointer target = parseUnit(wanted);
  const auto converts = [&](const std::string& unit) {
    const UnitPointer parsed = parseUnit(unit);
    return parsed && areConvertible(parsed.get(), target.get());
  };
  const Spelling* const row = spellingOf(text);
  return converts(text) || row == nullptr || !converts(row->unit) ? text : row->unit;
}

std::optional<std::string> unitOfSuffix(const std::string& text) {
  if (std::find(std::begin(kSymbols), std::end(kSymbols), text) != std::end(kSymbols)) {
    return text;
  }
  const Spelling* const row = spellingOf(text);
  return row == nullptr ? std::nullopt : std::optional<std::string>(row->unit);
}

UnitConversion::UnitConversion(const std::string& from, const std::string& to) {
  const std::lock_guard<std::mutex> lock(unitMutex());
  const UnitPointer source = parseUnit(from);
  const UnitPointer target = parseUnit(to);
  element::refuseIf(!target, "unit {} is unknown", quoted(to));
  if (!source) {
    throw std::invalid_argument(fmt::format("unit {} is unknown{}", quoted(from), spellingHint(from, target.get())));
  }
  if (!areConvertible(source.get(), target.get())) {
    throw std::invalid_argument(fmt::format("unit {} cannot be converted to {}{}", quoted(from),
                                            to == "1" ? "a number" : to, spellingHint(from, target.get())));
  }
  const ConverterPointer converter(ut_get_converter(source.get(), target.get()), cv_free);
  offset_ = cv_convert_double(converter.get(), 0.0);
  if (!std::isfinite(offset_)) {  // UDUNITS converts Hz to s, with an infinite result for 0 Hz
    throw std::invalid_argument(
        fmt::format("unit {} is the reciprocal of a unit that can be converted to {}", quoted(from), to));
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
  element::refuseIf(length == 0, "not a number");
  refuseSeparators(quantity, length);
  const double value = strtod_l(quantity.substr(0, length).c_str(), nullptr, cLocale());
  const std::string rest = trimmed(quantity.substr(length));
  element::refuseIf(!isUnitExpression(rest), "{} after the number is not a unit", quoted(rest));
  return UnitConversion(rest, unit)(value);
}

std::string unitOfQuantity(const std::string& text) {
  const std::string quantity = trimmed(text);
  return parseNumber(quantity) ? "" : trimmed(quantity.substr(numberLength(quantity)));
}

}  // namespace rubber_suspension::log
