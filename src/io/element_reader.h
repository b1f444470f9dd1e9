// Reader of numbers with units, elements and temperature laws.
#pragma once

#include "io/component_words.h"
#include "io/yaml_reader.h"

namespace rubber_suspension::io {

std::vector<std::string> modelNames();

/// Describes the accepted values of a parameter, as in "a number > 0, in N/m, or text with such a unit".
std::string accepted(const element::ParameterInfo& parameter);

/// Returns a ParameterInfo for a number or a list of numbers in this unit, for values that have no row in a table.
element::ParameterInfo anyNumber(const std::string& unit, element::Range range = element::Range::any());

class ElementReader : public YamlReader {
 protected:
  using YamlReader::YamlReader;

  /// Returns a row of a table with the unit that the parameter has in the direction being read.
  element::ParameterInfo here(element::ParameterInfo parameter) const;

  double loadNumber(const Entry& entry, const element::ParameterInfo& row);
  std::vector<double> loadNumbers(const Entry& entry, const element::ParameterInfo& parameter);

  /// Reads a tolerance, which is a share or the word `guess`. Errors list `also` among the accepted values.
  double loadTolerance(const Entry& entry, const std::string& also = "");

  using Tolerances = std::map<std::string, double, std::less<>>;

  /// Reads a list of elements. If `specification` is given, elements may scale along its static curve. `tolerances`
  /// receives the tolerances of entries under names such as "spring[0]". If it is nullptr, entries must not have
  /// tolerances.
  std::vector<element::ElementDescription> loadElements(const Entry& list,
                                                        const estimation::Specification* specification = nullptr,
                                                        Tolerances* tolerances = nullptr);

  element::ElementDescription loadTemperature(const Entry& entry);

  /// Returns true if the entry is `static_curve`, so that the element scales with this curve.
  bool loadScale(const Entry& entry) const { return loadWord(entry, {"static_curve", "none"}) == 0; }

  std::map<std::string, std::string> units_;  ///< the unit that the component uses for each SI unit
  bool rotational_ = false;                   ///< true if the direction being read is a rotation

 private:
  const element::ElementType& loadType(const Entry& entry);
  element::ElementDescription loadElement(const Entry& entry, const estimation::Specification* specification,
                                          bool with_tolerance);
  element::ElementDescription scaled(const element::ElementDescription& description, const Entry& scale,
                                     const estimation::Specification* specification) const;
  const ShiftLaw& loadShift(const Entry& entry) const;
  double loadVertical(const Entry& entry, const element::ParameterInfo& parameter, double reference);
};

}  // namespace rubber_suspension::io
