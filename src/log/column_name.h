// Recognises the quantity and the unit in the name of a column.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace rubber_suspension::log {

enum class Quantity { time, displacement, force, temperature };

/// All quantities, in the order that options and notes use.
inline constexpr std::array kQuantities = {Quantity::time, Quantity::displacement, Quantity::force,
                                           Quantity::temperature};

/// Returns the name of a quantity, such as "time".
std::string toString(Quantity quantity);

/// Returns the group in the path of a column, "run_1" for "run_1/force"; empty if there is no group.
std::string groupOf(const std::string& name);

/// Returns the unit of a quantity in a Log: "s", "m", "N" or "degC".
std::string siUnit(Quantity quantity);

/// A column as the file names it. The unit stands behind the name, as in "Kraft [kN]", "Kraft (kN)", "Kraft / kN",
/// "Kraft in kN", "F/kN", "force_kN" or "Kraft kN", or in a row of units.
struct ColumnName {
  std::string text;         ///< as in the file, UTF-8
  std::string bare;         ///< the name without its unit
  std::string unit;         ///< the unit as in the file; empty if the file states none
  bool names_unit = false;  ///< true if the unit is part of `text`
  bool unit_known = true;   ///< false if the word behind the name of a quantity is no unit, as in "Force [kilos]"
  std::string second = {};  ///< text of the cell below if that is another name
  std::string other = {};   ///< unit in the row of units if it contradicts the unit in the name

  bool operator==(const ColumnName& column) const { return text == column.text && unit == column.unit; }
  bool operator!=(const ColumnName& column) const { return !(*this == column); }

  /// Returns the name with its unit, "Kraft [kN]", even if the unit stands in a row of units.
  std::string withUnit() const;
};

/// Separates the unit from a name.
ColumnName parseColumnName(const std::string& text);

/// Parses a name together with the cell below it, which contains the unit or a more detailed name. Brackets in the name
/// remain part of it unless they contain a unit of the same kind as the cell below: "Force (Ch 2)" above "kN".
ColumnName parseColumnName(const std::string& text, const std::string& below);

/// Returns the quantity that this name denotes in English or German.
std::optional<Quantity> quantityOfName(const std::string& bare);

/// Returns the quantity that the unit measures; nullopt if it is no quantity of a log.
std::optional<Quantity> quantityOfUnit(const std::string& unit);

/// Returns the quantity that position, load, date and other unspecific words denote if no column has a specific name.
std::optional<Quantity> quantityOfOtherName(const std::string& bare);

/// Returns true for the lower-case name of a property of a material, such as "e*", "strain" and "storage modulus".
/// Conversion to a stiffness or a displacement requires the shape of the part.
bool isOfMaterial(const std::string& bare);

/// Returns a hint for errors about columns of material properties; empty if `columns` is empty.
std::string materialHint(const std::vector<std::string>& columns);

/// Returns true for a name that begins with a word for a force, such as "force_raw" and "Load 2".
bool looksLikeForce(const std::string& text);

/// Returns the unit that a file format assigns to a name, such as X_Value in LabVIEW's .lvm; empty for other names.
std::string definedUnit(const std::string& bare);

/// Returns true for names that this package writes: time_s, displacement_<m|mm|um>, force_<N|kN|MN>, temperature_degC.
bool isCanonical(const std::string& text, Quantity quantity);

/// Returns the unit in a field such as "kN" or "[kN]"; an empty text for "" and "-"; nullopt if the field is no unit.
std::optional<std::string> unitInField(const std::string& field);

}  // namespace rubber_suspension::log
