// A virtual bench with one component whose missing effect is known.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "rubber_suspension/component/component.h"
#include "rubber_suspension/diagnosis/experiment_limits.h"
#include "rubber_suspension/io/component_file.h"
#include "rubber_suspension/log/log.h"

namespace rubber_suspension::closed_loop {

/// A motion to play: displacement [m] at even steps dt [s].
struct Programme {
  std::string name;
  double dt = 0.0;
  std::vector<double> displacement;
};

/// A component on a bench: drawn from a seed are its model, what the specification errs by (3 %), one missing effect
/// that makes a gap of 5 to 15 %, and noise of 0.3 to 1 %. The component goes through its logs one after the other and
/// rests between them.
class VirtualBench {
 public:
  explicit VirtualBench(unsigned seed);

  /// What the user wrote: without the effect, of values that are a little off.
  const io::ComponentDescription& component() const { return component_; }
  const std::string& effect() const { return effect_; }
  const diagnosis::ExperimentLimits& limits() const { return limits_; }

  /// A log that leaves much open: a sine of one frequency and amplitude or slow triangles, of small motion.
  Programme poorProgramme();

  /// Motion of a random spectrum and amplitude, eased in and out, of this length [s], within the limits.
  Programme randomProgramme(double duration);

  /// Play on the component as the logs so far have left it.
  log::Log play(const Programme& programme);

  /// The state of the component and of the noise, to play two programmes after the same logs.
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
  std::vector<component::Component> true_component_;  // one, made once all is drawn
  Memory memory_;
  double noise_ = 0.0;  // [N]
};

}  // namespace rubber_suspension::closed_loop
