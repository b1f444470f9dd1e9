// Figures 3, 4, 5, 6 and 8 of Polach (IAVSD 2015).
#include "command/paper_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "command/sweep_values.h"
#include "io/progress.h"
#include "log/new_file.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/estimation/specification.h"

namespace rubber_suspension::command {
namespace {

constexpr double kNominalFrequency = 4.0;   // f_n [Hz]
constexpr double kNominalAmplitude = 2e-3;  // A_n [m]
constexpr double kProduct = 8e-3;           // P [m Hz]

using Values = std::vector<std::pair<std::string, double>>;

component::Component exampleModel(estimation::Model model, const Values& further) {
  estimation::Specification specification;
  specification.set("dynamic_stiffness", 4.2e6);
  specification.set("nominal_frequency", kNominalFrequency);
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
  return {"M6 Berg", exampleModel(estimation::Model::berg, {{"nominal_amplitude", kNominalAmplitude},
                                                            {"relative_damping", 0.05},
                                                            {"break_frequency", 1.45}})};
}

std::vector<NamedComponent> allModels() {
  return {
      {"M1 Kelvin-Voigt", exampleModel(estimation::Model::kelvin_voigt, {{"relative_damping", 0.05}})},
      {"M2 Maxwell", exampleModel(estimation::Model::maxwell, {{"break_frequency", 1.43}})},
      {"M3 Maxwell, dashpot",
       exampleModel(estimation::Model::maxwell_dashpot, {{"break_frequency", 0.5}, {"relative_damping", 0.05}})},
      {"M4 friction", exampleModel(estimation::Model::friction,
                                   {{"nominal_amplitude", kNominalAmplitude}, {"relative_damping", 0.05}})},
      {"M5 friction, dashpot", exampleModel(estimation::Model::friction_dashpot,
                                            {{"nominal_amplitude", kNominalAmplitude}, {"relative_damping", 0.05}})},
      bergModel()};
}

std::vector<NamedComponent> maxwellModels() {
  std::vector<NamedComponent> models;
  for (const double break_frequency : {0.5, 1.0, 2.0, 4.0, 8.0}) {
    models.push_back({fmt::format("M2, f_b = {:g} Hz", break_frequency),
                      exampleModel(estimation::Model::maxwell, {{"break_frequency", break_frequency}})});
  }
  return models;
}

std::vector<NamedComponent> multiMaxwellModels() {
  std::vector<NamedComponent> models;
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
  values.push_back(kNominalAmplitude);
  std::sort(values.begin(), values.end());
  return values;
}

io::Axes sweepAxes(const PaperFigure& figure, bool over_amplitude, const std::string& y_label,
                   double (*y)(const response::SweepPoint&)) {
  io::Axes axes;
  axes.x_label = over_amplitude ? "amplitude [mm]" : "frequency [Hz]";
  axes.y_label = y_label;
  axes.log_x = true;
  for (const PaperCurve& paper_curve : figure.curves) {
    io::Curve curve;
    curve.label = paper_curve.label;
    for (const response::SweepPoint& point : paper_curve.points) {
      curve.x.push_back(over_amplitude ? point.amplitude * 1e3 : point.frequency);
      curve.y.push_back(y(point));
    }
    axes.curves.push_back(curve);
  }
  return axes;
}

void drawSweeps(PaperFigure& figure, bool over_amplitude) {
  figure.figure.title = figure.title;
  figure.figure.axes = {sweepAxes(figure, over_amplitude, "stiffness [kN/mm]", stiffnessOf),
                        sweepAxes(figure, over_amplitude, "loss angle [deg]", angleOf)};
}

PaperFigure breakFrequencyFigure() {
  PaperFigure figure{
      3,
      fmt::format("Figure 3: M2 for several break frequencies, all through K_n at {:g} Hz", kNominalFrequency),
      {},
      {}};
  for (const NamedComponent& model : maxwellModels()) {
    figure.curves.push_back(
        {model.label, response::sweepFrequency(model.component, frequencies(), kNominalAmplitude), {}});
  }
  drawSweeps(figure, false);
  return figure;
}

PaperFigure productFigure(int number, const std::string& title, const std::vector<NamedComponent>& models) {
  PaperFigure figure{number, fmt::format("Figure {}: {}, A f = {:g} mm Hz", number, title, kProduct * 1e3), {}, {}};
  for (const NamedComponent& model : models) {
    figure.curves.push_back(
        {model.label, response::sweepConstantProduct(model.component, frequencies(), kProduct), {}});
  }
  drawSweeps(figure, false);
  return figure;
}

PaperFigure amplitudeFigure() {
  PaperFigure figure{5, fmt::format("Figure 5: models over amplitude at {:g} Hz", kNominalFrequency), {}, {}};
  for (const NamedComponent& model : allModels()) {
    figure.curves.push_back(
        {model.label, response::sweepAmplitude(model.component, amplitudes(), kNominalFrequency), {}});
  }
  drawSweeps(figure, true);
  return figure;
}

// A model per panel: the loop at the working point is nearly the same ellipse for all that meet it.
PaperFigure loopFigure() {
  PaperFigure figure{
      6,
      fmt::format("Figure 6: loops of the models at {:g} Hz and {:g} mm", kNominalFrequency, kNominalAmplitude * 1e3),
      {},
      {}};
  figure.figure.title = figure.title;
  figure.figure.columns = 3;
  for (const NamedComponent& model : allModels()) {
    const response::SettledLoop loop =
        response::simulateSettledLoop(model.component, kNominalFrequency, kNominalAmplitude);
    figure.curves.push_back({model.label, {}, loop});
    io::Curve curve;
    for (std::size_t i = 0; i <= loop.force.size(); ++i) {
      curve.x.push_back(loop.displacement[i % loop.force.size()] * 1e3);
      curve.y.push_back(loop.force[i % loop.force.size()] * 1e-3);
    }
    io::Axes axes;
    axes.title = model.label;
    axes.x_label = "displacement [mm]";
    axes.y_label = "force [kN]";
    axes.curves = {curve};
    figure.figure.axes.push_back(axes);
  }
  return figure;
}

// Quotes a label, which may hold commas.
std::string csvText(const PaperFigure& figure) {
  const bool loops = !figure.curves.at(0).loop.force.empty();
  std::string text =
      loops ? "curve,displacement_m,force_n\n" : "curve,frequency_hz,amplitude_m,stiffness_n_per_m,loss_angle_rad\n";
  for (const PaperCurve& curve : figure.curves) {
    for (const response::SweepPoint& point : curve.points) {
      text += fmt::format("\"{}\",{:.17g},{:.17g},{:.17g},{:.17g}\n", curve.label, point.frequency, point.amplitude,
                          point.characteristics.stiffness, point.characteristics.loss_angle);
    }
    for (std::size_t i = 0; i < curve.loop.force.size(); ++i) {
      text += fmt::format("\"{}\",{:.17g},{:.17g}\n", curve.label, curve.loop.displacement[i], curve.loop.force[i]);
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
  return {breakFrequencyFigure(), productFigure(4, "models over frequency", allModels()), amplitudeFigure(),
          loopFigure(), productFigure(8, "three and five Maxwell elements beside M6", multiMaxwellModels())};
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
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    throw std::runtime_error(folder + ": " + error.message());
  }
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
