// Reader of numbers, elements and temperature laws, which uses the table of laws.
#include "io/element_reader.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "element/largest_number.h"
#include "io/cancellation.h"
#include "io/component_words.h"
#include "io/rotational_unit.h"
#include "log/text.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/log/units.h"

namespace rubber_suspension::io {
namespace {

using element::namesOf;

constexpr const char* kVertical = "vertical";

// Describes the range of a parameter in the user's unit, which must have the dimension of the parameter.
std::string acceptedIn(const std::string& unit, const element::ParameterInfo& parameter) {
  if (unit.empty()) {
    return accepted(parameter);
  }
  const log::UnitConversion to_written(parameter.unit, unit);
  element::Range range = parameter.range;
  range.lower = to_written(range.lower);
  range.upper = to_written(range.upper);
  return element::describe(range) + " " + unit;
}

}  // namespace

std::vector<std::string> modelNames() {
  std::vector<std::string> names;
  for (int i = static_cast<int>(estimation::Model::kelvin_voigt); i <= static_cast<int>(estimation::Model::elements);
       ++i) {
    names.push_back(estimation::toString(static_cast<estimation::Model>(i)));
  }
  return names;
}

std::string accepted(const element::ParameterInfo& parameter) {
  const element::Range& range = parameter.range;
  const bool bounded = std::isfinite(range.lower) || std::isfinite(range.upper);
  const std::string number = bounded ? "a number " + element::describe(range) : element::describe(range);
  const std::string& meaning = parameter.documentation;
  if (parameter.role == element::Role::choice && !meaning.empty() && std::isdigit(meaning.front()) != 0) {
    return meaning;  // the documentation of such a choice lists its values
  }
  if (parameter.unit == "1") {
    return number + (range.upper <= 1.0 ? ", or in %" : "");
  }
  return fmt::format("{}, in {}, or text with such a unit", number, parameter.unit);
}

element::ParameterInfo anyNumber(const std::string& unit, element::Range range) {
  return {"", unit, element::Role::choice, range, "", {}, true};
}

element::ParameterInfo ElementReader::here(element::ParameterInfo parameter) const {
  parameter.unit = rotational_ ? rotationalUnit(parameter.unit) : parameter.unit;
  return parameter;
}

double ElementReader::loadNumber(const Entry& entry, const element::ParameterInfo& row) {
  const element::ParameterInfo parameter = here(row);
  if (!entry.isText()) {
    refuse(entry, fmt::format("{} is not a number; accepted: {}", kindOf(entry.node), accepted(parameter)));
  }
  const std::string text = log::quoted(entry.text());
  double value = 0.0;
  std::string unit;
  try {
    value = log::parseQuantity(entry.text(), parameter.unit);
    unit = log::unitOfQuantity(entry.text());
  } catch (const std::invalid_argument& error) {
    refuse(entry, fmt::format("{}: {}; accepted: {}", text, error.what(), accepted(parameter)));
  }
  if (!unit.empty() && parameter.unit != "1" && parameter.unit != "K" && parameter.unit != "degC") {
    units_.emplace(parameter.unit, unit);
  }
  // A parameter in K is a temperature difference, so units with an offset from K, such as degC, are refused.
  if (!unit.empty() && parameter.unit == "K" && log::UnitConversion(unit, parameter.unit)(0.0) != 0.0) {
    refuse(entry,
           fmt::format("{} is a temperature, not a temperature difference; accepted: {}", text, accepted(parameter)));
  }
  constexpr double kLongestTime = 1e12;  // [s], 30,000 years: stepping through a longer time would never end
  const double most = parameter.unit == "s" ? kLongestTime : element::kLargestNumber;
  if (std::isfinite(value) && std::abs(value) > most) {
    refuse(entry, fmt::format("{} is larger than any component can have; accepted: at most {:g} {}", text, most,
                              parameter.unit));
  }
  if (!parameter.range.contains(value)) {
    const std::string hint = value > 0.0 && value < element::kSmallestNumber
                                 ? fmt::format(", at least {:g} {}", element::kSmallestNumber, parameter.unit)
                             : parameter.name == "maxwell_elements" && value == 1.0
                                 ? ", or model: maxwell for a single element"
                                 : "";
    refuse(entry, fmt::format("{} is {}; accepted: {}{}", text, std::isfinite(value) ? "out of range" : "not finite",
                              acceptedIn(unit, parameter), hint));
  }
  return value;
}

std::vector<double> ElementReader::loadNumbers(const Entry& entry, const element::ParameterInfo& parameter) {
  if (!parameter.is_list || entry.isText()) {
    return {loadNumber(entry, parameter)};
  }
  if (!entry.node.IsSequence() || entry.node.size() == 0 || entry.node.size() > kMaximumListLength) {
    refuseContent(entry,
                  fmt::format("a list of 1 to {} numbers, each {}", kMaximumListLength, accepted(here(parameter))));
  }
  std::vector<double> values;
  for (std::size_t i = 0; i < entry.node.size(); ++i) {
    values.push_back(loadNumber(entry[i], parameter));
  }
  return values;
}

double ElementReader::loadTolerance(const Entry& entry, const std::string& also) {
  if (entry.isText() && entry.text() == kGuess) {
    return estimation::SheetTolerance::kGuess;
  }
  if (!entry.startsAsNumber()) {
    refuse(entry, fmt::format("{} is not a tolerance{}; accepted: a share such as 10 %, {}{}", kindOf(entry.node),
                              hintOf(entry.node, {kGuess}), kGuess, also));
  }
  return loadNumber(entry, anyNumber("1", element::Range::openBelow(0.0, 1.0)));
}

std::vector<element::ElementDescription> ElementReader::loadElements(const Entry& list,
                                                                     const estimation::Specification* specification,
                                                                     Tolerances* tolerances) {
  if (!list.node.IsSequence()) {
    refuseContent(list, "a list of elements");
  }
  if (list.node.size() > kMaximumElements) {
    refuse(list, fmt::format("the list has {} elements; accepted: at most {}", list.node.size(), kMaximumElements));
  }
  std::vector<element::ElementDescription> elements;
  for (std::size_t i = 0; i < list.node.size(); ++i) {
    elements.push_back(loadElement(list[i], specification, tolerances != nullptr));
    const Entry own = list[i]["tolerance"];
    if (tolerances != nullptr && own) {
      (*tolerances)[fmt::format("{}[{}]", elements.back().type, i)] = loadTolerance(own);
    }
  }
  return elements;
}

element::ElementDescription ElementReader::loadTemperature(const Entry& entry) {
  requireMap(entry, "a map with the key 'shift'");
  checkUnique(entry);
  const ShiftLaw& law = loadShift(entry);
  const std::vector<element::ParameterInfo>& table = element::findElementType(law.type)->parameters;
  std::vector<std::string> keys = namesOf(table);
  keys.insert(keys.begin(), "shift");
  checkKeys(entry, keys);
  element::ElementDescription description{law.type, {}};
  for (element::ParameterInfo parameter : table) {
    if (parameter.name == "activation_energy") {
      parameter.range = element::Range::openBelow(0.0, parameter.range.upper);
    }
    if (parameter.name != kVertical) {
      description.values[parameter.name] = {loadNumber(require(entry, parameter.name, accepted(parameter)), parameter)};
    } else if (const Entry value = entry[kVertical]) {
      description.values[kVertical] = {loadVertical(value, parameter, description.value("reference"))};
    }
  }
  return description;
}

const element::ElementType& ElementReader::loadType(const Entry& entry) {
  requireMap(entry, "a map with the key 'type'");
  checkUnique(entry);
  const std::vector<element::ElementType>& types = element::elementTypes();
  return types[loadWord(require(entry, "type", log::join(namesOf(types))), namesOf(types), "an element")];
}

element::ElementDescription ElementReader::loadElement(const Entry& entry,
                                                       const estimation::Specification* specification,
                                                       bool with_tolerance) {
  checkCancelled();
  const element::ElementType& type = loadType(entry);
  std::vector<std::string> keys = namesOf(type.parameters);
  keys.insert(keys.begin(), "type");
  keys.insert(keys.end(), {"scale_with", "of_rig"});
  if (with_tolerance) {
    keys.emplace_back("tolerance");
  }
  checkKeys(entry, keys);
  element::ElementDescription description;
  description.type = type.name;
  for (const element::ParameterInfo& parameter : type.parameters) {
    if (!parameter.default_value || entry[parameter.name]) {
      const Entry value = require(entry, parameter.name, accepted(here(parameter)));
      description.values[parameter.name] = loadNumbers(value, parameter);
    }
  }
  try {
    const bool of_chain = element::lawOf(element::makeElement(description)).ofMeasuringChain();
    if (const Entry mark = entry["of_rig"]) {
      description.of_rig = loadFlag(mark) && !of_chain;
      if (of_chain && !loadFlag(mark)) {
        refuse(mark, "is false, but this element describes the measuring chain and never the rubber; accepted: true");
      }
    }
    return scaled(description, entry["scale_with"], specification);
  } catch (const std::invalid_argument& error) {
    refuse(entry, error.what());
  }
}

element::ElementDescription ElementReader::scaled(const element::ElementDescription& description, const Entry& scale,
                                                  const estimation::Specification* specification) const {
  if (!scale || !loadScale(scale)) {
    return description;
  }
  const estimation::StaticCurve* curve = specification == nullptr ? nullptr : specification->curve();
  if (curve == nullptr) {
    refuse(scale, "the component has no static_curve; accepted: none, or a static_curve in its specification");
  }
  element::ElementDescription scaled =
      estimation::scaledAlong(*curve, estimation::nominalDisplacement(*specification), description);
  scaled.of_rig = description.of_rig;
  return scaled;
}

const ShiftLaw& ElementReader::loadShift(const Entry& entry) const {
  const std::vector<std::string> names = namesOf(shiftLaws());
  return shiftLaws()[loadWord(require(entry, "shift", log::join(names)), names, "a temperature law")];
}

double ElementReader::loadVertical(const Entry& entry, const element::ParameterInfo& parameter, double reference) {
  if (entry.isText() && entry.text() == "proportional") {
    return 1.0 / (reference + element::kZeroCelsius);
  }
  if (entry.isText() && entry.text() == "none") {
    return 0.0;
  }
  if (!entry.startsAsNumber()) {
    refuse(entry, fmt::format("{} is not a vertical shift{}; accepted: proportional (b_T = T/T_0), none, or {}",
                              kindOf(entry.node), hintOf(entry.node, {"proportional", "none"}), accepted(parameter)));
  }
  return loadNumber(entry, parameter);
}
}  // namespace rubber_suspension::io
