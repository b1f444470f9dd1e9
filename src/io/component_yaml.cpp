// Writer of component files.
#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "io/component_words.h"
#include "io/rotational_unit.h"
#include "log/text.h"
#include "rubber_suspension/io/component_file.h"

namespace rubber_suspension::io {
namespace {

// Returns the shortest text that is read as the same number.
std::string number(double value) { return fmt::format("{}", value); }

std::string listYaml(const std::vector<double>& values) {
  std::vector<std::string> numbers(values.size());
  std::transform(values.begin(), values.end(), numbers.begin(), number);
  return fmt::format("[{}]", log::join(numbers));
}

std::string styled(const YamlStyle& style, const std::string& place, double value) {
  return style.number ? style.number(place, value) : number(value);
}

std::string shareYaml(double tolerance) {
  return tolerance == estimation::SheetTolerance::kGuess ? kGuess : number(tolerance);
}

std::string entryYaml(const std::string& place, const element::ElementDescription& entry, const YamlStyle& style,
                      const std::optional<double>& tolerance) {
  std::string text = fmt::format("{{type: {}", entry.type);
  std::string notes;
  for (const auto& [name, values] : entry.values) {
    std::vector<std::string> numbers;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::string number_place = numberPlace(place, name, values.size() > 1 ? static_cast<int>(i) : -1);
      numbers.push_back(styled(style, number_place, values[i]));
      const std::string note = style.note ? style.note(number_place) : "";
      notes += note.empty() ? "" : fmt::format("      # {}: {}\n", number_place.substr(place.size() + 1), note);
    }
    text += fmt::format(", {}: {}", name, values.size() == 1 ? numbers[0] : fmt::format("[{}]", log::join(numbers)));
  }
  text += tolerance ? ", tolerance: " + shareYaml(*tolerance) : "";
  return fmt::format("{}      - {}{}}}\n", notes, text, element::isOfRig(entry) ? ", of_rig: true" : "");
}

std::string entriesYaml(const std::string& key, const std::vector<element::ElementDescription>& entries,
                        const YamlStyle& style, const estimation::SheetTolerance& tolerance = {}) {
  std::string text = entries.empty() ? "" : fmt::format("    {}:\n", key);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const auto own = tolerance.by_key.find(fmt::format("{}[{}]", entries[i].type, i));
    text += entryYaml(fmt::format("{}[{}]", key, i), entries[i], style,
                      own == tolerance.by_key.end() ? std::nullopt : std::optional(own->second));
  }
  return text;
}

std::string temperatureYaml(const element::ElementDescription& description) {
  const auto& laws = shiftLaws();
  const auto law =
      std::find_if(laws.begin(), laws.end(), [&](const ShiftLaw& known) { return known.type == description.type; });
  std::string text = fmt::format("    temperature: {{shift: {}", law->name);
  for (const auto& [name, values] : description.values) {
    text += fmt::format(", {}: {}", name, number(values.at(0)));
  }
  return text + "}\n";
}

std::string rigYaml(const RigTolerances& tolerances) {
  std::string text = "    rig:\n";
  for (const RigToleranceInfo& row : rigToleranceTable()) {
    text += fmt::format("      {}: {}\n", row.name, toString(row, tolerances.*row.member));
  }
  return text;
}

std::string curveYaml(const estimation::StaticCurve& curve, bool turns) {
  return fmt::format(
      "      static_curve:\n        displacement: {}  # [{}]\n        force: {}  # [{}]\n{}      scale_with: {}\n",
      listYaml(curve.displacement), turns ? "rad" : "m", listYaml(curve.force), turns ? "N m" : "N",
      curve.monotone ? "        monotone: true\n" : "", curve.scales ? "static_curve" : "none");
}

std::string toleranceYaml(const estimation::SheetTolerance& tolerance) {
  std::vector<std::string> by_key;
  for (const auto& [key, value] : tolerance.by_key) {
    by_key.push_back(fmt::format("{}: {}", key, shareYaml(value)));
  }
  return fmt::format("      tolerance: {}\n",
                     tolerance.of_all ? shareYaml(*tolerance.of_all) : fmt::format("{{{}}}", log::join(by_key)));
}

// Returns YAML of a specification. If `added` is true, there are added elements, so the text must state that it
// describes the component without them. `turns` is true for a rotation.
std::string specificationYaml(const estimation::Specification& specification, bool added, bool turns,
                              const YamlStyle& style) {
  std::string text = "    specification:\n";
  if (added || specification.describes() != estimation::Describes::unsaid) {
    text += "      describes: base\n";
  }
  text += specification.tolerance().given() ? toleranceYaml(specification.tolerance()) : "";
  text += specification.curve() == nullptr ? "" : curveYaml(*specification.curve(), turns);
  for (const estimation::Specification::Values& block : specification.preloads()) {
    text += &block == &specification.preloads().front() ? "      preloads:\n" : "";
    std::vector<std::string> numbers;
    for (const auto& [key, value] : block) {
      numbers.push_back(fmt::format("{}: {}", key, number(value)));
    }
    text += fmt::format("        - {{{}}}\n", log::join(numbers));
  }
  for (const element::ParameterInfo& parameter : estimation::specificationParameters()) {
    if (specification.has(parameter.name)) {
      const std::string place = "specification." + parameter.name;
      const std::string value = styled(style, place, specification.at(parameter.name));
      const std::string note = style.note ? style.note(place) : "";
      const bool says_unit = parameter.unit == "1" || value.find(' ') != std::string::npos;
      text += fmt::format("      {}: {}", parameter.name, value);
      text += says_unit && note.empty()
                  ? "\n"
                  : fmt::format(
                        "  #{}{}{}\n",
                        says_unit ? "" : fmt::format(" [{}]", turns ? rotationalUnit(parameter.unit) : parameter.unit),
                        note.empty() ? "" : " ", note);
    }
  }
  return text;
}

// Returns YAML of a component of one direction without its name. `turns` is true for a rotation.
std::string oneDirectionYaml(const ComponentDescription& component, bool turns, const YamlStyle& style) {
  std::string text = fmt::format("    model: {}\n", estimation::toString(component.model()));
  text += component.tolerance.of_all ? fmt::format("    tolerance: {}\n", shareYaml(*component.tolerance.of_all)) : "";
  text += component.model() == estimation::Model::elements
              ? entriesYaml("elements", component.elements(), style, component.tolerance)
              : specificationYaml(component.specification(), !component.add.empty(), turns, style);
  text += entriesYaml("add", component.add, style);
  text += component.temperature ? temperatureYaml(*component.temperature) : "";
  text += component.rig ? rigYaml(*component.rig) : "";
  if (const auto& valid = component.valid_displacement) {
    text += fmt::format("    valid_displacement: [{}, {}]  # [{}]\n", valid->lower, valid->upper, turns ? "rad" : "m");
  }
  if (!component.excluded_effects.empty()) {
    text += fmt::format("    excluded_effects: [{}]\n", fmt::join(component.excluded_effects, ", "));
  }
  text += component.holds_fluid ? "    holds_fluid: true\n" : "";
  return text;
}

std::string indented(const std::string& text) {
  std::istringstream lines(text);
  std::string result;
  for (std::string line; std::getline(lines, line);) {
    result += "    " + line + "\n";
  }
  return result;
}

std::string preloadYaml(const component::Preload& preload, component::Direction direction) {
  const bool turns = component::isRotation(direction);
  return number(preload.value) + (preload.is_force ? (turns ? " N m" : " N") : (turns ? " rad" : " m"));
}

std::string tableYaml(const component::PreloadTable& table) {
  std::vector<std::string> loads;
  for (const component::Preload& preload : table.preload) {
    loads.push_back(preloadYaml(preload, table.by));
  }
  return fmt::format("      - {{direction: {}, by: {}, preload: [{}], factor: {}}}\n", toString(table.direction),
                     toString(table.by), log::join(loads), listYaml(table.factor));
}

// Returns a style for one direction, which prefixes places with the name of the direction.
YamlStyle styleOf(component::Direction direction, const YamlStyle& style) {
  const std::string prefix = fmt::format("directions.{}.", toString(direction));
  YamlStyle own;
  if (style.number) {
    own.number = [&style, prefix](const auto& place, double value) { return style.number(prefix + place, value); };
  }
  if (style.note) {
    own.note = [&style, prefix](const auto& place) { return style.note(prefix + place); };
  }
  return own;
}

std::string sixDirectionsYaml(const SixDirectionsDescription& six, const YamlStyle& style) {
  std::string text = "    directions:\n";
  std::vector<std::string> preloads;
  for (std::size_t i = 0; i < component::kDirections; ++i) {
    const auto direction = static_cast<component::Direction>(i);
    if (six.directions[i]) {
      text +=
          fmt::format("      {}:\n", toString(direction)) +
          indented(oneDirectionYaml(*six.directions[i], component::isRotation(direction), styleOf(direction, style)));
    }
    if (six.preload[i]) {
      preloads.push_back(fmt::format("{}: {}", toString(direction), preloadYaml(*six.preload[i], direction)));
    }
  }
  const component::SixDirectionsLaws& arrangement = six.arrangement;
  text += fmt::format("    coupling: {{translation: {}, rotation: {}, axis: {}}}\n",
                      kCouplings[static_cast<std::size_t>(arrangement.translation)],
                      kCouplings[static_cast<std::size_t>(arrangement.rotation)], kAxes[arrangement.axis]);
  text += fmt::format("    rotation: {}\n    valid_rotation: {}  # [rad]\n",
                      kMeasures[static_cast<std::size_t>(arrangement.measure)], arrangement.valid_rotation);
  text += "    frame:\n";
  for (const auto& [body, frame] : {std::pair("a", &six.frame_on_a), std::pair("b", &six.frame_on_b)}) {
    text += fmt::format("      {}: {{position: {}, rotation: {}}}\n", body,
                        listYaml({frame->begin(), frame->begin() + 3}), listYaml({frame->begin() + 3, frame->end()}));
  }
  text += preloads.empty() ? "" : fmt::format("    preload: {{{}}}\n", log::join(preloads));
  text += six.tables.empty() ? "" : "    stiffness_by_preload:\n";
  for (const component::PreloadTable& table : six.tables) {
    text += tableYaml(table);
  }
  return text;
}

}  // namespace

std::string numberPlace(const std::string& entry, const std::string& key, int index) {
  return fmt::format("{}.{}{}", entry, key, index < 0 ? "" : fmt::format("[{}]", index));
}

std::string toYaml(const std::vector<ComponentDescription>& components, const YamlStyle& style) {
  std::string text = style.head + "components:\n";
  for (const ComponentDescription& component : components) {
    if (!isBaseName(component.name)) {
      throw ComponentFileError(
          fmt::format("{} is not a name of a component; accepted: a letter, then letters, digits and underscores, at "
                      "most {} characters",
                      log::quoted(component.name), kMaximumNameLength));
    }
    text += fmt::format("  {}:\n", component.name) +
            (component.six ? sixDirectionsYaml(*component.six, style) : oneDirectionYaml(component, false, style));
  }
  return text;
}

}  // namespace rubber_suspension::io
