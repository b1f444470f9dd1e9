// Conversion of text with physical units, such as "3 kN/mm", to numbers in SI units, by means of UDUNITS-2.
#pragma once

#include <optional>
#include <string>

namespace rubber_suspension::log {

/// Returns the number that the whole text represents, in decimal notation and independent of the locale; nullopt for
/// other text. Accepts "nan" and "inf", also with a sign or the leading point of YAML, but no hexadecimal numbers.
std::optional<double> parseNumber(const std::string& text);

/// Returns true if UDUNITS-2 accepts the text as a unit, such as "kN" or "mm/s".
bool isUnit(const std::string& text);

/// Returns the spelling of UDUNITS-2 for a unit in the header of a log: "kN" for "KN", "degC" for "deg C", "lbf" for
/// "lbs". Returns the text unchanged if it converts to `wanted` as it is, or if no known spelling of it converts.
std::string spelledUnit(const std::string& text, const std::string& wanted);

/// Returns the unit that the last part of a name denotes, such as "kgf" in load_kgf. Returns nullopt for words that are
/// no clear unit, such as "in" and "max".
std::optional<std::string> unitOfSuffix(const std::string& text);

/// Linear conversion between two units.
class UnitConversion {
 public:
  /// Throws std::invalid_argument if a unit is unknown or if the dimensions differ. The error suggests the unit that
  /// was probably meant ("kN" for "kn"). Angles have a dimension of their own, so that rad/s does not convert to Hz.
  UnitConversion(const std::string& from, const std::string& to);

  double operator()(double value) const { return (inverse_ ? value / scale_ : value * scale_) + offset_; }

 private:
  double scale_ = 1.0;
  double offset_ = 0.0;
  bool inverse_ = false;  // true: divide by scale_, a whole number, so that 38 mm is exactly the double 0.038
};

/// Returns the number of a quantity in `unit`, for example 3e6 for "3 kN/mm" in "N/m". The text consists of a number
/// and a unit; a number alone is taken to be in `unit`. The unit consists of words with or without an integer exponent,
/// which blanks, `*` or `/` separate. `1/` may precede them. Throws std::invalid_argument that states what is wrong in
/// the text. The number may be infinite or NaN.
double parseQuantity(const std::string& text, const std::string& unit);

/// Returns the unit in the text of a quantity, "kN/mm" for "3 kN/mm"; empty if the text has no unit.
std::string unitOfQuantity(const std::string& text);

}  // namespace rubber_suspension::log
