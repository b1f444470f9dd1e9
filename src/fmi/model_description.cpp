// modelDescription.xml of FMI 2.0 and 3.0: the same content in two vocabularies.
#include "fmi/model_description.h"

#include <fmt/format.h>
#include <tinyxml2.h>

#include <cmath>
#include <functional>
#include <set>
#include <utility>
#include <vector>

#include "fmi/runtime/instance.h"
#include "fmi/units.h"

namespace rubber_suspension::fmi {
namespace {

using Attributes = std::vector<std::pair<const char*, std::string>>;

// Elements of XML, one inside the other.
class Writer {
 public:
  Writer() { printer_.PushHeader(false, true); }

  void element(const char* name, const Attributes& attributes, const std::function<void()>& content = {}) {
    printer_.OpenElement(name);
    for (const auto& [key, value] : attributes) {
      printer_.PushAttribute(key, value.c_str());
    }
    if (content) {
      content();
    }
    printer_.CloseElement();
  }

  std::string text() const { return printer_.CStr(); }

 private:
  tinyxml2::XMLPrinter printer_;
};

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
void addValue(Attributes& attributes, const Variable& variable) {
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
}

class Description {
 public:
  Description(const ComponentData& data, Version version, std::string tool)
      : data_(data),
        variables_(VariableTable(data).variables()),
        second_(version == Version::fmi2),
        tool_(std::move(tool)) {}

  std::string text() {
    xml_.element("fmiModelDescription", rootAttributes(), [&] {
      Attributes interface = {{"modelIdentifier", data_.name}, {"canHandleVariableCommunicationStepSize", "true"}};
      if (second_ && !data_.six) {
        interface.emplace_back("canInterpolateInputs", "true");
      }
      interface.emplace_back(second_ ? "canGetAndSetFMUstate" : "canGetAndSetFMUState", "true");
      interface.emplace_back(second_ ? "canSerializeFMUstate" : "canSerializeFMUState", "true");
      xml_.element("CoSimulation", interface);
      xml_.element("UnitDefinitions", {}, [&] { writeUnits(); });
      xml_.element("LogCategories", {}, [&] {
        xml_.element("Category", {{"name", category::kEvents}, {"description", "changes of the phase"}});
        xml_.element("Category", {{"name", category::kDiscard}, {"description", "values that are refused"}});
        xml_.element("Category", {{"name", category::kError}, {"description", "errors"}});
      });
      xml_.element("DefaultExperiment", {{"startTime", "0"}, {"stepSize", "0.001"}});
      xml_.element("ModelVariables", {}, [&] { writeVariables(); });
      // At a communication point the outputs are those of the step before, whatever the input is set to; only in the
      // initialisation do they follow it.
      xml_.element("ModelStructure", {}, [&] {
        writeUnknowns("Outputs", "Output", isOutput, {{"dependencies", ""}});
        writeUnknowns("InitialUnknowns", "InitialUnknown", isCalculated, {});
      });
    });
    return xml_.text();
  }

 private:
  Attributes rootAttributes() const {
    Attributes attributes = {
        {"fmiVersion", second_ ? "2.0" : "3.0"},
        {"modelName", data_.name},
        {second_ ? "guid" : "instantiationToken", data_.guid},
        {"description", "rubber component " + data_.name +
                            (data_.six ? ", six directions: pose to wrench"
                                       : ", model " + estimation::toString(data_.model) + ": displacement to force")},
        {"generationTool", tool_},
        {"variableNamingConvention", "structured"}};
    if (second_) {
      attributes.emplace_back("numberOfEventIndicators", "0");
    }
    return attributes;
  }

  void writeUnits() {
    std::set<std::string> units;
    for (const Variable& variable : variables_) {
      units.insert(variable.unit);
    }
    units.erase("1");
    for (const std::string& unit : units) {
      xml_.element("Unit", {{"name", unit}}, [&] {
        Attributes exponents;
        const BaseUnit base = baseUnitOf(unit);
        for (const auto& [name, exponent] : base) {
          exponents.emplace_back(name.c_str(), std::to_string(exponent));
        }
        if (offsetOf(unit) != 0.0) {
          exponents.emplace_back("offset", number(offsetOf(unit)));
        }
        xml_.element("BaseUnit", exponents);
      });
    }
  }

  void writeVariables() {
    for (Reference i = 0; i < variables_.size(); ++i) {
      Attributes attributes = commonAttributes(variables_[i], i);
      if (second_) {
        Attributes value;
        addValue(value, variables_[i]);
        xml_.element("ScalarVariable", attributes, [&] { xml_.element("Real", value); });
      } else {
        addValue(attributes, variables_[i]);
        xml_.element("Float64", attributes);
      }
    }
  }

  // FMI 2.0 has a list of them and counts the variables from 1, FMI 3.0 names their references.
  void writeUnknowns(const char* list, const char* element, bool (*chosen)(const Variable&), const Attributes& more) {
    const auto write = [&] {
      for (Reference i = 0; i < variables_.size(); ++i) {
        if (chosen(variables_[i])) {
          Attributes attributes = {{second_ ? "index" : "valueReference", std::to_string(second_ ? i + 1 : i)}};
          attributes.insert(attributes.end(), more.begin(), more.end());
          xml_.element(second_ ? "Unknown" : element, attributes);
        }
      }
    };
    if (second_) {
      xml_.element(list, {}, write);
    } else {
      write();
    }
  }

  const ComponentData& data_;
  std::vector<Variable> variables_;
  bool second_;
  std::string tool_;
  Writer xml_;
};

}  // namespace

std::string modelDescription(const ComponentData& data, Version version, const std::string& tool) {
  return Description(data, version, tool).text();
}

}  // namespace rubber_suspension::fmi
