// A virtual laboratory that measures tables of stiffness and loss angle, with helpers for tests of their diagnosis.
#pragma once

#include "fit/table_fit.h"
#include "rubber_suspension/io/component_file.h"
#include "rubber_suspension/response/sweep.h"
#include "support/kit.h"

namespace rubber_suspension::diagnosis {

constexpr double kNoise = 0.01;    // relative noise of the complex stiffness in a good laboratory
constexpr int kMostCycles = 2000;  // largest number of cycles until a loop is settled

inline io::ComponentDescription bush(const std::string& model, const std::string& more = "") {
  return componentOf("components:\n  bush:\n    " + model + "\n" + more);
}

inline const char* const kZener =
    "{model: maxwell, specification: {static_stiffness: 1.0e6, dynamic_stiffness: 1.3e6, nominal_frequency: 4.0, "
    "break_frequency: 3.0}";
inline const char* const kZenerOff =
    "{model: maxwell, specification: {static_stiffness: 1.1e6, dynamic_stiffness: 1.4e6, nominal_frequency: 4.0, "
    "break_frequency: 3.5}";
inline const char* const kManyMaxwell =
    "{model: multi_maxwell, specification: {static_stiffness: 3.0e6, dynamic_stiffness: 4.2e6, nominal_frequency: 4.0, "
    "maximum_stiffness: 4.9e6, high_frequency: 25.0}";

/// Friction with a maximum force of 200 N.
inline const char* const kFriction = "{type: friction, maximum_force: 200, displacement: 4.0e-4}";

inline io::ComponentDescription without(const std::string& model) { return bush(model + "}"); }
inline io::ComponentDescription with(const std::string& model, const std::string& entry) {
  return bush(model + ", add: [" + entry + "]}");
}

// Measures the settled loop of a component without any code of the diagnosis.
inline fit::TablePoint pointOf(const component::Component& component, double frequency, double amplitude,
                               double mean = 0.0, int most_cycles = kMostCycles) {
  response::LoopOptions options;
  options.mean = mean;
  options.maximum_cycles = most_cycles;
  const auto loop = response::characteristicsAt(component, frequency, amplitude, options).characteristics;
  return {frequency, amplitude, loop.stiffness, loop.loss_angle, mean};
}

// Measures tables in which stiffness and loss angle have the same relative error.
class Laboratory {
 public:
  explicit Laboratory(unsigned seed, double noise = kNoise, int most_cycles = kMostCycles)
      : generator_(seed), normal_(0.0, noise / std::sqrt(2.0)), most_cycles_(most_cycles) {}

  fit::TablePoint measured(fit::TablePoint point) {
    point.stiffness *= 1.0 + normal_(generator_);
    point.loss_angle += normal_(generator_);
    return point;
  }

  fit::MeasuredTable table(const io::ComponentDescription& truth,
                           const std::vector<double>& frequencies = {0.5, 1.0, 2.0, 4.0, 8.0, 16.0},
                           const std::vector<double>& amplitudes = {1e-4, 3e-4, 1e-3, 2e-3}) {
    const component::Component component = truth.makeComponent();
    fit::MeasuredTable table;
    table.name = "lab";
    for (const double amplitude : amplitudes) {
      for (const double frequency : frequencies) {
        table.points.push_back(measured(pointOf(component, frequency, amplitude, 0.0, most_cycles_)));
      }
    }
    return table;
  }

 private:
  std::mt19937 generator_;
  std::normal_distribution<double> normal_;
  int most_cycles_;
};

}  // namespace rubber_suspension::diagnosis
