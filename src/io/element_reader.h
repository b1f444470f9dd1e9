// Reading of numbers with units, elements and laws of temperature.
#pragma once

#include "io/component_words.h"
#include "io/yaml_reader.h"

namespace rubber_suspension::io {

/// In the order of estimation::Model.
std::vector<std::string> modelNames();

/// Accepted values of a parameter: "a number > 0, in N/m, or text with such a unit".
std::string accepted(const element::ParameterInfo& parameter);

/// A number of this unit, or a list of such, without a row in a table.
element::ParameterInfo anyNumber(const std::string& unit, element::Range range = element::Range::any());

/// YamlReader that knows the table of elements.
class ElementReader : public YamlReader {
 protected:
  using YamlReader::YamlReader;

  /// A row of a table as the direction that is being read has it.
  element::ParameterInfo here(element::ParameterInfo parameter) const;

  double loadNumber(const Entry& entry, const element::ParameterInfo& row);
  std::vector<double> loadNumbers(const Entry& entry, const element::ParameterInfo& parameter);

  /// A share, or `guess`; `also`: what else is accepted.
  double loadTolerance(const Entry& entry, const std::string& also = "");

  using Tolerances = std::map<std::string, double, std::less<>>;

  /// They may scale along the curve of a specification, where there is one. `tolerances`: of their values, by entries
  /// such as "spring[0]"; nullptr where entries have none.
  std::vector<element::ElementDescription> loadElements(const Entry& list,
                                                        const estimation::Specification* specification = nullptr,
                                                        Tolerances* tolerances = nullptr);

  element::ElementDescription loadTemperature(const Entry& entry);

  /// True if the entry scales with the static curve.
  bool loadScale(const Entry& entry) const { return loadWord(entry, {"static_curve", "none"}) == 0; }

  std::map<std::string, std::string> units_;  ///< of the component's numbers, by the SI unit
  bool rotational_ = false;                   ///< of the direction being read

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
