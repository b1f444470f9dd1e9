// Computes other models and changed inputs of a component.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "command/estimate.h"
#include "command/sweep_values.h"
#include "element/each.h"
#include "element/refuse.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::command {
namespace {

using estimation::Model;
using estimation::Specification;

struct WantedModel {
  Model model;
  std::string label;
  std::optional<double> maxwell_elements;
};

WantedModel wantedModel(const std::string& text) {
  constexpr int kNumbered = 6;  // the models M1 to M6
  for (int i = 0; i < static_cast<int>(Model::elements); ++i) {
    const auto model = static_cast<Model>(i);
    const std::string number = i < kNumbered ? fmt::format("M{}", i + 1) : "";
    if (text == estimation::toString(model) || text == number) {
      return {model, (number.empty() ? "" : number + " ") + estimation::toString(model), std::nullopt};
    }
  }
  const bool digits = !text.empty() && text.size() <= 2 && text.find_first_not_of("0123456789") == std::string::npos;
  if (digits && text == "1") {
    return {Model::maxwell, "1 Maxwell element", std::nullopt};
  }
  if (digits) {
    return {Model::multi_maxwell, text + " Maxwell elements", std::stod(text)};
  }
  throw std::invalid_argument(
      fmt::format("'{}' is not a model; accepted: M1 to M6, their names, or a number of Maxwell elements", text));
}

void copyFirst(const Specification& from, const std::vector<std::string>& group, std::size_t count, Specification& to) {
  for (const std::string& key : group) {
    if (count > 0 && from.has(key)) {
      to.set(key, from.at(key));
      --count;
    }
  }
}

Specification numbersFor(const Specification& from, const WantedModel& wanted) {
  const estimation::ModelInfo& info = estimation::modelInfo(wanted.model);
  Specification to = from;
  for (const auto& [key, value] : from.values()) {
    to.erase(key);
  }
  if (from.describes() == estimation::Describes::unsaid) {
    to.describe(estimation::Describes::base);  // gives every model the same working point
  }
  copyFirst(from, info.required, info.required.size(), to);
  for (const auto& group : info.one_of) {
    copyFirst(from, group, 1, to);
  }
  for (const auto& group : info.two_of) {
    copyFirst(from, group, from.has("high_frequency_stiffness") ? 0 : 2, to);
  }
  std::vector<std::string> others = {"nominal_amplitude", "nominal_displacement", "nominal_force"};
  for (const std::string& key : info.optional) {
    const bool of_maxwell = wanted.model == Model::maxwell && !to.has("high_frequency_stiffness");
    if (!of_maxwell || key != "high_frequency") {
      others.push_back(key);
    }
  }
  if (from.has("high_frequency_stiffness") && wanted.model == Model::multi_maxwell) {
    others.emplace_back("high_frequency");
  }
  copyFirst(from, others, others.size(), to);
  if (wanted.maxwell_elements) {
    to.set("maxwell_elements", *wanted.maxwell_elements);
  }
  return to;
}

bool isRequired(const std::string& key, Model model) {
  const std::vector<std::string>& required = estimation::modelInfo(model).required;
  return std::find(required.begin(), required.end(), key) != required.end();
}

// Returns the break frequency for which model M2 has the specified dynamic stiffness and loss angle at the nominal
// frequency. Throws std::invalid_argument if there is none.
double breakFrequencyByLoss(Specification from) {
  for (const char* other : {"break_frequency", "maximum_stiffness", "high_frequency_stiffness", "high_frequency"}) {
    from.erase(other);
  }
  const WantedModel one = wantedModel("M2");
  const io::ComponentDescription maxwell(one.label, one.model, numbersFor(from, one));
  for (const element::ElementDescription& element : maxwell.elements()) {
    if (element.type == "maxwell") {
      return element.value("break_frequency");
    }
  }
  throw std::invalid_argument(
      "break_frequency is missing and cannot be taken from model M2; accepted: break_frequency in the specification");
}

// Splits entries such as "M1,M2" at the commas.
std::vector<std::string> eachOf(const std::vector<std::string>& models) {
  std::vector<std::string> result;
  for (const std::string& text : models) {
    std::istringstream stream(text.empty() ? "," : text);
    for (std::string one; std::getline(stream, one, ',');) {
      result.push_back(one);
    }
  }
  return result;
}

// Returns the specification with the inputs that another model needs and that are missing: the loss angle of the
// component, the break frequency of model M2 (nearly that of M6 in the paper), and the highest frequency that is drawn.
Specification completed(const io::ComponentDescription& description, const WantedModel& wanted,
                        std::vector<std::string>& added) {
  Specification from = description.written();
  const double frequency = from.valueOr("nominal_frequency", 0.0);
  if (frequency == 0.0 || !from.points().empty() || !from.preloads().empty()) {
    return from;
  }
  const auto add = [&](const std::string& key, double value, const std::string& text) {
    from.set(key, value);
    added.push_back(key + " " + text);
  };
  if (!from.has("loss_angle") && !from.has("relative_damping")) {
    const response::SweepPoint point =
        response::characteristicsAt(description.makeComponent(), frequency, from.valueOr("nominal_amplitude", 1e-3),
                                    loopsAbout(estimation::nominalDisplacement(description.specification())));
    const double angle = point.characteristics.loss_angle;
    add("loss_angle", angle, fmt::format("{:.4g} deg (from the component)", angle * kDegrees));
  }
  if (wanted.model == Model::multi_maxwell) {
    if (!from.has("loss_angle")) {
      from.set("loss_angle", std::atan(2.0 * from.at("relative_damping")));
    }
    if (!from.has("maximum_stiffness") && !from.has("high_frequency")) {
      constexpr double kRange = 10.0;  // end of the sweep over frequency in units of the nominal frequency
      add("high_frequency", kRange * frequency, fmt::format("{:g} Hz (end of the range)", kRange * frequency));
    }
  } else if (isRequired("break_frequency", wanted.model) && !from.has("break_frequency")) {
    const bool with_dashpot = wanted.model == Model::maxwell_dashpot;
    const double share = with_dashpot ? 1.0 / 3.0 : 1.0;  // M2's own value would leave no loss for the dashpot
    const double found = share * breakFrequencyByLoss(from);
    add("break_frequency", found,
        fmt::format("{:.4g} Hz ({}the value of M2)", found, with_dashpot ? "a third of " : ""));
  }
  return from;
}

// Returns the component in another model. Adds the inputs that had to be derived to `notes`.
io::ComponentDescription inModel(const io::ComponentDescription& description, const WantedModel& wanted,
                                 std::vector<std::string>& notes) {
  try {
    return {wanted.label, wanted.model, numbersFor(description.written(), wanted), description.add};
  } catch (const std::invalid_argument&) {
    std::vector<std::string> added;
    const Specification more = completed(description, wanted, added);
    if (added.empty()) {
      throw;
    }
    io::ComponentDescription result(wanted.label, wanted.model, numbersFor(more, wanted), description.add);
    notes.push_back(fmt::format("{}: added to the specification: {}", wanted.label, fmt::join(added, "; ")));
    return result;
  }
}

// Computes the points of a sweep again for another component.
std::vector<response::SweepPoint> sweptAgain(const io::ComponentDescription& description,
                                             const std::vector<response::SweepPoint>& points) {
  const component::Component component = description.makeComponent();
  const response::LoopOptions options = loopsAbout(estimation::nominalDisplacement(description.specification()));
  return element::each(points, [&](const response::SweepPoint& point) {
    return response::characteristicsAt(component, point.frequency, point.amplitude, options);
  });
}

std::optional<std::vector<response::SweepPoint>> changed(const EstimateReport& report, const std::string& input,
                                                         double factor) {
  const io::ComponentDescription& given = report.description;
  Specification specification = given.written();
  specification.set(input, specification.at(input) * factor);
  try {
    return sweptAgain({given.name, given.model(), specification, given.add}, report.over_frequency);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

void widen(std::vector<response::SweepPoint>& low, std::vector<response::SweepPoint>& high,
           const std::vector<response::SweepPoint>& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const response::Characteristics& here = points[i].characteristics;
    response::Characteristics& least = low[i].characteristics;
    response::Characteristics& most = high[i].characteristics;
    least.stiffness = std::min(least.stiffness, here.stiffness);
    least.loss_angle = std::min(least.loss_angle, here.loss_angle);
    most.stiffness = std::max(most.stiffness, here.stiffness);
    most.loss_angle = std::max(most.loss_angle, here.loss_angle);
  }
}

std::string csvRow(const std::string& component, const std::string& sweep, const response::SweepPoint& point) {
  const response::Characteristics& found = point.characteristics;
  const double storage = found.stiffness * std::cos(found.loss_angle);
  const double loss = found.stiffness * std::sin(found.loss_angle);
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", point.frequency, point.amplitude, found.stiffness,
                     found.loss_angle, storage, loss, storage, loss / (2.0 * element::kPi * point.frequency),
                     point.settled ? 1 : 0, sweep, component);
}

}  // namespace

std::vector<io::ComponentDescription> inModels(const io::ComponentDescription& description,
                                               const std::vector<std::string>& models,
                                               std::vector<std::string>& notes) {
  element::refuseIf(
      description.model() == Model::elements,
      "{}: a list of elements cannot be estimated as another model; accepted: a component with a specification",
      description.name);
  std::vector<io::ComponentDescription> result;
  for (const std::string& text : eachOf(models)) {
    const WantedModel wanted = wantedModel(text);
    try {
      result.push_back(inModel(description, wanted, notes));
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(fmt::format("{}: model {}: {}", description.name, text, error.what()));
    }
    result.back().temperature = description.temperature;
  }
  return result;
}

void addSensitivity(EstimateReport& report, double share) {
  Sensitivity sensitivity{share, {}, report.over_frequency, report.over_frequency};
  for (const element::ParameterInfo& input : estimation::specificationParameters()) {
    const bool number = input.range.lower >= 0.0 && input.name != "maxwell_elements";
    if (!number || !report.description.written().has(input.name)) {
      continue;
    }
    const auto less = changed(report, input.name, 1.0 - share);
    const auto more = changed(report, input.name, 1.0 + share);
    SensitivityRow row{input.name, {}, {}, {}};
    for (const std::size_t i : {std::size_t{0}, report.over_frequency.size() / 2, report.over_frequency.size() - 1}) {
      row.frequencies.push_back(report.over_frequency[i].frequency);
      if (less && more) {
        const response::Characteristics& below = (*less)[i].characteristics;
        const response::Characteristics& above = (*more)[i].characteristics;
        row.stiffness.push_back(std::log(above.stiffness / below.stiffness) / std::log((1.0 + share) / (1.0 - share)));
        row.loss_angle.push_back((above.loss_angle - below.loss_angle) / (2.0 * share));
      }
    }
    for (const auto& variant : {less, more}) {
      if (variant) {
        widen(sensitivity.low, sensitivity.high, *variant);
      }
    }
    sensitivity.rows.push_back(row);
  }
  report.sensitivity = sensitivity;
}

std::string toCsv(const std::vector<EstimateReport>& reports) {
  std::string text =
      "frequency_Hz,amplitude_m,stiffness_N_per_m,loss_angle_rad,storage_stiffness_N_per_m,loss_stiffness_N_per_m,"
      "equivalent_stiffness_N_per_m,equivalent_damping_Ns_per_m,settled,sweep,component\n";
  for (const EstimateReport& report : reports) {
    for (const auto& [sweep, points] :
         {std::pair("frequency", &report.over_frequency), std::pair("amplitude", &report.over_amplitude),
          std::pair("product", &report.over_product)}) {
      for (const response::SweepPoint& point : *points) {
        text += csvRow(report.description.name, sweep, point);
      }
    }
  }
  return text;
}

}  // namespace rubber_suspension::command
