// Rules for modelDescription.xml in FMI 2.0.4 (2.2 and 4.3) and FMI 3.0 (2.4 and 4.3), as far as they concern a
// co-simulation FMU with real variables.
#include "fmi/description_check.h"

#include <tinyxml2.h>

#include <cctype>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <sstream>

namespace rubber_suspension::fmi::test {
namespace {

using tinyxml2::XMLElement;

std::string attribute(const XMLElement& element, const char* name) {
  const char* value = element.Attribute(name);
  return value == nullptr ? "" : value;
}

bool has(const XMLElement& element, const char* name) { return element.Attribute(name) != nullptr; }

std::vector<const XMLElement*> childrenOf(const XMLElement* element) {
  std::vector<const XMLElement*> children;
  for (const auto* child = element == nullptr ? nullptr : element->FirstChildElement(); child != nullptr;
       child = child->NextSiblingElement()) {
    children.push_back(child);
  }
  return children;
}

std::optional<double> numberOf(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  return !text.empty() && *end == '\0' ? std::optional<double>(value) : std::nullopt;
}

// The table "initial" of the standard: the values that a causality and a variability permit.
const std::map<std::pair<std::string, std::string>, std::set<std::string>>& initialTable() {
  static const std::map<std::pair<std::string, std::string>, std::set<std::string>> table = {
      {{"parameter", "fixed"}, {"", "exact"}},
      {{"parameter", "tunable"}, {"", "exact"}},
      {{"calculatedParameter", "fixed"}, {"", "calculated", "approx"}},
      {{"calculatedParameter", "tunable"}, {"", "calculated", "approx"}},
      {{"input", "discrete"}, {""}},
      {{"input", "continuous"}, {""}},
      {{"output", "constant"}, {"", "exact"}},
      {{"output", "discrete"}, {"", "calculated", "exact", "approx"}},
      {{"output", "continuous"}, {"", "calculated", "exact", "approx"}},
      {{"local", "constant"}, {"", "exact"}},
      {{"local", "fixed"}, {"", "calculated", "approx"}},
      {{"local", "tunable"}, {"", "calculated", "approx"}},
      {{"local", "discrete"}, {"", "calculated", "exact", "approx"}},
      {{"local", "continuous"}, {"", "calculated", "exact", "approx"}},
      {{"independent", "continuous"}, {""}},
  };
  return table;
}

class Check {
 public:
  Check(const XMLElement& root, Version version) : root_(root), version_(version) {}

  std::vector<std::string> run() {
    checkRoot();
    checkOrder();
    checkInterface();
    checkUnits();
    checkCategories();
    checkVariables();
    checkStructure();
    return broken_;
  }

 private:
  struct Variable {
    std::string name;
    std::string causality;
    std::string initial;
    std::string reference;
  };

  bool isSecond() const { return version_ == Version::fmi2; }
  void require(bool holds, const std::string& rule) {
    if (!holds) {
      broken_.push_back(rule);
    }
  }

  void requireAttributes(const XMLElement& element, const std::set<std::string>& allowed,
                         const std::set<std::string>& needed) {
    const std::string name = element.Name();
    for (const auto* a = element.FirstAttribute(); a != nullptr; a = a->Next()) {
      require(allowed.count(a->Name()) + needed.count(a->Name()) == 1, name + ": attribute " + a->Name());
    }
    for (const std::string& key : needed) {
      require(has(element, key.c_str()), name + ": lacks " + key);
    }
  }

  void requireFlag(const XMLElement& element, const char* name) {
    const std::string value = attribute(element, name);
    require(value.empty() || value == "true" || value == "false", std::string(name) + ": no boolean");
  }

  void checkRoot() {
    require(std::string(root_.Name()) == "fmiModelDescription", "the root is fmiModelDescription");
    const std::string token = isSecond() ? "guid" : "instantiationToken";
    std::set<std::string> allowed = {"description",
                                     "author",
                                     "version",
                                     "copyright",
                                     "license",
                                     "generationTool",
                                     "generationDateAndTime",
                                     "variableNamingConvention"};
    if (isSecond()) {
      allowed.insert("numberOfEventIndicators");
    }
    requireAttributes(root_, allowed, {"fmiVersion", "modelName", token});
    require(attribute(root_, "fmiVersion") == (isSecond() ? "2.0" : "3.0"), "fmiVersion is that of the standard");
    require(!attribute(root_, token.c_str()).empty(), token + " is not empty");
    const std::string convention = attribute(root_, "variableNamingConvention");
    require(convention.empty() || convention == "flat" || convention == "structured", "naming convention");
  }

  void checkOrder() {
    const std::vector<std::string> order = {"ModelExchange",     "CoSimulation",      "ScheduledExecution",
                                            "UnitDefinitions",   "TypeDefinitions",   "LogCategories",
                                            "DefaultExperiment", "VendorAnnotations", "ModelVariables",
                                            "ModelStructure",    "Annotations"};
    std::size_t place = 0;
    std::set<std::string> seen;
    for (const XMLElement* child : childrenOf(&root_)) {
      const auto found = std::find(order.begin() + static_cast<std::ptrdiff_t>(place), order.end(), child->Name());
      require(found != order.end(), std::string(child->Name()) + " stands where the standard has it");
      place = found == order.end() ? place : static_cast<std::size_t>(found - order.begin());
      require(seen.insert(child->Name()).second, std::string(child->Name()) + " stands once");
    }
    for (const char* needed : {"CoSimulation", "ModelVariables", "ModelStructure"}) {
      require(seen.count(needed) == 1, std::string(needed) + " is there");
    }
  }

  void checkInterface() {
    const XMLElement* interface = root_.FirstChildElement("CoSimulation");
    if (interface == nullptr) {
      return;
    }
    std::set<std::string> flags = {"needsExecutionTool", "canBeInstantiatedOnlyOncePerProcess",
                                   "canHandleVariableCommunicationStepSize"};
    const std::set<std::string> second = {
        "canInterpolateInputs", "canRunAsynchronuously", "canNotUseMemoryManagementFunctions",
        "canGetAndSetFMUstate", "canSerializeFMUstate",  "providesDirectionalDerivative"};
    const std::set<std::string> third = {"canGetAndSetFMUState",
                                         "canSerializeFMUState",
                                         "providesDirectionalDerivatives",
                                         "providesAdjointDerivatives",
                                         "providesPerElementDependencies",
                                         "providesIntermediateUpdate",
                                         "mightReturnEarlyFromDoStep",
                                         "canReturnEarlyAfterIntermediateUpdate",
                                         "hasEventMode",
                                         "providesEvaluateDiscreteStates"};
    flags.insert(isSecond() ? second.begin() : third.begin(), isSecond() ? second.end() : third.end());
    for (const std::string& flag : flags) {
      requireFlag(*interface, flag.c_str());
    }
    flags.insert("maxOutputDerivativeOrder");
    requireAttributes(*interface, flags, {"modelIdentifier"});
    require(std::regex_match(attribute(*interface, "modelIdentifier"), std::regex("[A-Za-z_][A-Za-z0-9_]*")),
            "modelIdentifier is a name in C");
    const char* save = isSecond() ? "canGetAndSetFMUstate" : "canGetAndSetFMUState";
    const char* serialise = isSecond() ? "canSerializeFMUstate" : "canSerializeFMUState";
    require(attribute(*interface, serialise) != "true" || attribute(*interface, save) == "true",
            "what can be serialised can be saved");
  }

  void checkUnits() {
    for (const XMLElement* unit : childrenOf(root_.FirstChildElement("UnitDefinitions"))) {
      require(std::string(unit->Name()) == "Unit", "UnitDefinitions hold units");
      requireAttributes(*unit, {}, {"name"});
      require(units_.insert(attribute(*unit, "name")).second, "unit " + attribute(*unit, "name") + " stands once");
      for (const XMLElement* base : childrenOf(unit)) {
        require(std::string(base->Name()) == "BaseUnit", "a unit holds its base unit");
        requireAttributes(*base, {"kg", "m", "s", "A", "K", "mol", "cd", "rad", "factor", "offset"}, {});
      }
    }
  }

  void checkCategories() {
    std::set<std::string> names;
    for (const XMLElement* category : childrenOf(root_.FirstChildElement("LogCategories"))) {
      requireAttributes(*category, {"description"}, {"name"});
      require(names.insert(attribute(*category, "name")).second, "log category stands once");
    }
  }

  void checkVariables() {
    std::set<std::string> names;
    std::set<std::string> references;
    for (const XMLElement* element : childrenOf(root_.FirstChildElement("ModelVariables"))) {
      const Variable variable{attribute(*element, "name"), attribute(*element, "causality"),
                              attribute(*element, "initial"), attribute(*element, "valueReference")};
      require(names.insert(variable.name).second, variable.name + ": the name stands once");
      require(references.insert(variable.reference).second, variable.name + ": the value reference stands once");
      checkVariable(*element, variable);
      variables_.push_back(variable);
    }
    require(!variables_.empty(), "there are variables");
    const auto times = std::count_if(variables_.begin(), variables_.end(),
                                     [](const Variable& variable) { return variable.causality == "independent"; });
    require(isSecond() ? times <= 1 : times == 1, "one independent variable");
  }

  void checkVariable(const XMLElement& element, const Variable& variable) {
    const std::string& name = variable.name;
    // FMI 2.0, 2.2.9 defines a structured name as B-name [indices] {"." B-name [indices]}.
    static const std::regex structured(R"(([A-Za-z_]\w*(\[\d+(,\d+)*\])?)(\.[A-Za-z_]\w*(\[\d+(,\d+)*\])?)*)");
    require(attribute(root_, "variableNamingConvention") != "structured" || std::regex_match(name, structured),
            name + ": a structured name");
    require(std::regex_match(variable.reference, std::regex("[0-9]+")), name + ": the value reference is a number");
    const auto row = initialTable().find({variable.causality, attribute(element, "variability")});
    require(row != initialTable().end(), name + ": causality and variability go together");
    require(row == initialTable().end() || row->second.count(variable.initial) == 1, name + ": initial");
    const std::set<std::string> common = {"description", "causality", "variability", "initial"};
    const std::set<std::string> value = {"unit",         "min",     "max",    "start",       "quantity",
                                         "declaredType", "nominal", "reinit", "displayUnit", "relativeQuantity",
                                         "unbounded"};
    if (!isSecond()) {
      std::set<std::string> all = common;
      all.insert(value.begin(), value.end());
      require(std::string(element.Name()) == "Float64", name + ": a Float64");
      requireAttributes(element, all, {"name", "valueReference"});
      checkValue(element, variable);
      return;
    }
    require(std::string(element.Name()) == "ScalarVariable", name + ": a ScalarVariable");
    requireAttributes(element, common, {"name", "valueReference"});
    const std::vector<const XMLElement*> types = childrenOf(&element);
    require(types.size() == 1 && std::string(types[0]->Name()) == "Real", name + ": one type, Real");
    if (!types.empty()) {
      requireAttributes(*types[0], value, {});
      checkValue(*types[0], variable);
    }
  }

  void checkValue(const XMLElement& value, const Variable& variable) {
    const std::string unit = attribute(value, "unit");
    require(unit.empty() || units_.count(unit) == 1, variable.name + ": its unit is defined");
    for (const char* key : {"min", "max", "start"}) {
      require(!has(value, key) || numberOf(attribute(value, key)).has_value(), variable.name + ": " + key);
    }
    const bool starts = variable.causality == "input" || variable.causality == "parameter" ||
                        variable.initial == "exact" || variable.initial == "approx";
    require(starts == has(value, "start"), variable.name + ": start where there has to be one, and only there");
    const double least = numberOf(attribute(value, "min")).value_or(-HUGE_VAL);
    const double most = numberOf(attribute(value, "max")).value_or(HUGE_VAL);
    const double start = numberOf(attribute(value, "start")).value_or(std::max(least, -HUGE_VAL));
    require(least <= most && (!starts || (least <= start && start <= most)), variable.name + ": min <= start <= max");
  }

  void checkStructure() {
    const XMLElement* structure = root_.FirstChildElement("ModelStructure");
    std::vector<std::string> outputs;
    std::vector<std::string> unknowns;
    if (isSecond()) {
      outputs = unknownsOf(structure == nullptr ? nullptr : structure->FirstChildElement("Outputs"), "index");
      unknowns = unknownsOf(structure == nullptr ? nullptr : structure->FirstChildElement("InitialUnknowns"), "index");
    } else {
      for (const XMLElement* element : childrenOf(structure)) {
        std::vector<std::string>& list = std::string(element->Name()) == "Output" ? outputs : unknowns;
        requireAttributes(*element, {"dependencies", "dependenciesKind"}, {"valueReference"});
        list.push_back(attribute(*element, "valueReference"));
      }
    }
    require(outputs == chosen([](const Variable& variable) { return variable.causality == "output"; }),
            "ModelStructure lists exactly the outputs, in order");
    require(unknowns == chosen([](const Variable& variable) {
              return variable.causality == "calculatedParameter" ||
                     (variable.causality == "output" && variable.initial != "exact");
            }),
            "ModelStructure lists exactly the initial unknowns, in order");
  }

  std::vector<std::string> unknownsOf(const XMLElement* list, const char* key) {
    std::vector<std::string> result;
    for (const XMLElement* unknown : childrenOf(list)) {
      require(std::string(unknown->Name()) == "Unknown", "ModelStructure holds unknowns");
      requireAttributes(*unknown, {"dependencies", "dependenciesKind"}, {key});
      result.push_back(attribute(*unknown, key));
    }
    return result;
  }

  // FMI 2.0 refers to variables by their number, counted from 1. FMI 3.0 refers to them by their value references.
  template <class Choice>
  std::vector<std::string> chosen(Choice choice) const {
    std::vector<std::string> result;
    for (std::size_t i = 0; i < variables_.size(); ++i) {
      if (choice(variables_[i])) {
        result.push_back(isSecond() ? std::to_string(i + 1) : variables_[i].reference);
      }
    }
    return result;
  }

  const XMLElement& root_;
  Version version_;
  std::vector<std::string> broken_;
  std::set<std::string> units_;
  std::vector<Variable> variables_;
};

}  // namespace

std::vector<std::string> brokenRules(const std::string& xml, Version version) {
  tinyxml2::XMLDocument document;
  if (document.Parse(xml.c_str()) != tinyxml2::XML_SUCCESS || document.RootElement() == nullptr) {
    return {std::string("not XML: ") + document.ErrorStr()};
  }
  return Check(*document.RootElement(), version).run();
}

}  // namespace rubber_suspension::fmi::test
