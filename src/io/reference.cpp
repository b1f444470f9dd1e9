// Reference page of the component file, generated from the tables with which component files are checked.
#include "io/reference.h"

#include <fmt/format.h>

#include "log/text.h"
#include "rubber_suspension/element/catalogue.h"
#include "rubber_suspension/estimation/specification.h"
#include "rubber_suspension/io/rig_tolerances.h"

namespace rubber_suspension::io {
namespace {

std::vector<std::string> asCode(std::vector<std::string> names) {
  for (std::string& name : names) {
    name = "`" + name + "`";
  }
  return names;
}

// Escapes pipes, which would end the cell of a table, and asterisks, which would set text in italics.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    result += c == '|' || c == '*' ? std::string("\\") + c : std::string(1, c);
  }
  return result;
}

std::string sentence(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') {
    text[0] = static_cast<char>(text[0] - 'a' + 'A');
  }
  return text.empty() || text.back() == '.' ? text : text + ".";
}

void addGroups(std::vector<std::string>& needs, const std::string& count,
               const std::vector<std::vector<std::string>>& groups) {
  for (const auto& group : groups) {
    needs.push_back(fmt::format("{} of {}", count, log::join(asCode(group))));
  }
}

std::string modelRow(estimation::Model model) {
  const estimation::ModelInfo& info = estimation::modelInfo(model);
  std::vector<std::string> needs = asCode(info.required);
  addGroups(needs, "one", info.one_of);
  addGroups(needs, "two", info.two_of);
  return fmt::format("| `{}` | {} | {} | {} |\n", estimation::toString(model), escaped(sentence(info.documentation)),
                     log::join(needs), log::join(asCode(info.optional)));
}

std::string parameterTable(const std::vector<element::ParameterInfo>& parameters) {
  std::string text = "| key | unit | role | accepted | default | meaning |\n|---|---|---|---|---|---|\n";
  for (const element::ParameterInfo& parameter : parameters) {
    const std::string unit = parameter.unit == "1" ? "-" : parameter.unit;
    text += fmt::format(
        "| `{}` | {} | {} | {}{} | {} | {} |\n", parameter.name, unit, element::toString(parameter.role),
        parameter.is_list ? "list, each " : "", element::describe(parameter.range),
        parameter.default_value ? fmt::format("{:g}", *parameter.default_value) : "", escaped(parameter.documentation));
  }
  return text;
}

std::string elementSection(const element::ElementType& type) {
  return fmt::format("\n### {}\n\n{}\n\n{}", type.name, escaped(sentence(type.documentation)),
                     parameterTable(type.parameters));
}

std::string toleranceTable() {
  std::string text = "| key | unit | % of | default | meaning |\n|---|---|---|---|---|\n";
  const RigTolerances defaults;
  for (const RigToleranceInfo& row : rigToleranceTable()) {
    text += fmt::format("| `{}` | {} | {} | {:g} % | {} |\n", row.name, row.unit == "1" ? "-" : row.unit, row.share_of,
                        (defaults.*row.member).value * 100.0, row.documentation);
  }
  return text;
}

std::string temperatureSection() {
  return "\n## Keys of `temperature`\n\n"
         "For example `{shift: wlf, c1: 6.13, c2: 146.8 K, reference: 20 degC, vertical: proportional}`. The "
         "temperature comes\n"
         "from the column `temperature_degC` of a log or from the node's topic; without a temperature the component "
         "stays at\n"
         "its `reference`.\n\n"
         "| key | meaning |\n|---|---|\n"
         "| `shift` | `wlf` or `arrhenius`: the law, with the keys of `wlf_shift` or `arrhenius_shift` below |\n"
         "| `reference` | temperature to which all other values of the component refer; a number is in degC, text may "
         "be in K |\n"
         "| `c2` | a temperature difference: in K, never in degC |\n"
         "| `activation_energy` | here greater than 0, for example `50 kJ/mol` |\n"
         "| `vertical` | `proportional` (b_T = T/T_0), `none` (default), or a coefficient in 1/K |\n";
}

std::string describedKeys() {
  return "\nEvery model accepts `nominal_amplitude`; `nominal_displacement` and `nominal_force` need the key "
         "`describes` or a\n"
         "`static_curve` in the specification. Keys other than numbers:\n\n"
         "| key | meaning |\n|---|---|\n"
         "| `describes` | `component`: the specification describes the whole component, with static curve and added "
         "elements; `base`: it describes the model without them (the default, with a note if the component has any) |\n"
         "| `tolerance` | uncertainty of the numbers, as the standard deviation of their logarithms: a share such as "
         "`5 %`, `guess` (a power of ten), or a map of such values by key; default: 10 %. A diagnosis and the bench "
         "check use it |\n"
         "| `static_curve` | `{displacement: [...], force: [...], monotone: false}` in place of `static_stiffness` |\n"
         "| `scale_with` | `static_curve` (default): Maxwell elements and dashpots of the model scale with the slope "
         "of the curve; `none`: they do not. In entries of `add` the key applies to Maxwell elements, dashpots and "
         "sliders |\n"
         "| `points` | list of `{frequency, amplitude, stiffness, loss_angle, weight}` in place of the model's "
         "numbers, which are fitted to these points |\n"
         "| `preloads` | list of maps of the keys above, each with a `nominal_displacement` or `nominal_force` on the "
         "curve |\n";
}

}  // namespace

std::string parameterReference() {
  std::string text =
      "# Reference of the component file\n\n"
      "Written by the command `reference` from the tables that check a file; `config/example.yaml` shows it in use.\n"
      "Numbers are SI, in the units below; text carries its own unit, as `\"3 kN/mm\"`, `\"5.7 deg\"` or `\"5 %\"`.\n\n"
      "A component has a `model` and a `specification` (for the model `elements`, a list `elements` instead). It may "
      "have\n"
      "effects on top in a list `add`, the tolerances of the rig that measures it in a map `rig`, and its dependence\n"
      "on temperature in a map `temperature`. The key `valid_displacement` (`12 mm`, or `[-12 mm, 8 mm]`) is the range "
      "of\n"
      "displacements in which the component is valid; the default is the range of its spring tables. Beyond this range "
      "the\n"
      "node still publishes the force, counts the samples and warns; `replay` warns once. `excluded_effects: "
      "[backlash,\n"
      "free_play]` lists [effects](effects.md) that the design rules out: a diagnosis does not name them. "
      "`holds_fluid: true`\n"
      "means that the component contains a fluid. Without this key a diagnosis reports `fluid_inertia` with two\n"
      "interpretations: a fluid track, or a mass on a spring such as the fixture.\n\n"
      "## Models\n\n"
      "| model | elements | needs in `specification` | may have |\n|---|---|---|---|\n";
  for (int i = static_cast<int>(estimation::Model::kelvin_voigt); i <= static_cast<int>(estimation::Model::elements);
       ++i) {
    text += modelRow(static_cast<estimation::Model>(i));
  }
  text +=
      "\n## Roles\n\n"
      "The tables below give each key a role, which determines how `estimate --from-log` and `diagnose` use it.\n\n"
      "| role | meaning | moved by a fit |\n|---|---|---|\n"
      "| scale | the force is linear in the value while the other values are constant | yes |\n"
      "| shape | the value acts on the force in any other way | yes |\n"
      "| choice | a count, a switch, a dead band, the span or the points over which a law is realised | no |\n"
      "| reference | the point to which another value refers; any other point would do as well | no |\n\n"
      "A fit keeps lists, and values at an end of their accepted range (such as a coefficient of 0).\n";
  text += "\n## Keys of `specification`\n\n" + parameterTable(estimation::specificationParameters()) + describedKeys();
  text +=
      "\n## Keys of `rig`, and of the option `--rig KEY=VALUE` of a diagnosis\n\n"
      "Standard deviations of the errors that a rig causes in a log, independent in each log; 0: the rig does not have "
      "this error.\n\n" +
      toleranceTable();
  text += temperatureSection();
  text +=
      "\n## Elements, for `elements` and `add`\n\n"
      "A key without default is required. An element may have `of_rig: true`: it belongs to the rig that measured the "
      "component.\n"
      "Commands, node, exports and campaigns include it; `--without-rig` (`~without_rig`, `without_rig: true`,\n"
      "`Component.without_rig()`) omits it. `time_delay`, `sensor_gain`, `force_offset` and `force_drift` always "
      "belong to the\n"
      "rig. Stiffness and loss angle of the whole component are those without the rig.\n\n"
      "Entries of `elements` may have a `tolerance`; a `tolerance` of the component itself applies to all other "
      "entries. It is\n"
      "the uncertainty of the values, as a share or `guess`; default: 30 %.\n";
  for (const element::ElementType& type : element::elementTypes()) {
    text += elementSection(type);
  }
  return text;
}

}  // namespace rubber_suspension::io
