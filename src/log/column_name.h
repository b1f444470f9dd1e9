// The quantity and unit that the name of a column tells.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace rubber_suspension::log {

enum class Quantity { time, displacement, force, temperature };

/// In the order of the options and of what is told.
inline constexpr std::array kQuantities = {Quantity::time, Quantity::displacement, Quantity::force,
                                           Quantity::temperature};

/// "time", "displacement", ...
std::string toString(Quantity quantity);

/// "run_1" of "run_1/force"; empty without a group.
std::string groupOf(const std::string& name);

/// The unit that a log keeps a quantity in: "s", "m", "N", "degC".
std::string siUnit(Quantity quantity);

/// A column as the file names it. The unit stands behind the name, "Kraft [kN]", "Kraft (kN)", "Kraft / kN",
/// "Kraft in kN", "F/kN", "force_kN", "Kraft kN", or in a row of units.
struct ColumnName {
  std::string text;         ///< as in the file, UTF-8
  std::string bare;         ///< without unit
  std::string unit;         ///< as in the file; empty where none is told
  bool names_unit = false;  ///< the unit stands in the text
  bool unit_known = true;   ///< false for a word behind the name of a quantity that is no unit: "Force [kilos]"
  std::string second = {};  ///< text of the cell below, where that is a name, too
  std::string other = {};   ///< the unit of a row of units that contradicts the one in the name

  bool operator==(const ColumnName& column) const { return text == column.text && unit == column.unit; }
  bool operator!=(const ColumnName& column) const { return !(*this == column); }

  /// "Kraft [kN]" also where the unit stands in a row of its own.
  std::string withUnit() const;
};

/// Take a name apart.
ColumnName parseColumnName(const std::string& text);

/// Parses a name with the cell below it, which is its unit or a more detailed name. A bracket of the name that does not
/// measure what the unit below does is no unit but a part of the name, such as "Force (Ch 2)" above "kN".
ColumnName parseColumnName(const std::string& text, const std::string& below);

/// The quantity whose plain name, in English or German, this is.
std::optional<Quantity> quantityOfName(const std::string& bare);

/// The quantity that the unit measures, if it is one of them.
std::optional<Quantity> quantityOfUnit(const std::string& unit);

/// The quantity that another word may name, where nothing else is that quantity: position, load, date.
std::optional<Quantity> quantityOfOtherName(const std::string& bare);

/// True for a name in lower case of a property of a material, such as "e*", "strain" and "storage modulus": no
/// stiffness or displacement until the shape is known.
bool isOfMaterial(const std::string& bare);

/// Hint on such columns for errors; empty without any.
std::string materialHint(const std::vector<std::string>& columns);

/// True for a name that begins with a word for a force: "force_raw", "Load 2".
bool looksLikeForce(const std::string& text);

/// The unit of a name that a file format defines, such as X_Value in LabVIEW's .lvm; else empty.
std::string definedUnit(const std::string& bare);

/// True for a name that this package writes: time_s, displacement_<m|mm|um>, force_<N|kN|MN>, temperature_degC.
bool isCanonical(const std::string& text, Quantity quantity);

/// The unit in a field of a row of units, "kN" or "[kN]"; nothing where the field is none. Empty and "-" are no unit
/// but may stand there.
std::optional<std::string> unitInField(const std::string& field);

}  // namespace rubber_suspension::log
