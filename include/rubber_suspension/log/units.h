// Physical units: text such as "3 kN/mm" to a number in an SI unit, by UDUNITS-2.
#pragma once

#include <optional>
#include <string>

namespace rubber_suspension::log {

/// The number that the whole text is, in decimal notation whatever the locale, or nothing. "nan" and "inf" (with sign,
/// or YAML's leading dot) are numbers; hexadecimal ones are not.
std::optional<double> parseNumber(const std::string& text);

/// True for text that names a unit as the library of units spells it: "kN", "mm/s".
bool isUnit(const std::string& text);

/// A unit of a log's header as the library of units spells it: "kN" for "KN", "degC" for "deg C", "lbf" for "lbs". The
/// text itself where it converts to the unit `wanted`, or where none of the spellings known here does.
std::string spelledUnit(const std::string& text, const std::string& wanted);

/// Returns the unit behind a name, after an underscore or a blank, as "kgf" in load_kgf; nullopt for another word, such
/// as "in" and "max".
std::optional<std::string> unitOfSuffix(const std::string& text);

/// Linear conversion between two units.
class UnitConversion {
 public:
  /// Throws std::invalid_argument where a unit is unknown or they differ in dimension, with the unit that was probably
  /// meant, if any ("kN" for "kn"). Angles are a dimension of their own, so that rad/s is not confused with Hz, nor a
  /// loss angle with a relative damping.
  UnitConversion(const std::string& from, const std::string& to);

  double operator()(double value) const { return (inverse_ ? value / scale_ : value * scale_) + offset_; }

 private:
  double scale_ = 1.0;
  double offset_ = 0.0;
  bool inverse_ = false;  // scale is the whole number to divide by, so that 38 mm is 0.038 m to the last bit
};

/// A quantity as text, in `unit`: "3 kN/mm" for unit "N/m" is 3e6. It is one number and one unit: words between blanks,
/// `*` and `/`, each with an integer exponent or none, `1/` at the start. A number without unit is taken as in `unit`.
/// Throws std::invalid_argument with what is wrong with the text; the value may be out of any range, or not finite.
double parseQuantity(const std::string& text, const std::string& unit);

/// The unit that is written in a quantity as text: "kN/mm" of "3 kN/mm"; empty where none is.
std::string unitOfQuantity(const std::string& text);

}  // namespace rubber_suspension::log
