// Quantity and unit in the name of a column.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace rubber_suspension::log {

enum class Quantity { time, displacement, force, temperature };

/// All quantities, in the order of options and notes.
inline constexpr std::array kQuantities = {Quantity::time, Quantity::displacement, Quantity::force,
                                           Quantity::temperature};

/// Returns "time", "displacement", ...
std::string toString(Quantity quantity);

/// Returns "run_1" of "run_1/force"; empty without a group.
std::string groupOf(const std::string& name);

/// Returns the unit of a quantity in a Log: "s", "m", "N", "degC".
std::string siUnit(Quantity quantity);

/// A column as the file names it. The unit stands behind the name, "Kraft [kN]", "Kraft (kN)", "Kraft / kN",
/// "Kraft in kN", "F/kN", "force_kN", "Kraft kN", or in a row of units.
struct ColumnName {
  std::string text;         ///< as in the file, UTF-8
  std::string bare;         ///< without unit
  std::string unit;         ///< as in the file; empty if none is stated
  bool names_unit = false;  ///< the unit stands in the text
  bool unit_known = true;   ///< false for a word behind the name of a quantity that is no unit: "Force [kilos]"
  std::string second = {};  ///< text of the cell below if that is a name, too
  std::string other = {};   ///< the unit of a row of units that contradicts the one in the name

  bool operator==(const ColumnName& column) const { return text == column.text && unit == column.unit; }
  bool operator!=(const ColumnName& column) const { return !(*this == column); }

  /// Returns "Kraft [kN]" also if the unit stands in a row of its own.
  std::string withUnit() const;
};

/// Separates the unit from a name.
ColumnName parseColumnName(const std::string& text);

/// Parses a name with the cell below it, which is its unit or a more detailed name. Brackets in the name that do not
/// measure what the unit below does are part of the name, such as "Force (Ch 2)" above "kN".
ColumnName parseColumnName(const std::string& text, const std::string& below);

/// Returns the quantity that has this plain name in English or German.
std::optional<Quantity> quantityOfName(const std::string& bare);

/// Returns the quantity that the unit measures; nullopt for other units.
std::optional<Quantity> quantityOfUnit(const std::string& unit);

/// Returns the quantity that a less specific word denotes if no other column does: position, load, date.
std::optional<Quantity> quantityOfOtherName(const std::string& bare);

/// Returns true for a lower-case name of a property of a material, such as "e*", "strain" and "storage modulus", which
/// is no stiffness or displacement until the shape is known.
bool isOfMaterial(const std::string& bare);

/// Returns a hint on such columns for errors; empty without any.
std::string materialHint(const std::vector<std::string>& columns);

/// Returns true for a name that begins with a word for a force: "force_raw", "Load 2".
bool looksLikeForce(const std::string& text);

/// Returns the unit of a name that a file format defines, such as X_Value in LabVIEW's .lvm; else empty.
std::string definedUnit(const std::string& bare);

/// Returns true for a name that this package writes: time_s, displacement_<m|mm|um>, force_<N|kN|MN>, temperature_degC.
bool isCanonical(const std::string& text, Quantity quantity);

/// Returns the unit in a field of a row of units, "kN" or "[kN]"; an empty text for an empty field and "-", nullopt for
/// other text.
std::optional<std::string> unitInField(const std::string& field);

}  // namespace rubber_suspension::log
