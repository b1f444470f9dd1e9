// The component and the motion of a benchmark, and the calls that compute its forces.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "rubber_suspension/component/component.h"
#include "rubber_suspension/component/six_directions.h"
#include "rubber_suspension/log/log.h"

namespace rubber_suspension::benchmark {

constexpr double kStep = 1e-3;  ///< sampling interval [s]

/// Returns the sum of three sines of 1.3, 4 and 17 Hz, 2 mm in total [m]; friction reverses some 20 times a second.
std::vector<double> benchmarkDisplacement(std::size_t samples);

/// Stamps [ns] every millisecond, or with steps between 0.7 and 1.3 ms of which no two in a row are equal (fixed seed).
enum class Stamps { even, uneven };
std::vector<std::int64_t> stampsOf(Stamps kind, std::size_t samples);

/// Parameters of a component: spring, Maxwell elements evenly spaced over the log of frequency, friction.
struct ExampleParameters {
  double spring = 3.0e6;                  ///< [N/m]
  std::vector<double> stiffness;          ///< of the Maxwell elements [N/m]
  std::vector<double> break_frequency;    ///< [Hz]
  double maximum_force = 5000.0;          ///< F_max [N]
  double friction_displacement = 2.2e-3;  ///< z2 [m]

  /// Creates this number of Maxwell elements, 1.9 MN/m together, with break frequencies from 0.03 to 25 Hz.
  explicit ExampleParameters(int maxwell_elements = 5);

  /// Returns the parameters with stiffnesses and friction force times these factors.
  ExampleParameters scaled(double by_stiffness, double by_force) const;

  /// Returns the numbers as entries of a component file.
  std::vector<element::ElementDescription> elements() const;
};

/// Simulates the motion by each of the library's calls; each of them sets `force` [N].
struct ExampleRun {
  component::Component component;
  log::Log log;
  std::vector<double> steps;  ///< step that ends at each sample [s]; the first is 0
  std::vector<double> force;

  ExampleRun(const ExampleParameters& parameters, Stamps kind, std::size_t samples);

  void step();
  void push();
  void simulate();
  void simulateWholeLog();
};

/// Returns laws of six directions with these elements; friction is `iwan` where directions act together.
component::SixDirectionsLaws exampleBush(component::Coupling coupling);

}  // namespace rubber_suspension::benchmark
