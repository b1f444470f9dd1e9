// modelDescription.xml of FMI 2.0 and 3.0: the same content in two vocabularies.
#include "fmi/model_description.h"

#include <fmt/format.h>
#include <tinyxml2.h>

#include <cmath>
#include <functional>
#include <set>
#include <utility>

#include "fmi/runtime/instance.h"
#include "fmi/units.h"

namespace rubber_suspension::fmi {
namespace {

using Attributes = std::vector<std::pair<std::string, std::string>>;

void append(Attributes& attributes, const Attributes& more) {
  attributes.insert(attributes.end(), more.begin(), more.end());
}

std::string number(double value) { return fmt::format("{}", value); }

bool isOutput(const Variable& variable) { return variable.causality == Causality::output; }

// It has to be found before the first step.
bool isCalculated(const Variable& variable) {
  return isOutput(variable) || variable.causality == Causality::calculated_parameter;
}

// Name, meaning and kind, alike in both versions.
Attributes commonAttributes(const Variable& variable, Reference reference) {
  static const char* const causalities[] = {"independent", "input", "output", "parameter", "calculatedParameter"};
  const bool is_parameter = variable.causality >= Causality::parameter;
  Attributes attributes = {{"name", variable.name},
                           {"valueReference", std::to_string(reference)},
                           {"description", variable.description},
                           {"causality", causalities[static_cast<std::size_t>(variable.causality)]},
                           {"variability", is_parameter ? "fixed" : "continuous"}};
  if (is_parameter || isOutput(variable)) {
    attributes.emplace_back("initial", isCalculated(variable) ? "calculated" : "exact");
  }
  return attributes;
}

// Unit, range and start value, alike in both versions.
Attributes valueAttributes(const Variable& variable) {
  Attributes attributes;
  if (variable.unit != "1") {
    attributes.emplace_back("unit", variable.unit);
  }
  for (const auto& [key, bound] : {std::pair("min", variable.range.lower), std::pair("max", variable.range.upper)}) {
    if (std::isfinite(bound)) {
      attributes.emplace_back(key, number(bound));
    }
  }
  if (variable.start) {
    attributes.emplace_back("start", number(*variable.start));
  }
  return attributes;
}

class Description {
 public:
  Description(const ComponentData& data, Version version, const std::string& tool)
      : data_(data), variables_(VariableTable(data).variables()), second_(version == Version::fmi2) {
    printer_.PushHeader(false, true);
    const std::string what = data.six ? ", six directions: pose to wrench"
                                      : ", model " + estimation::toString(data.model) + ": displacement to force";
    Attributes root = {{"fmiVersion", second_ ? "2.0" : "3.0"},
                       {"modelName", data.name},
                       {second_ ? "guid" : "instantiationToken", data.guid},
                       {"description", "rubber component " + data.name + what},
                       {"generationTool", tool},
                       {"variableNamingConvention", "structured"}};
    if (second_) {
      root.emplace_back("numberOfEventIndicators", "0");
    }
    element("fmiModelDescription", root, [this] { writeContent(); });
  }

  std::string text() const { return printer_.CStr(); }

 private:
  // Elements of XML, one inside the other.
  void element(const char* name, const Attributes& attributes, const std::function<void()>& content = {}) {
    printer_.OpenElement(name);
    for (const auto& [key, value] : attributes) {
      printer_.PushAttribute(key.c_str(), value.c_str());
    }
    if (content) {
      content();
    }
    printer_.CloseElement();
  }

  void writeContent() {
    const std::string state = second_ ? "FMUstate" : "FMUState";
    Attributes interface = {{"modelIdentifier", data_.name}, {"canHandleVariableCommunicationStepSize", "true"}};
    if (second_ && !data_.six) {
      interface.emplace_back("canInterpolateInputs", "true");
    }
    append(interface, {{"canGetAndSet" + state, "true"}, {"canSerialize" + state, "true"}});
    element("CoSimulation", interface);
    element("UnitDefinitions", {}, [this] { writeUnits(); });
    element("LogCategories", {}, [this] {
      for (const LogCategory& category : kLogCategories) {
        element("Category", {{"name", category.name}, {"description", category.description}});
      }
    });
    element("DefaultExperiment", {{"startTime", "0"}, {"stepSize", "0.001"}});
    element("ModelVariables", {}, [this] { writeVariables(); });
    // At a communication point the outputs are those of the step before, whatever the input is set to; only in the
    // initialisation do they follow it.
    element("ModelStructure", {}, [this] {
      writeUnknowns("Output", isOutput, {{"dependencies", ""}});
      writeUnknowns("InitialUnknown", isCalculated, {});
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
      if (offsetOf(unit) != 0.0) {
        base.emplace_back("offset", number(offsetOf(unit)));
      }
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
        append(attributes, value);
        element("Float64", attributes);
      }
    }
  }

  // FMI 2.0 has a list of them and counts the variables from 1, FMI 3.0 names their references.
  void writeUnknowns(const std::string& kind, bool (*chosen)(const Variable&), const Attributes& more) {
    const auto write = [&] {
      for (Reference i = 0; i < variables_.size(); ++i) {
        if (chosen(variables_[i])) {
          Attributes attributes = {{second_ ? "index" : "valueReference", std::to_string(second_ ? i + 1 : i)}};
          append(attributes, more);
          element(second_ ? "Unknown" : kind.c_str(), attributes);
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

std::string modelDescription(const ComponentData& data, Version version, const std::string& tool) {
  return Description(data, version, tool).text();
}

}  // namespace rubber_suspension::fmi
