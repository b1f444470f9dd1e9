// A virtual bench with one component, whose missing effect is known.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "rubber_suspension/component/component.h"
#include "rubber_suspension/diagnosis/experiment_limits.h"
#include "rubber_suspension/io/component_file.h"
#include "rubber_suspension/log/log.h"

namespace rubber_suspension::closed_loop {

/// A motion to be played: displacements [m] at a constant time step dt [s].
struct Programme {
  std::string name;
  double dt = 0.0;
  std::vector<double> displacement;
};

/// Simulates a component on a bench. The seed determines the model, the error of the specification (3 %), one missing
/// effect with a gap of 5 to 15 %, and noise of 0.3 to 1 %. Logs are played one after the other, with rests between.
class VirtualBench {
 public:
  explicit VirtualBench(unsigned seed);

  /// Returns the user's description of the component: without the effect, and with slightly wrong values.
  const io::ComponentDescription& component() const { return component_; }
  const std::string& effect() const { return effect_; }
  const diagnosis::ExperimentLimits& limits() const { return limits_; }

  /// Draws an ambiguous log of small motion: a sine of one frequency and amplitude, or slow triangles.
  Programme poorProgramme();

  /// Draws a motion of random spectrum and amplitude within the limits, with smooth ends and a duration [s].
  Programme randomProgramme(double duration);

  /// Plays a programme on the component in its present state, and returns the log.
  log::Log play(const Programme& programme);

  /// State of component and noise. By restoring it, two programmes can follow the same logs.
  struct Memory {
    component::ComponentState state;
    std::mt19937 noise;
    bool used = false;
  };
  Memory memory() const { return memory_; }
  void goBackTo(const Memory& memory) { memory_ = memory; }

 private:
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(draw_); }
  std::vector<double> forceOf(const component::Component& component, const Programme& programme) const;
  void addEffect(std::vector<element::ElementDescription> elements);

  std::mt19937 draw_;
  io::ComponentDescription component_;
  std::string effect_;
  diagnosis::ExperimentLimits limits_;
  std::vector<component::Component> true_component_;  // one component, constructed after all draws
  Memory memory_;
  double noise_ = 0.0;  // [N]
};

}  // namespace rubber_suspension::closed_loop
