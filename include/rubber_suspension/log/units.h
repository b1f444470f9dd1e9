// Conversion of text with physical units, such as "3 kN/mm", to numbers in SI units, by UDUNITS-2.
#pragma once

#include <optional>
#include <string>

namespace rubber_suspension::log {

/// Returns the number that the whole text represents, in decimal notation whatever the locale; nullopt for other text.
/// "nan" and "inf" (with sign, or YAML's leading dot) are numbers; hexadecimal ones are not.
std::optional<double> parseNumber(const std::string& text);

/// Returns true for text that UDUNITS-2 accepts as a unit: "kN", "mm/s".
bool isUnit(const std::string& text);

/// Returns a unit of a log's header as UDUNITS-2 spells it: "kN" for "KN", "degC" for "deg C", "lbf" for "lbs". Returns
/// the text itself if it converts to the unit `wanted`, or if no known spelling of it does.
std::string spelledUnit(const std::string& text, const std::string& wanted);

/// Returns the unit that the end of a name denotes, as "kgf" of load_kgf; nullopt for other words, such as "in" and
/// "max".
std::optional<std::string> unitOfSuffix(const std::string& text);

/// Linear conversion between two units.
class UnitConversion {
 public:
  /// Throws std::invalid_argument if a unit is unknown or the dimensions differ, with the unit that was probably meant,
  /// if any ("kN" for "kn"). Angles are a dimension of their own, so that rad/s is not confused with Hz, nor a loss
  /// angle with a relative damping.
  UnitConversion(const std::string& from, const std::string& to);

  double operator()(double value) const { return (inverse_ ? value / scale_ : value * scale_) + offset_; }

 private:
  double scale_ = 1.0;
  double offset_ = 0.0;
  bool inverse_ = false;  // scale is the whole number to divide by, so that 38 mm is 0.038 m to the last bit
};

/// Returns the number of a quantity in `unit`: 3e6 of "3 kN/mm" for "N/m". The text is one number and one unit: words
/// between blanks, `*` and `/`, each with an integer exponent or none, `1/` at the start. A number alone is in `unit`.
/// Throws std::invalid_argument that names the fault of the text; the number may have any size, or not be finite.
double parseQuantity(const std::string& text, const std::string& unit);

/// Returns the unit in a quantity as text: "kN/mm" of "3 kN/mm"; empty if there is none.
std::string unitOfQuantity(const std::string& text);

}  // namespace rubber_suspension::log
