// Recognises the quantity and the unit in the name of a column.
#include "log/column_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "log/text.h"
#include "rubber_suspension/log/units.h"

namespace rubber_suspension::log {
namespace {

struct QuantityNames {
  Quantity quantity;
  const char* name;
  const char* unit;
  std::vector<std::string> words;    // names of the quantity in lower case
  std::vector<std::string> others;   // names that count only if no column has one of `words`
  std::vector<std::string> units;    // units with which this package writes the name
  std::vector<std::string> defined;  // names to which a file format assigns the SI unit
};

const std::vector<QuantityNames>& quantityTable() {
  static const std::vector<QuantityNames> table = {
      {Quantity::time,
       "time",
       "s",
       {"time", "zeit", "timestamp", "timestamps", "zeitstempel", "uhrzeit", "date time", "datetime", "date/time",
        "date & time", "datum/uhrzeit", "datum uhrzeit", "x_value", "%time"},
       {"date", "datum"},
       {"s"},
       {"x_value", "timestamps"}},  // x_value in LabVIEW's .lvm, timestamps in MDF exported to HDF5
      {Quantity::displacement,
       "displacement",
       "m",
       {"displacement", "deflection", "weg", "federweg", "auslenkung", "verschiebung", "einfederung"},
       {"position", "travel", "stroke", "hub"},
       {"m", "mm", "um"},
       {}},
      {Quantity::force, "force", "N", {"force", "kraft"}, {"load", "last"}, {"N", "kN", "MN"}, {}},
      {Quantity::temperature, "temperature", "degC", {"temperature", "temperatur"}, {}, {"degC"}, {}},
  };
  return table;
}

const QuantityNames& rowOf(Quantity quantity) { return quantityTable()[static_cast<std::size_t>(quantity)]; }

std::optional<Quantity> quantityWith(const std::string& bare, std::vector<std::string> QuantityNames::* words) {
  const std::string word = lowerCase(bare);
  for (const QuantityNames& row : quantityTable()) {
    if (std::find((row.*words).begin(), (row.*words).end(), word) != (row.*words).end()) {
      return row.quantity;
    }
  }
  return std::nullopt;
}

// Returns true for units that may follow an underscore in any name. Other units are words, too: "displacement_in".
bool isPlainSuffix(const std::string& unit) {
  static const std::array<const char*, 16> kUnits = {"s",  "ms", "us", "m",   "cm",  "mm",  "um",   "N",
                                                     "kN", "MN", "Nm", "kNm", "rad", "deg", "degC", "lbf"};
  return std::find(kUnits.begin(), kUnits.end(), unit) != kUnits.end();
}

bool converts(const std::string& unit, const std::string& to) {
  try {
    UnitConversion(unit, to);
    return true;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

bool isKnownUnit(const std::string& unit) {
  return !unit.empty() && !parseNumber(unit) &&
         (isUnit(unit) || quantityOfUnit(unit).has_value() || spelledUnit(unit, "N m") != unit);
}

// Returns true if the unit in a name is credible: it measures a quantity of a log, or the same as the unit in the cell
// below. In "Position (A)" above "mm", A is not the unit ampere.
bool mayMeasure(const std::string& unit, const std::string& other) {
  return quantityOfUnit(unit).has_value() || converts(unit, other);
}

bool areEqual(const std::string& unit, const std::string& other) {
  const auto quantity = quantityOfUnit(unit);
  const std::string si = quantity ? rowOf(*quantity).unit : other;
  const auto size = [&](const std::string& text) { return UnitConversion(spelledUnit(text, si), si)(1.0); };
  constexpr double kRounding = 1e-9;
  return converts(spelledUnit(other, si), si) &&
         std::abs(size(unit) - size(other)) <= kRounding * std::abs(size(other));
}

std::string withoutBrackets(const std::string& text) {
  const bool bracketed =
      text.size() >= 2 && ((text.front() == '[' && text.back() == ']') || (text.front() == '(' && text.back() == ')'));
  return bracketed ? trimmed(text.substr(1, text.size() - 2)) : text;
}

// Splits a name into the part before `end` and the unit from `begin` on. Returns false if the second part is not a
// unit. Brackets behind the name of a quantity are split off even if they do not contain a known unit.
bool splitAt(ColumnName& name, std::size_t end, std::size_t begin) {
  const std::string unit = withoutBrackets(trimmed(name.text.substr(begin)));
  const std::string bare = trimmed(name.text.substr(0, end));
  const bool known = isKnownUnit(unit);
  const bool in_brackets = name.text.find_first_of("[(", begin) == begin;
  if (bare.empty() || unit.empty() ||
      !(known || (in_brackets && (quantityOfName(bare) || quantityOfOtherName(bare))))) {
    return false;
  }
  name.bare = bare;
  name.unit = unit;
  name.names_unit = true;
  name.unit_known = known;
  return true;
}

bool splitBracket(ColumnName& name) {
  const std::size_t open = name.text.find_last_of("[(");
  const bool closed = !name.text.empty() && (name.text.back() == ']' || name.text.back() == ')');
  return open != std::string::npos && open > 0 && closed && splitAt(name, open, open);
}

bool splitMark(ColumnName& name, const std::string& mark) {
  const std::size_t at = name.text.rfind(mark);
  return at != std::string::npos && splitAt(name, at, at + mark.size());
}

// Returns true for a unit of the quantity that the name denotes. A mass behind a force is accepted and refused later.
bool isSuffixOf(const std::string& bare, const std::string& suffix) {
  const auto named = quantityOfName(bare);
  const auto quantity = named ? named : quantityOfOtherName(bare);
  const auto unit = unitOfSuffix(suffix);
  return quantity && unit &&
         (converts(spelledUnit(suffix, rowOf(*quantity).unit), rowOf(*quantity).unit) ||
          converts(*unit, rowOf(*quantity).unit) || (*quantity == Quantity::force && converts(*unit, "kg")));
}

// Splits off a unit behind a mark. Returns false for a number with a unit, such as "10 mm".
bool splitSuffix(ColumnName& name, char mark) {
  const std::size_t at = name.text.rfind(mark);
  if (at == std::string::npos || name.text.find_first_not_of("0123456789.,+- ") >= at) {
    return false;
  }
  const std::string suffix = name.text.substr(at + 1);
  return (isPlainSuffix(suffix) || isSuffixOf(name.text.substr(0, at), suffix)) && splitAt(name, at, at + 1);
}

// Splits "F/kN" and "s/mm", but neither "N/mm" nor "Stiffness N/mm", in which the slash belongs to the unit.
bool splitSlash(ColumnName& name) {
  const std::string before = name.text.substr(0, name.text.find('/'));
  return before.find(' ') == std::string::npos && (before == "s" || !isPlainSuffix(before)) && splitSuffix(name, '/');
}

}  // namespace

std::string groupOf(const std::string& name) {
  const std::size_t slash = name.find_last_of('/');
  return slash == std::string::npos ? "" : name.substr(0, slash);
}

bool isOfMaterial(const std::string& bare) {
  static const std::vector<std::string> words = {"e*",     "e'",      "e''",    "g*",       "g'",
                                                 "g''",    "|e*|",    "|g*|",   "modulus",  "modul",
                                                 "strain", "dehnung", "stress", "spannung", "strain amplitude"};
  const std::string last = bare.substr(bare.rfind(' ') + 1);
  const bool property = last == "modulus" || last == "modul" || last == "strain" || last == "stress";
  return property || std::find(words.begin(), words.end(), bare) != words.end();
}

std::string materialHint(const std::vector<std::string>& columns) {
  return columns.empty() ? ""
                         : fmt::format(
                               "; {}: a quantity of the material, from which the shape (area, height) gives a "
                               "stiffness or a displacement",
                               join(columns));
}

bool looksLikeForce(const std::string& text) {
  const std::string lower = lowerCase(text);
  const std::string word = lower.substr(0, lower.find_first_of(" _-.[(/0123456789"));
  return quantityOfName(word) == Quantity::force || quantityOfOtherName(word) == Quantity::force;
}

std::string toString(Quantity quantity) { return rowOf(quantity).name; }
std::string siUnit(Quantity quantity) { return rowOf(quantity).unit; }

std::string ColumnName::withUnit() const { return unit.empty() || names_unit ? text : text + " [" + unit + "]"; }

ColumnName parseColumnName(const std::string& text) {
  ColumnName name{text, text, ""};
  if (!splitBracket(name) && !splitMark(name, " / ") && !splitMark(name, " in ") && !splitSuffix(name, '_') &&
      !splitSlash(name)) {
    splitSuffix(name, ' ');
  }
  return name;
}

ColumnName parseColumnName(const std::string& text, const std::string& below) {
  ColumnName name = parseColumnName(text);
  const auto unit = unitInField(below);
  if (unit && !unit->empty() && *unit != name.unit) {
    const bool told = name.unit_known && !name.unit.empty() && mayMeasure(name.unit, *unit);
    name.other = told && !areEqual(name.unit, *unit) ? *unit : "";
    if (!told) {
      name.unit = *unit;
      name.names_unit = false;
      name.unit_known = true;
    }
  }
  if (unit) {
    return name;
  }
  ColumnName other = parseColumnName(below);
  if (name.unit.empty() && (!other.unit.empty() || (quantityOfName(below) && !quantityOfName(text)))) {
    std::swap(name, other);
  }
  name.second = other.text;
  return name;
}

std::optional<Quantity> quantityOfName(const std::string& bare) { return quantityWith(bare, &QuantityNames::words); }

std::optional<Quantity> quantityOfOtherName(const std::string& bare) {
  return quantityWith(bare, &QuantityNames::others);
}

std::optional<Quantity> quantityOfUnit(const std::string& unit) {
  for (const QuantityNames& row : quantityTable()) {
    try {
      UnitConversion(spelledUnit(unit, row.unit), row.unit);
      return row.quantity;
    } catch (const std::invalid_argument&) {  // the unit measures another quantity
      continue;
    }
  }
  return std::nullopt;
}

std::string definedUnit(const std::string& bare) {
  const auto quantity = quantityWith(bare, &QuantityNames::defined);
  return quantity ? siUnit(*quantity) : "";
}

bool isCanonical(const std::string& text, Quantity quantity) {
  const QuantityNames& row = rowOf(quantity);
  return std::any_of(row.units.begin(), row.units.end(),
                     [&](const std::string& unit) { return text == std::string(row.name) + "_" + unit; });
}

std::optional<std::string> unitInField(const std::string& field) {
  const std::string unit = withoutBrackets(trimmed(field));
  if (unit.empty() || unit == "-") {
    return "";
  }
  return isKnownUnit(unit) ? std::optional<std::string>(unit) : std::nullopt;
}

}  // namespace rubber_suspension::log
