// Computes and formats the report of `estimate`.
#include "command/estimate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>

#include "command/sweep_values.h"
#include "element/each.h"
#include "element/refuse.h"
#include "estimation/models.h"
#include "io/progress.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/estimation/notes.h"

namespace rubber_suspension::command {
namespace {

using element::each;

// SweepOptions with a value for each option.
struct Sweeps {
  std::vector<double> frequencies;
  std::vector<double> amplitudes;
  double frequency;
  double amplitude;
  double product;
};

std::vector<double> spaced(const std::string& what, double low, double high, int points) {
  element::refuseIf(!(low > 0.0) || !(high > low) || !std::isfinite(high),
                    "{} range: {:g} to {:g}; accepted: greater than 0, the second value greater than the first", what,
                    low, high);
  return response::logSpaced(low, high, points);
}

Sweeps complete(const SweepOptions& options, const estimation::Specification& specification) {
  element::refuseIf(options.points < 2 || options.points > 10000, "points: {}; accepted: 2 to 10000", options.points);
  const bool nominal = specification.has("nominal_frequency");
  const double f_n = specification.valueOr("nominal_frequency", 1.0);
  Sweeps sweeps;
  sweeps.frequency = options.frequency.value_or(f_n);
  sweeps.amplitude = options.amplitude.value_or(specification.valueOr("nominal_amplitude", 1e-3));
  sweeps.product = options.product.value_or(sweeps.frequency * sweeps.amplitude);
  const double low = options.lowest_frequency.value_or(nominal ? f_n / 10.0 : 0.1);
  const double high =
      options.highest_frequency.value_or(specification.valueOr("high_frequency", nominal ? 10.0 * f_n : 50.0));
  sweeps.frequencies = spaced("frequency", low, high, options.points);
  sweeps.amplitudes = spaced("amplitude", options.lowest_amplitude.value_or(sweeps.amplitude / 10.0),
                             options.highest_amplitude.value_or(sweeps.amplitude * 5.0), options.points);
  return sweeps;
}

// Warns that simulated friction would take sensor noise for reversals of the motion.
void addFrictionNote(EstimateReport& report) {
  if (std::any_of(report.elements.begin(), report.elements.end(), [](const element::ElementDescription& element) {
        return element.type == "friction" && element.value("dead_band") == 0.0;
      })) {
    report.notes.push_back(
        "friction has no dead band; for measured displacements, give friction as an element with a dead_band of about "
        "6 standard deviations of the sensor noise");
  }
}

// A specification without `describes` applies to the base, without the added elements and the static curve. Notes how
// far the whole component differs from the specification.
void addWholeNote(EstimateReport& report, const component::Component& component) {
  const io::ComponentDescription& description = report.description;
  const estimation::Specification& specification = description.written();
  const auto stiffness = specification.find("dynamic_stiffness");
  const auto frequency = specification.find("nominal_frequency");
  if (specification.describes() != estimation::Describes::unsaid || !stiffness || !frequency ||
      (description.add.empty() && specification.curve() == nullptr)) {
    return;
  }
  const double amplitude = specification.valueOr("nominal_amplitude", 1e-3);
  const response::Characteristics whole =
      response::characteristicsAt(component, *frequency, amplitude,
                                  loopsAbout(estimation::nominalDisplacement(description.specification())))
          .characteristics;
  constexpr double kSame = 1e-3;  // [-]; tolerance for a static curve that is almost straight within the loop
  if (description.add.empty() && std::abs(whole.stiffness / *stiffness - 1.0) < kSame) {
    return;
  }
  const auto angle = estimation::specifiedLossAngle(specification);
  report.notes.push_back(fmt::format(
      "the specification describes only the base (no static curve, no added elements): the whole component has K "
      "{:.6g} N/m ({:.6g} specified) and a loss angle of {:.4g} deg{} at {:g} Hz and {:g} mm; with `describes: "
      "component` the whole component meets the specification, and `describes: base` suppresses this note",
      whole.stiffness, *stiffness, whole.loss_angle * kDegrees,
      angle ? fmt::format(" ({:.4g} specified)", *angle * kDegrees) : "", *frequency, 1e3 * amplitude));
}

bool allSettled(const EstimateReport& report) {
  const auto sweeps = {&report.over_frequency, &report.over_amplitude, &report.over_product};
  return report.working_point.settled && std::all_of(sweeps.begin(), sweeps.end(), [](const auto* points) {
           return std::all_of(points->begin(), points->end(), [](const auto& point) { return point.settled; });
         });
}

// Returns the parameters as "name value unit, ...". For a Maxwell element, damping and relaxation time are appended.
std::string elementText(const element::ElementDescription& element) {
  const element::ElementType* type = element::findElementType(element.type);
  std::string text;
  for (const element::ParameterInfo& parameter : type->parameters) {
    const std::string values = fmt::format("{:.6g}", fmt::join(element.list(parameter.name), ", "));
    text += fmt::format("{}{} {}{}", text.empty() ? "" : ", ", parameter.name, values,
                        parameter.unit == "1" ? "" : " " + parameter.unit);
  }
  if (element.type == "maxwell") {
    const double damping = element.value("stiffness") / (2.0 * element::kPi * element.value("break_frequency"));
    text += fmt::format(" (damping {:.6g} N s/m, relaxation time {:.6g} s)", damping,
                        1.0 / (2.0 * element::kPi * element.value("break_frequency")));
  }
  return text;
}

std::string sweepText(const std::string& title, const std::vector<response::SweepPoint>& points) {
  std::string text = fmt::format("\n  {}\n  {:>12} {:>12} {:>14} {:>12} {:>12}\n", title, "f [Hz]", "A [mm]", "K [N/m]",
                                 "delta [deg]", "loss [J]");
  for (const response::SweepPoint& point : points) {
    text +=
        fmt::format("  {:>12.5g} {:>12.5g} {:>14.7g} {:>12.5g} {:>12.5g}{}\n", point.frequency, point.amplitude * 1e3,
                    point.characteristics.stiffness, point.characteristics.loss_angle * kDegrees,
                    point.characteristics.loss, point.settled ? "" : " *");
  }
  return text;
}

std::string specificationText(const estimation::Specification& specification) {
  std::string text;
  if (const estimation::StaticCurve* curve = specification.curve()) {
    text += fmt::format("    {:<20} {} points from {:.6g} to {:.6g} m{}\n", "static_curve", curve->displacement.size(),
                        curve->displacement.front(), curve->displacement.back(),
                        curve->scales ? "; the viscous elements scale with the slope of the curve" : "");
  }
  if (!specification.points().empty()) {
    text += fmt::format("    {:<20} {}\n", "points", specification.points().size());
  }
  for (const element::ParameterInfo& parameter : estimation::specificationParameters()) {
    if (specification.has(parameter.name)) {
      text += fmt::format("    {:<20} {:.6g}{}\n", parameter.name, specification.at(parameter.name),
                          parameter.unit == "1" ? "" : " " + parameter.unit);
    }
  }
  return text;
}

nlohmann::ordered_json pointJson(const response::SweepPoint& point) {
  return {{"frequency_hz", point.frequency},
          {"amplitude_m", point.amplitude},
          {"stiffness_n_per_m", point.characteristics.stiffness},
          {"loss_angle_rad", point.characteristics.loss_angle},
          {"loss_j", point.characteristics.loss},
          {"settled", point.settled}};
}

nlohmann::ordered_json misfitJson(const estimation::PointMisfit& misfit) {
  return {{"frequency_hz", misfit.point.frequency},
          {"amplitude_m", misfit.point.amplitude},
          {"stiffness_n_per_m", misfit.stiffness},
          {"stiffness_error", misfit.point.stiffness ? misfit.stiffness / *misfit.point.stiffness - 1.0 : 0.0},
          {"loss_angle_rad", misfit.loss_angle},
          {"loss_angle_error_rad", misfit.point.loss_angle ? misfit.loss_angle - *misfit.point.loss_angle : 0.0}};
}

std::string sensitivityText(const Sensitivity& sensitivity) {
  if (sensitivity.rows.empty()) {
    return "\n  no sensitivity: the component has no specification whose inputs could be changed\n";
  }
  std::string text = fmt::format("\n  sensitivity to each input, changed by {:g} % up and down\n  {:<26}",
                                 100.0 * sensitivity.share, "");
  for (const double frequency : sensitivity.rows.front().frequencies) {
    text += fmt::format(" {:>24}", fmt::format("at {:.4g} Hz", frequency));
  }
  text += "\n";
  for (const SensitivityRow& row : sensitivity.rows) {
    text += fmt::format("  {:<26}", row.input);
    for (std::size_t i = 0; i < row.stiffness.size(); ++i) {
      text += fmt::format(" {:>10.3f} %/% {:>6.3f} deg/%", row.stiffness[i], 0.01 * row.loss_angle[i] * kDegrees);
    }
    text += row.stiffness.empty() ? " no solution\n" : "\n";
  }
  return text;
}

nlohmann::ordered_json sensitivityJson(const SensitivityRow& row) {
  return {{"input", row.input},
          {"frequency_hz", row.frequencies},
          {"stiffness", row.stiffness},
          {"loss_angle_rad", row.loss_angle}};
}

nlohmann::ordered_json elementJson(const element::ElementDescription& element) {
  nlohmann::ordered_json json = {{"type", element.type}};
  for (const element::ParameterInfo& parameter : element::findElementType(element.type)->parameters) {
    const std::vector<double>& values = element.list(parameter.name);
    json[parameter.name] = parameter.is_list ? nlohmann::ordered_json(values) : nlohmann::ordered_json(values.at(0));
  }
  return json;
}

nlohmann::ordered_json reportJson(const EstimateReport& report) {
  nlohmann::ordered_json json = {{"component", report.description.name},
                                 {"model", estimation::toString(report.description.model())},
                                 {"describes", estimation::toString(report.description.written().describes())},
                                 {"specification", report.description.written().values()},
                                 {"base", report.description.specification().values()},
                                 {"points", each(report.description.resolved().points, misfitJson)},
                                 {"elements", each(report.elements, elementJson)},
                                 {"notes", report.notes},
                                 {"linear", report.linear},
                                 {"working_point", pointJson(report.working_point)},
                                 {"over_frequency", each(report.over_frequency, pointJson)},
                                 {"over_amplitude", each(report.over_amplitude, pointJson)},
                                 {"product_m_hz", report.product},
                                 {"at_constant_product", each(report.over_product, pointJson)}};
  if (report.sensitivity) {
    json["sensitivity"] = {{"share", report.sensitivity->share},
                           {"inputs", each(report.sensitivity->rows, sensitivityJson)}};
  }
  return json;
}

// A column of the figure. Its title states which quantity is constant.
struct FigureColumn {
  std::string title;
  SweepAxis along;
  const std::vector<response::SweepPoint> EstimateReport::* points;
};

// Returns the line style of a component. Styles distinguish components in print and for readers who do not see colours.
const char* styleOf(int index, std::size_t count) {
  static constexpr const char* kStyles[] = {"-", "--", "-.", ":"};
  return count > 1 ? kStyles[static_cast<std::size_t>(index) % std::size(kStyles)] : "-";
}

io::Curve curveOf(const EstimateReport& report, const FigureColumn& column, SweepQuantity y, int colour,
                  const char* style) {
  io::Curve curve = curveThrough(report.*column.points, column.along, y);
  curve.label = report.description.name;
  curve.colour = colour;
  curve.style = style;
  return curve;
}

// Draws a band between two thin lines around the sweep over frequency. It shows the effect of changes of the inputs.
void addBand(io::Axes& axes, const EstimateReport& report, const FigureColumn& column, SweepQuantity y, int colour) {
  if (!report.sensitivity || column.points != &EstimateReport::over_frequency) {
    return;
  }
  constexpr double kHairline = 0.7;
  for (const auto* points : {&report.sensitivity->low, &report.sensitivity->high}) {
    io::Curve curve = curveThrough(*points, column.along, y);
    curve.colour = colour;
    curve.style = ":";
    curve.width = kHairline;
    axes.curves.push_back(curve);
  }
  axes.curves.back().label = fmt::format("each input changed by {:g} %", 100.0 * report.sensitivity->share);
}

// Returns "constant amplitude 2 mm", or "constant amplitude of each" if the components differ in it.
std::string constantTitle(const std::string& what, const std::string& unit, const std::vector<EstimateReport>& reports,
                          const std::function<double(const EstimateReport&)>& value) {
  for (const EstimateReport& report : reports) {
    if (std::abs(value(report) / value(reports.front()) - 1.0) > 1e-9) {
      return fmt::format("constant {} of each component", what);
    }
  }
  return fmt::format("constant {} {:.4g} {}", what, value(reports.front()), unit);
}

// Draws the specified values that lie within the axes: markers for single values, and horizontal lines for the static
// stiffness K_st and the maximum stiffness K_max.
class SpecificationMarks {
 public:
  SpecificationMarks(const EstimateReport& report, int colour)
      : report_(report), specification_(report.description.written()), colour_(colour) {}

  void add(io::Axes& axes, const FigureColumn& column, bool stiffness) const {
    const bool over_amplitude = column.points == &EstimateReport::over_amplitude;
    const auto& points = report_.*column.points;
    if (points.empty()) {
      return;
    }
    const double low = column.along.value(points.front());
    const double high = column.along.value(points.back());
    if (!stiffness) {
      if (const auto angle = estimation::specifiedLossAngle(specification_); angle && !over_amplitude) {
        point(axes, "specified at f_n", "o", "nominal_frequency", *angle * kDegrees, low, high);
      }
      return;
    }
    level(axes, "K_st", ":", "static_stiffness", low, high);
    if (over_amplitude) {
      point(axes, "K_n at A_n", "o", "nominal_amplitude", specified("dynamic_stiffness"), low, high);
      return;
    }
    level(axes, "K_max", "-.", "maximum_stiffness", low, high);
    point(axes, "K_n at f_n", "o", "nominal_frequency", specified("dynamic_stiffness"), low, high);
    point(axes, "K at f_h", "s", "high_frequency", specified("high_frequency_stiffness"), low, high);
  }

 private:
  // Returns a specified stiffness [kN/mm]; NaN if it is not specified.
  double specified(const char* name) const {
    return specification_.valueOr(name, std::numeric_limits<double>::quiet_NaN()) * 1e-6;
  }

  void level(io::Axes& axes, const char* label, const char* style, const char* name, double low, double high) const {
    if (specification_.has(name)) {
      axes.curves.push_back({label, {low, high}, {specified(name), specified(name)}, style, colour_, kThin});
    }
  }

  void point(io::Axes& axes, const char* label, const char* style, const char* place, double y, double low,
             double high) const {
    const auto at = specification_.find(place);
    const double x = at.value_or(0.0) * (std::string(place) == "nominal_amplitude" ? 1e3 : 1.0);
    if (at && std::isfinite(y) && x >= low * (1.0 - kRounding) && x <= high * (1.0 + kRounding)) {
      axes.curves.push_back({label, {x}, {y}, style, colour_});
    }
  }

  static constexpr double kThin = 0.9;
  static constexpr double kRounding = 1e-9;

  const EstimateReport& report_;
  const estimation::Specification& specification_;
  int colour_;
};

}  // namespace

EstimateReport makeEstimateReport(const io::ComponentDescription& description, const SweepOptions& options) {
  const Sweeps sweeps = complete(options, description.specification());
  const component::Component component = description.makeComponent();
  EstimateReport report;
  report.description = description;
  report.elements = component.elements();
  report.notes = estimation::estimationNotes(description.model(), description.specification());
  const std::vector<std::string>& found = description.resolved().notes;
  report.notes.insert(report.notes.end(), found.begin(), found.end());
  report.linear = component.linear();
  report.product = sweeps.product;
  addFrictionNote(report);
  addWholeNote(report, component);

  io::Progress progress("stiffness and loss angle", 3 * static_cast<std::size_t>(options.points) + 1);
  const response::LoopOptions loops = loopsAbout(estimation::nominalDisplacement(description.specification()));
  const auto at = [&](double frequency, double amplitude) {
    const response::SweepPoint point = response::characteristicsAt(component, frequency, amplitude, loops);
    progress.advance();
    return point;
  };
  report.working_point = at(sweeps.frequency, sweeps.amplitude);
  for (const double frequency : sweeps.frequencies) {
    report.over_frequency.push_back(at(frequency, sweeps.amplitude));
    report.over_product.push_back(at(frequency, sweeps.product / frequency));
  }
  for (const double amplitude : sweeps.amplitudes) {
    report.over_amplitude.push_back(at(sweeps.frequency, amplitude));
  }
  if (!allSettled(report)) {
    report.notes.push_back(
        "loops marked with * (in JSON \"settled\": false) were not yet periodic when the simulation ended");
  }
  return report;
}

std::string toText(const EstimateReport& report) {
  std::string text = fmt::format("component {}, model {}\n", report.description.name,
                                 estimation::toString(report.description.model()));
  const estimation::Specification& written = report.description.written();
  if (const std::string specification = specificationText(written); !specification.empty()) {
    const std::string describes = estimation::toString(written.describes());
    text += fmt::format("  specification{}\n", describes.empty() ? "" : " of the " + describes) + specification;
  }
  if (report.description.specification().values() != written.values()) {
    text += "  base\n" + specificationText(report.description.specification());
  }
  text += "  elements\n";
  for (const element::ElementDescription& element : report.elements) {
    text += fmt::format("    {:<20} {}\n", element.type, elementText(element));
  }
  const response::SweepPoint& point = report.working_point;
  text += fmt::format(
      "  at {:g} Hz and {:g} mm\n    stiffness K {:.7g} N/m, loss angle {:.5g} deg = {:.6g} rad, "
      "relative damping {:.4g} %\n",
      point.frequency, point.amplitude * 1e3, point.characteristics.stiffness,
      point.characteristics.loss_angle * kDegrees, point.characteristics.loss_angle,
      50.0 * std::tan(point.characteristics.loss_angle));
  for (const std::string& note : report.notes) {
    text += "  note: " + note + "\n";
  }
  text += sweepText(fmt::format("over frequency at {:g} mm", point.amplitude * 1e3), report.over_frequency);
  text += sweepText(fmt::format("over amplitude at {:g} Hz{}", point.frequency,
                                report.linear ? " (linear: the same at every amplitude)" : ""),
                    report.over_amplitude);
  text += sweepText(fmt::format("at constant product of amplitude and frequency, {:g} mm Hz", report.product * 1e3),
                    report.over_product);
  text += report.sensitivity ? sensitivityText(*report.sensitivity) : "";
  return text;
}

std::string toJson(const std::vector<EstimateReport>& reports) {
  const nlohmann::ordered_json json = {{"schema", "rubber_suspension/estimate/1"},
                                       {"components", each(reports, reportJson)}};
  return json.dump(2) + "\n";
}

io::Figure toFigure(const std::vector<EstimateReport>& reports, Legends legends) {
  io::Figure figure{reports.size() == 1 ? "Stiffness and loss angle of " + reports.front().description.name
                                        : "Stiffness and loss angle"};
  const std::vector<FigureColumn> columns = {
      {constantTitle("amplitude", "mm", reports, [](const auto& r) { return r.working_point.amplitude * 1e3; }),
       kOverFrequency, &EstimateReport::over_frequency},
      {constantTitle("frequency", "Hz", reports, [](const auto& r) { return r.working_point.frequency; }),
       kOverAmplitude, &EstimateReport::over_amplitude},
      {constantTitle("product", "mm Hz", reports, [](const auto& r) { return r.product * 1e3; }), kOverFrequency,
       &EstimateReport::over_product}};
  figure.columns = 3;
  for (const bool stiffness : {true, false}) {
    for (const FigureColumn& column : columns) {
      io::Axes axes{column.title, column.along.label, stiffness ? "stiffness [kN/mm]" : "loss angle [deg]", true};
      for (std::size_t i = 0; i < reports.size(); ++i) {
        const int colour = static_cast<int>(i);
        const SweepQuantity quantity = stiffness ? stiffnessOf : angleOf;
        axes.curves.push_back(curveOf(reports[i], column, quantity, colour, styleOf(colour, reports.size())));
        addBand(axes, reports[i], column, quantity, colour);
      }
      for (std::size_t i = 0; i < reports.size(); ++i) {
        const std::size_t first = axes.curves.size();
        SpecificationMarks(reports[i], static_cast<int>(i)).add(axes, column, stiffness);
        // The legend names each kind of mark once.
        const bool once = i == 0 && &column == &columns.front();
        for (std::size_t mark = first; mark < axes.curves.size() && !once; ++mark) {
          axes.curves[mark].label.clear();
        }
      }
      for (io::Curve& curve : axes.curves) {
        if (legends == Legends::one && !figure.axes.empty()) {
          curve.label.clear();
        }
      }
      figure.axes.push_back(axes);
    }
  }
  return figure;
}

}  // namespace rubber_suspension::command
