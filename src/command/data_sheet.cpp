// Data sheets in YAML.
#include "command/data_sheet.h"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <map>
#include <stdexcept>

#include "element/refuse.h"
#include "element/suggestion.h"
#include "log/text.h"
#include "rubber_suspension/estimation/notes.h"
#include "rubber_suspension/log/units.h"

namespace rubber_suspension::command {
namespace {

constexpr const char* kNote = "# ";
constexpr std::size_t kMaximumSize = 64 * 1024;  // bytes; a data sheet is some lines

// Those of a data sheet and those of a specification.
const std::vector<element::ParameterInfo>& allParameters() {
  static const std::vector<element::ParameterInfo> all = [] {
    std::vector<element::ParameterInfo> table = estimation::dataSheetParameters();
    const std::vector<element::ParameterInfo>& further = estimation::specificationParameters();
    table.insert(table.end(), further.begin(), further.end());
    return table;
  }();
  return all;
}

struct Sheet {
  std::string component;
  std::optional<estimation::Model> model;
  std::optional<estimation::LoadDirection> load;
  std::map<std::string, double> values;
};

estimation::Model modelOf(const std::string& name) {
  const auto model = estimation::modelFromString(name);
  element::refuseIf(!model || *model == estimation::Model::elements,
                    "model: '{}' is not a model; accepted: kelvin_voigt, maxwell, "
                    "maxwell_dashpot, friction, friction_dashpot, berg, multi_maxwell",
                    name);
  return *model;
}

estimation::LoadDirection loadOf(const std::string& name) {
  element::refuseIf(name != "compression" && name != "shear", "load: '{}'; accepted: compression, shear", name);
  return name == "shear" ? estimation::LoadDirection::shear : estimation::LoadDirection::compression;
}

double quantityOf(const std::string& key, const std::string& text) {
  const element::ParameterInfo* parameter = element::findParameter(allParameters(), key);
  element::refuseIf(parameter == nullptr, "{}: unknown key; accepted: component, model, load, {}", key,
                    log::join(element::namesOf(allParameters())));
  try {
    return log::parseQuantity(text, parameter->unit);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("{}: {}: {}; accepted: a number in {}, or text with such a unit", key,
                                            log::quoted(text), error.what(), parameter->unit));
  }
}

Sheet readSheet(const YAML::Node& root) {
  element::refuseIf(!root.IsMap() || root.size() != 1 || !root["data_sheet"] || !root["data_sheet"].IsMap(),
                    "accepted: a map with the one key data_sheet, which is a map");
  Sheet sheet;
  std::map<std::string, int> seen;
  for (const auto& entry : root["data_sheet"]) {
    element::refuseIf(!entry.first.IsScalar() || !entry.second.IsScalar(),
                      "data_sheet: every key takes one number or text");
    const auto key = entry.first.as<std::string>();
    const auto text = entry.second.as<std::string>();
    element::refuseIf(++seen[key] > 1, "{}: stands twice; accepted: once", key);
    if (key == "component") {
      sheet.component = text;
    } else if (key == "model") {
      sheet.model = modelOf(text);
    } else if (key == "load") {
      sheet.load = loadOf(text);
    } else {
      sheet.values[key] = quantityOf(key, text);
    }
  }
  return sheet;
}

std::string convert(const std::string& text) {
  const Sheet sheet = readSheet(YAML::Load(text));
  element::refuseIf(sheet.component.empty(), "component: missing; needed is the name of the component");
  element::refuseIf(sheet.load.has_value() != (sheet.values.count("shore_a") != 0),
                    "load: goes with shore_a; accepted: both (load: compression or shear) or none");
  const estimation::DataSheetResult result = estimation::specificationFromDataSheet(
      sheet.model, sheet.load.value_or(estimation::LoadDirection::compression), sheet.values);
  const io::ComponentDescription description(sheet.component, result.model, result.specification);
  std::string file = "# Component file from a data sheet.\n";
  std::vector<std::string> notes = result.notes;
  if (!sheet.model) {
    notes.push_back(fmt::format("model {}, the simplest that takes all of these numbers; say model to choose another",
                                estimation::toString(result.model)));
  }
  const std::vector<std::string> of_estimation = estimation::estimationNotes(result.model, result.specification);
  notes.insert(notes.end(), of_estimation.begin(), of_estimation.end());
  for (const std::string& note : notes) {
    file += kNote + note + "\n";
  }
  file += io::toYaml({description});
  io::parseComponentFile(file, "component file");  // the name, too, has to be one that the node takes
  return file;
}

}  // namespace

std::string componentFileFromDataSheetText(const std::string& text, const std::string& source) {
  try {
    return convert(text);
  } catch (const YAML::Exception& error) {
    throw std::invalid_argument(
        fmt::format("{}:{}: not YAML: {}; accepted: a data sheet", source, error.mark.line + 1, error.msg));
  } catch (const std::exception& error) {
    throw std::invalid_argument(source + ": " + error.what());
  }
}

std::string componentFileFromDataSheet(const std::string& path) {
  return componentFileFromDataSheetText(log::readInput(path, kMaximumSize), path);
}

}  // namespace rubber_suspension::command
