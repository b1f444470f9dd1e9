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

/// Returns displacements [m] that are the sum of three sines of 1.3, 4 and 17 Hz with 2 mm in total, so that friction
/// reverses about 20 times per second.
std::vector<double> benchmarkDisplacement(std::size_t samples);

/// Stamps every millisecond, or at random steps of 0.7 to 1.3 ms (with a fixed seed) that differ from one to the next.
enum class Stamps { even, uneven };
std::vector<std::int64_t> stampsOf(Stamps kind, std::size_t samples);

/// Parameters of a component: spring, friction, and Maxwell elements whose break frequencies form a geometric series.
struct ExampleParameters {
  double spring = 3.0e6;                  ///< [N/m]
  std::vector<double> stiffness;          ///< stiffness of each Maxwell element [N/m]
  std::vector<double> break_frequency;    ///< [Hz]
  double maximum_force = 5000.0;          ///< F_max [N]
  double friction_displacement = 2.2e-3;  ///< z2 [m]

  /// Creates this number of Maxwell elements, with 1.9 MN/m together and break frequencies between 0.03 and 25 Hz.
  explicit ExampleParameters(int maxwell_elements = 5);

  /// Returns these parameters with all stiffnesses multiplied by one factor and the friction force by another.
  ExampleParameters scaled(double by_stiffness, double by_force) const;

  std::vector<element::ElementDescription> elements() const;
};

/// Simulates the motion. Each method uses another call of the library and sets `force` [N].
struct ExampleRun {
  component::Component component;
  log::Log log;
  std::vector<double> steps;  ///< length of the step that ends at each sample [s], 0 at the first sample
  std::vector<double> force;

  ExampleRun(const ExampleParameters& parameters, Stamps kind, std::size_t samples);

  void step();
  void push();
  void simulate();
  void simulateWholeLog();
};

/// Returns laws of six directions with the elements of ExampleParameters; coupled directions have `iwan` as friction.
component::SixDirectionsLaws exampleBush(component::Coupling coupling);

}  // namespace rubber_suspension::benchmark
