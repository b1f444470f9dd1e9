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

std::string causalityText(Causality causality) {
  switch (causality) {
    case Causality::independent:
      return "independent";
    case Causality::input:
      return "input";
    case Causality::output:
      return "output";
    case Causality::parameter:
      return "parameter";
    case Causality::calculated_parameter:
      return "calculatedParameter";
  }
  return "";
}

bool isParameter(const Variable& variable) {
  return variable.causality == Causality::parameter || variable.causality == Causality::calculated_parameter;
}

// Name, meaning and kind, alike in both versions.
Attributes commonAttributes(const Variable& variable, Reference reference) {
  Attributes attributes = {{"name", variable.name},
                           {"valueReference", std::to_string(reference)},
                           {"description", variable.description},
                           {"causality", causalityText(variable.causality)},
                           {"variability", isParameter(variable) ? "fixed" : "continuous"}};
  if (variable.causality == Causality::parameter) {
    attributes.emplace_back("initial", "exact");
  } else if (variable.causality == Causality::output || variable.causality == Causality::calculated_parameter) {
    attributes.emplace_back("initial", "calculated");
  }
  return attributes;
}

// Unit, range and start value, alike in both versions.
Attributes valueAttributes(const Variable& variable) {
  Attributes attributes;
  if (variable.unit != "1") {
    attributes.emplace_back("unit", variable.unit);
  }
  if (std::isfinite(variable.range.lower)) {
    attributes.emplace_back("min", number(variable.range.lower));
  }
  if (std::isfinite(variable.range.upper)) {
    attributes.emplace_back("max", number(variable.range.upper));
  }
  if (variable.start) {
    attributes.emplace_back("start", number(*variable.start));
  }
  return attributes;
}

Attributes joined(Attributes first, const Attributes& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

// What has to be found before the first step.
bool isInitialUnknown(const Variable& variable) {
  return variable.causality == Causality::output || variable.causality == Causality::calculated_parameter;
}

class Description {
 public:
  Description(const ComponentData& data, Version version, std::string tool)
      : data_(data), table_(data), version_(version), tool_(std::move(tool)) {}

  std::string text() {
    xml_.element("fmiModelDescription", rootAttributes(), [&] {
      writeInterface();
      writeUnits();
      writeCategories();
      xml_.element("DefaultExperiment", {{"startTime", "0"}, {"stepSize", "0.001"}});
      xml_.element("ModelVariables", {}, [&] { writeVariables(); });
      xml_.element("ModelStructure", {}, [&] { isSecond() ? writeStructure2() : writeStructure3(); });
    });
    return xml_.text();
  }

 private:
  bool isSecond() const { return version_ == Version::fmi2; }

  Attributes rootAttributes() const {
    Attributes attributes = {{"fmiVersion", isSecond() ? "2.0" : "3.0"},
                             {"modelName", data_.name},
                             {isSecond() ? "guid" : "instantiationToken", data_.guid},
                             {"description", "rubber component " + data_.name + ", model " +
                                                 estimation::toString(data_.model) + ": displacement to force"},
                             {"generationTool", tool_},
                             {"variableNamingConvention", "structured"}};
    if (isSecond()) {
      attributes.emplace_back("numberOfEventIndicators", "0");
    }
    return attributes;
  }

  void writeInterface() {
    Attributes attributes = {{"modelIdentifier", data_.name}, {"canHandleVariableCommunicationStepSize", "true"}};
    if (isSecond()) {
      attributes.emplace_back("canInterpolateInputs", "true");
    }
    attributes.emplace_back(isSecond() ? "canGetAndSetFMUstate" : "canGetAndSetFMUState", "true");
    attributes.emplace_back(isSecond() ? "canSerializeFMUstate" : "canSerializeFMUState", "true");
    xml_.element("CoSimulation", attributes);
  }

  void writeUnits() {
    std::set<std::string> units;
    for (const Variable& variable : table_.variables()) {
      units.insert(variable.unit);
    }
    units.erase("1");
    xml_.element("UnitDefinitions", {}, [&] {
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
    });
  }

  void writeCategories() {
    xml_.element("LogCategories", {}, [&] {
      xml_.element("Category", {{"name", category::kEvents}, {"description", "changes of the phase"}});
      xml_.element("Category", {{"name", category::kDiscard}, {"description", "values that are refused"}});
      xml_.element("Category", {{"name", category::kError}, {"description", "errors"}});
    });
  }

  void writeVariables() {
    for (Reference i = 0; i < table_.variables().size(); ++i) {
      const Variable& variable = table_.variables()[i];
      const Attributes common = commonAttributes(variable, i);
      if (isSecond()) {
        xml_.element("ScalarVariable", common, [&] { xml_.element("Real", valueAttributes(variable)); });
      } else {
        xml_.element("Float64", joined(common, valueAttributes(variable)));
      }
    }
  }

  // At a communication point the outputs are those of the step before, whatever the input is set to; only in the
  // initialisation do they follow it.
  void writeStructure2() {
    xml_.element("Outputs", {}, [&] {
      forEach([](const Variable& variable) { return variable.causality == Causality::output; },
              [&](Reference i) {
                xml_.element("Unknown", {{"index", std::to_string(i + 1)}, {"dependencies", ""}});
              });
    });
    xml_.element("InitialUnknowns", {}, [&] {
      forEach(isInitialUnknown, [&](Reference i) { xml_.element("Unknown", {{"index", std::to_string(i + 1)}}); });
    });
  }

  void writeStructure3() {
    forEach([](const Variable& variable) { return variable.causality == Causality::output; },
            [&](Reference i) {
              xml_.element("Output", {{"valueReference", std::to_string(i)}, {"dependencies", ""}});
            });
    forEach(isInitialUnknown, [&](Reference i) {
      xml_.element("InitialUnknown", {{"valueReference", std::to_string(i)}});
    });
  }

  void forEach(const std::function<bool(const Variable&)>& chosen, const std::function<void(Reference)>& visit) const {
    for (Reference i = 0; i < table_.variables().size(); ++i) {
      if (chosen(table_.variables()[i])) {
        visit(i);
      }
    }
  }

  const ComponentData& data_;
  VariableTable table_;
  Version version_;
  std::string tool_;
  Writer xml_;
};

}  // namespace

std::string modelDescription(const ComponentData& data, Version version, const std::string& tool) {
  return Description(data, version, tool).text();
}

}  // namespace rubber_suspension::fmi
