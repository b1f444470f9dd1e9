// modelDescription.xml of FMI 2.0 and 3.0, which have the same content with different names.
#include "fmi/model_description.h"

#include <fmt/format.h>
#include <tinyxml2.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <utility>

#include "element/refuse.h"
#include "fmi/runtime/instance.h"
#include "rubber_suspension/element/temperature_shift.h"

namespace rubber_suspension::fmi {
namespace {

using Attributes = std::vector<std::pair<std::string, std::string>>;

std::string number(double value) { return fmt::format("{}", value); }

bool isOutput(const Variable& variable) { return variable.causality == Causality::output; }

// Returns true for variables that are calculated before the first step.
bool isCalculated(const Variable& variable) {
  return isOutput(variable) || variable.causality == Causality::calculated_parameter;
}

Attributes commonAttributes(const Variable& variable, Reference reference) {
  static const char* const causalities[] = {"independent", "input", "output", "parameter", "calculatedParameter"};
  const bool is_parameter = variable.causality >= Causality::parameter;
  return {{"name", variable.name},
          {"valueReference", std::to_string(reference)},
          {"description", variable.description},
          {"causality", causalities[static_cast<std::size_t>(variable.causality)]},
          {"variability", is_parameter ? "fixed" : "continuous"},
          {is_parameter || isOutput(variable) ? "initial" : "", isCalculated(variable) ? "calculated" : "exact"}};
}

Attributes valueAttributes(const Variable& variable) {
  return {{variable.unit == "1" ? "" : "unit", variable.unit},
          {std::isfinite(variable.range.lower) ? "min" : "", number(variable.range.lower)},
          {std::isfinite(variable.range.upper) ? "max" : "", number(variable.range.upper)},
          {variable.start ? "start" : "", number(variable.start.value_or(0.0))}};
}

// Units in terms of other units; empty for base units.
const std::map<std::string, std::string> kSymbols = {
    {"kg", ""}, {"m", ""},     {"s", ""},         {"A", ""},       {"K", ""},    {"rad", ""},  {"mol", ""},
    {"1", "1"}, {"Hz", "1/s"}, {"N", "kg m/s^2"}, {"Pa", "N/m^2"}, {"J", "N m"}, {"W", "J/s"}, {"degC", "K"}};

class Description {
 public:
  Description(const ComponentData& data, Version version, const std::string& tool)
      : data_(data), variables_(VariableTable(data).variables()), second_(version == Version::fmi2) {
    printer_.PushHeader(false, true);
    const std::string what = data.six ? ", six directions: pose to wrench"
                                      : ", model " + estimation::toString(data.model) + ": displacement to force";
    const Attributes root = {{"fmiVersion", second_ ? "2.0" : "3.0"},
                             {"modelName", data.name},
                             {second_ ? "guid" : "instantiationToken", data.guid},
                             {"description", "rubber component " + data.name + what},
                             {"generationTool", tool},
                             {"variableNamingConvention", "structured"},
                             {second_ ? "numberOfEventIndicators" : "", "0"}};
    element("fmiModelDescription", root, [this] { writeContent(); });
  }

  std::string text() const { return printer_.CStr(); }

 private:
  void element(const char* name, const Attributes& attributes, const std::function<void()>& content = {}) {
    printer_.OpenElement(name);
    for (const auto& [key, value] : attributes) {
      if (!key.empty()) {
        printer_.PushAttribute(key.c_str(), value.c_str());
      }
    }
    if (content) {
      content();
    }
    printer_.CloseElement();
  }

  void writeContent() {
    const std::string state = second_ ? "FMUstate" : "FMUState";
    element("CoSimulation", {{"modelIdentifier", data_.name},
                             {"canHandleVariableCommunicationStepSize", "true"},
                             {second_ && !data_.six ? "canInterpolateInputs" : "", "true"},
                             {"canGetAndSet" + state, "true"},
                             {"canSerialize" + state, "true"}});
    element("UnitDefinitions", {}, [this] { writeUnits(); });
    element("LogCategories", {}, [this] {
      for (const LogCategory& category : kLogCategories) {
        element("Category", {{"name", category.name}, {"description", category.description}});
      }
    });
    element("DefaultExperiment", {{"startTime", "0"}, {"stepSize", "0.001"}});
    element("ModelVariables", {}, [this] { writeVariables(); });
    // At a communication point the outputs result from the last step. Only initial outputs depend on the present input.
    element("ModelStructure", {}, [this] {
      writeUnknowns("Output", isOutput, "dependencies");
      writeUnknowns("InitialUnknown", isCalculated, "");
    });
  }

  void writeUnits() {
    std::set<std::string> units;
    for (const Variable& variable : variables_) {
      units.insert(variable.unit);
    }
    units.erase("1");
    for (const std::string& unit : units) {
      Attributes base;
      for (const auto& [name, exponent] : baseUnitOf(unit)) {
        base.emplace_back(name, std::to_string(exponent));
      }
      base.emplace_back(offsetOf(unit) == 0.0 ? "" : "offset", number(offsetOf(unit)));
      element("Unit", {{"name", unit}}, [&] { element("BaseUnit", base); });
    }
  }

  void writeVariables() {
    for (Reference i = 0; i < variables_.size(); ++i) {
      Attributes attributes = commonAttributes(variables_[i], i);
      const Attributes value = valueAttributes(variables_[i]);
      if (second_) {
        element("ScalarVariable", attributes, [&] { element("Real", value); });
      } else {
        attributes.insert(attributes.end(), value.begin(), value.end());
        element("Float64", attributes);
      }
    }
  }

  // FMI 2.0 needs a list of the unknowns with variables numbered from 1, FMI 3.0 their value references.
  void writeUnknowns(const std::string& kind, bool (*chosen)(const Variable&), const char* dependencies) {
    const auto write = [&] {
      for (Reference i = 0; i < variables_.size(); ++i) {
        if (chosen(variables_[i])) {
          element(second_ ? "Unknown" : kind.c_str(),
                  {{second_ ? "index" : "valueReference", std::to_string(second_ ? i + 1 : i)}, {dependencies, ""}});
        }
      }
    };
    if (second_) {
      element((kind + "s").c_str(), {}, write);
    } else {
      write();
    }
  }

  const ComponentData& data_;
  std::vector<Variable> variables_;
  bool second_;
  tinyxml2::XMLPrinter printer_;
};

}  // namespace

// In a unit, a blank before a symbol multiplies by it, and a slash divides by it. A symbol may have an exponent.
BaseUnit baseUnitOf(const std::string& unit) {
  BaseUnit sum;
  int sign = 1;
  for (std::size_t begin = 0; begin <= unit.size();) {
    const std::size_t end = std::min(unit.find_first_of(" /", begin), unit.size());
    const std::string factor = unit.substr(begin, end - begin);  // "m^3" has three times the exponents of "m"
    const std::size_t caret = factor.find('^');
    const auto symbol = kSymbols.find(factor.substr(0, caret));
    const std::string power = caret == std::string::npos ? "1" : factor.substr(caret + 1);
    element::refuseIf(
        symbol == kSymbols.end() || power.empty() || power.find_first_not_of("0123456789") != std::string::npos,
        "unit '{}': the base units of '{}' are unknown", unit, factor);
    const auto& [name, meaning] = *symbol;
    for (const auto& [base, exponent] : meaning.empty()  ? BaseUnit{{name, 1}}
                                        : meaning == "1" ? BaseUnit{}
                                                         : baseUnitOf(meaning)) {
      if ((sum[base] += sign * std::stoi(power) * exponent) == 0) {
        sum.erase(base);
      }
    }
    sign = end < unit.size() && unit[end] == '/' ? -1 : 1;
    begin = end + 1;
  }
  return sum;
}

double offsetOf(const std::string& unit) { return unit == "degC" ? element::kZeroCelsius : 0.0; }

std::string modelDescription(const ComponentData& data, Version version, const std::string& tool) {
  return Description(data, version, tool).text();
}

}  // namespace rubber_suspension::fmi
