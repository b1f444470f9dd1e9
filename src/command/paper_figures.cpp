// Figures 3, 4, 5, 6 and 8 of Polach (IAVSD 2015).
#include "command/paper_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "command/sweep_values.h"
#include "element/each.h"
#include "io/output_files.h"
#include "io/progress.h"
#include "log/new_file.h"
#include "rubber_suspension/estimation/specification.h"

namespace rubber_suspension::command {
namespace {

constexpr double kFrequency = 4.0;        // f_n [Hz]
constexpr double kAmplitude = 2e-3;       // A_n [m]
constexpr double kProduct = 8e-3;         // P [m Hz]
constexpr double kBreakFrequency = 1.43;  // of M2, as the paper prints it [Hz]

using Values = std::vector<std::pair<std::string, double>>;

component::Component exampleModel(estimation::Model model, const Values& further) {
  estimation::Specification specification;
  specification.set("dynamic_stiffness", 4.2e6);
  specification.set("nominal_frequency", kFrequency);
  if (model != estimation::Model::kelvin_voigt) {
    specification.set("static_stiffness", 3e6);
  }
  for (const auto& [key, value] : further) {
    specification.set(key, value);
  }
  return component::Component(estimation::estimate(model, specification));
}

struct NamedComponent {
  std::string label;
  component::Component component;
};

NamedComponent bergModel() {
  return {"M6 Berg",
          exampleModel(estimation::Model::berg,
                       {{"nominal_amplitude", kAmplitude}, {"relative_damping", 0.05}, {"break_frequency", 1.45}})};
}

std::vector<NamedComponent> allModels() {
  return {{"M1 Kelvin-Voigt", exampleModel(estimation::Model::kelvin_voigt, {{"relative_damping", 0.05}})},
          {"M2 Maxwell", exampleModel(estimation::Model::maxwell, {{"break_frequency", kBreakFrequency}})},
          {"M3 Maxwell, dashpot",
           exampleModel(estimation::Model::maxwell_dashpot, {{"break_frequency", 0.5}, {"relative_damping", 0.05}})},
          {"M4 friction",
           exampleModel(estimation::Model::friction, {{"nominal_amplitude", kAmplitude}, {"relative_damping", 0.05}})},
          {"M5 friction, dashpot", exampleModel(estimation::Model::friction_dashpot,
                                                {{"nominal_amplitude", kAmplitude}, {"relative_damping", 0.05}})},
          bergModel()};
}

std::vector<NamedComponent> maxwellModels() {
  return element::each(std::array{0.5, 1.0, kBreakFrequency, 2.0, 4.0, 8.0}, [](double frequency) -> NamedComponent {
    return {fmt::format("M2, f_b = {:g} Hz", frequency),
            exampleModel(estimation::Model::maxwell, {{"break_frequency", frequency}})};
  });
}

std::vector<NamedComponent> multiMaxwellModels() {
  std::vector<NamedComponent> models = {
      {"M2, n_M = 1", exampleModel(estimation::Model::maxwell, {{"maximum_stiffness", 4.9e6}})}};
  for (const int count : {3, 5}) {
    models.push_back(
        {fmt::format("M2, n_M = {}", count),
         exampleModel(estimation::Model::multi_maxwell,
                      {{"maximum_stiffness", 4.9e6}, {"high_frequency", 25.0}, {"maxwell_elements", count}})});
  }
  models.push_back(bergModel());
  return models;
}

// Evenly spaced on a log axis, and the round frequencies that tables quote.
std::vector<double> frequencies() {
  std::vector<double> values = response::logSpaced(0.1, 40.0, 53);
  for (const double round : {0.5, 1.0, 2.0, 4.0, 8.0, 12.0, 20.0}) {
    values.push_back(round);
  }
  std::sort(values.begin(), values.end());
  return values;
}

std::vector<double> amplitudes() {
  std::vector<double> values = response::logSpaced(0.05e-3, 10e-3, 47);
  values.push_back(kAmplitude);
  std::sort(values.begin(), values.end());
  return values;
}

io::Axes sweepAxes(const std::vector<PaperCurve>& curves, const SweepAxis& along, const std::string& y_label,
                   SweepQuantity quantity) {
  io::Axes axes{"", along.label, y_label, true};
  for (const PaperCurve& curve : curves) {
    axes.curves.push_back(curveThrough(curve.points, along, quantity));
    axes.curves.back().label = curve.label;
  }
  return axes;
}

// A row of axes, stiffness on the left and loss angle on the right.
void addRow(PaperFigure& figure, const SweepAxis& along, const std::vector<PaperCurve>& curves) {
  figure.figure.axes.push_back(sweepAxes(curves, along, "stiffness [kN/mm]", stiffnessOf));
  figure.figure.axes.push_back(sweepAxes(curves, along, "loss angle [deg]", angleOf));
  figure.curves.insert(figure.curves.end(), curves.begin(), curves.end());
}

PaperFigure titled(int number, const std::string& title) {
  PaperFigure figure{number, fmt::format("Figure {}: {}", number, title), {}, {}};
  figure.figure.title = figure.title;
  return figure;
}

template <class Sweep>
std::vector<PaperCurve> curvesOf(const std::vector<NamedComponent>& models, Sweep sweep) {
  return element::each(models, [&](const NamedComponent& model) -> PaperCurve {
    return {model.label, sweep(model.component)};
  });
}

std::vector<PaperCurve> overFrequency(const std::vector<NamedComponent>& models) {
  return curvesOf(models, [](const component::Component& component) {
    return response::sweepFrequency(component, frequencies(), kAmplitude);
  });
}

// Halfway on a log axis, and as far beyond both ends.
std::vector<double> edgesOf(const std::vector<double>& centres) {
  const double half = std::sqrt(centres[1] / centres[0]);
  std::vector<double> edges = {centres[0] / half};
  for (const double centre : centres) {
    edges.push_back(centre * half);
  }
  return edges;
}

io::Axes surface(const PaperCurve& curve, const std::vector<double>& frequencies, std::vector<double> amplitudes,
                 const std::string& label, SweepQuantity quantity) {
  io::Axes axes{curve.label, "frequency [Hz]", "amplitude [mm]", true, true};
  std::for_each(amplitudes.begin(), amplitudes.end(), [](double& amplitude) { amplitude *= 1e3; });
  io::HeatMap map{edgesOf(frequencies), edgesOf(amplitudes), {}, label};
  std::transform(curve.points.begin(), curve.points.end(), std::back_inserter(map.values), quantity);
  axes.maps = {map};
  return axes;
}

PaperFigure surfaceFigure() {
  PaperFigure figure = titled(3, "stiffness and loss angle over frequency and amplitude");
  // Eight steps a decade, so that f_n and A_n are among them.
  const std::vector<double> over_frequency = response::logSpaced(0.04, 40.0, 25);
  const std::vector<double> over_amplitude = response::logSpaced(0.02e-3, 20e-3, 25);
  const std::vector<NamedComponent> all = allModels();
  for (const std::size_t model : {0, 1, 3, 5}) {
    PaperCurve curve{all[model].label, {}};
    for (const double amplitude : over_amplitude) {
      const auto row = response::sweepFrequency(all[model].component, over_frequency, amplitude);
      curve.points.insert(curve.points.end(), row.begin(), row.end());
    }
    figure.figure.axes.push_back(surface(curve, over_frequency, over_amplitude, "stiffness [kN/mm]", stiffnessOf));
    figure.figure.axes.push_back(surface(curve, over_frequency, over_amplitude, "loss angle [deg]", angleOf));
    figure.curves.push_back(curve);
  }
  return figure;
}

PaperFigure modelFigure() {
  PaperFigure figure = titled(
      4, fmt::format("models over frequency at {:g} mm, and over amplitude at {:g} Hz", kAmplitude * 1e3, kFrequency));
  const std::vector<NamedComponent> models = allModels();
  addRow(figure, kOverFrequency, overFrequency(models));
  addRow(figure, kOverAmplitude, curvesOf(models, [](const component::Component& component) {
           return response::sweepAmplitude(component, amplitudes(), kFrequency);
         }));
  return figure;
}

PaperFigure breakFrequencyFigure() {
  PaperFigure figure =
      titled(6, fmt::format("M2 for several break frequencies, all through K_n at {:g} Hz", kFrequency));
  addRow(figure, kOverFrequency, overFrequency(maxwellModels()));
  return figure;
}

PaperFigure productFigure(int number, const std::string& title, const std::vector<NamedComponent>& models) {
  PaperFigure figure = titled(number, fmt::format("{}, A f = {:g} mm Hz", title, kProduct * 1e3));
  addRow(figure, kOverFrequency, curvesOf(models, [](const component::Component& component) {
           return response::sweepConstantProduct(component, frequencies(), kProduct);
         }));
  return figure;
}

// Quotes a label, which may hold commas.
std::string csvText(const PaperFigure& figure) {
  std::string text = "curve,frequency_hz,amplitude_m,stiffness_n_per_m,loss_angle_rad\n";
  for (const PaperCurve& curve : figure.curves) {
    for (const response::SweepPoint& point : curve.points) {
      text += fmt::format("\"{}\",{:.17g},{:.17g},{:.17g},{:.17g}\n", curve.label, point.frequency, point.amplitude,
                          point.characteristics.stiffness, point.characteristics.loss_angle);
    }
  }
  return text;
}

constexpr int kNumbers[] = {3, 4, 5, 6, 8};  // of the figures that paperFigures() makes

std::string basePath(const std::string& folder, int number) {
  return (std::filesystem::path(folder) / fmt::format("figure_{}", number)).string();
}

}  // namespace

std::vector<PaperFigure> paperFigures() {
  return {surfaceFigure(), modelFigure(), productFigure(5, "models over frequency", allModels()),
          breakFrequencyFigure(),
          productFigure(8, "one, three and five Maxwell elements and M6", multiMaxwellModels())};
}

std::vector<std::string> paperFigurePaths(const std::string& folder) {
  std::vector<std::string> paths;
  for (const int number : kNumbers) {
    for (const char* extension : {".csv", ".svg", ".png"}) {
      paths.push_back(basePath(folder, number) + extension);
    }
  }
  return paths;
}

std::vector<std::string> writePaperFigures(const std::vector<PaperFigure>& figures, const std::string& folder) {
  io::makeFolder(folder);
  io::Progress progress("figures", figures.size());
  std::vector<std::string> paths;
  for (const PaperFigure& figure : figures) {
    const std::string base = basePath(folder, figure.number);
    log::writeNewFile(base + ".csv", csvText(figure));
    io::drawFigure(figure.figure, base + ".svg");
    io::drawFigure(figure.figure, base + ".png");
    paths.insert(paths.end(), {base + ".csv", base + ".svg", base + ".png"});
    progress.advance();
  }
  return paths;
}

}  // namespace rubber_suspension::command
