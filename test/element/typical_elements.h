// Typical parameters of every law for tests that cover all laws, and properties of the laws.
#pragma once

#include <ostream>

#include "rubber_suspension/component/component.h"
#include "support/kit.h"

namespace rubber_suspension::test {

/// Returns a surrogate of some kN for the motions of the tests, with a different weight for each function.
inline element::ElementDescription typicalResidual() {
  std::vector<double> weights(44);
  for (std::size_t i = 0; i < weights.size(); ++i) {
    weights[i] = 500.0 * std::cos(1.0 + static_cast<double>(i * i));
  }
  std::vector<double> resonance_weights(16);
  for (std::size_t i = 0; i < resonance_weights.size(); ++i) {
    resonance_weights[i] = 300.0 * std::sin(1.0 + static_cast<double>(i * i));
  }
  return {"residual",
          {{"stroke", {4e-3}},
           {"lowest", {-4e-3}},
           {"highest", {4e-3}},
           {"lowest_force", {-1e5}},
           {"highest_force", {1e5}},
           {"stops", {0.02, 0.05, 0.1, 0.2, 0.4, 0.7}},
           {"relaxation_times", {4e-3, 0.03, 0.25, 2.0}},
           {"amplitude_time", {0.3}},
           {"weights", weights},
           {"characteristic", {-900.0, -200.0, 40.0, 0.0, 300.0, -500.0, 800.0}},
           {"resonances", {1.0, 1.6, 2.5, 4.0, 6.0, 10.0, 16.0, 25.0}},
           {"resonance_weights", resonance_weights}}};
}

/// Returns all laws with parameters that suit a component of 3 kN/mm under motions of some millimetres.
inline std::vector<element::ElementDescription> typicalElements() {
  return {
      spring(3e6),
      entry("progressive_stiffness cubic=1e11 quintic=1e15"),
      entry("progressive_stiffness quintic=2e16"),
      entry("progressive_stiffness quadratic=2e8"),
      entry("progressive_stiffness exponential=2e5 exponential_scale=1e-3"),
      entry("radial_stiffness cubic=1e11 quintic=1e15"),
      entry("radial_stiffness quadratic=2e8 alone=0.3"),
      entry("asymmetric_stiffness quadratic=1e8 tension_stiffness=-2e5"),
      entry("asymmetric_stiffness exponential=2e5 exponential_scale=-1e-3"),
      entry("asymmetric_stiffness even_exponential=-2e5 exponential_scale=1e-3"),
      entry("asymmetric_stiffness slope_difference=3e5"),
      entry("spring_table displacement=-4e-3,-1e-3,0,2e-3,3e-3 force=-2e4,-3e3,0,6e3,1e4"),
      entry("spring_table displacement=-4e-3,-1e-3,0,1e-3,3e-3 force=-3e3,-3.5e3,0,6e3,5e3 monotone=0"),
      entry("bump_stop stiffness=2e7 gap=1e-3"),
      entry("bump_stop stiffness=2e7 gap=5e-4 exponent=1.5 side=-1"),
      dashpot(2e4),
      entry("dashpot damping=2e4 order=2"),
      entry("power_dashpot damping=2e4 reference_rate=0.05 exponent=2"),
      entry("power_dashpot damping=2e4 reference_rate=0.05 exponent=0.6"),
      entry("thinning_dashpot damping=2e4 half_rate=0.02"),
      entry("position_dashpot damping=2e4 reference_displacement=1e-3 power=3"),
      entry("position_dashpot damping=2e4 reference_displacement=5e-4 power=1 side=-1"),
      maxwell(1e6, 2.0),
      maxwell(1e6, 2000.0),
      entry("nonlinear_maxwell stiffness=1e6 break_frequency=2 displacement=5e-4"),
      entry("nonlinear_maxwell stiffness=1e6 break_frequency=2 displacement=5e-4 power=3"),
      entry("sliding_maxwell stiffness=1e6 break_frequency=2 yield_displacement=4e-4"),
      entry("payne_maxwell stiffness=1e6 break_frequency=2 recovery_time=0.3 travel=1e-3"),
      entry("payne_maxwell stiffness=1e6 break_frequency=0 recovery_time=0 travel=1e-3"),
      entry("transient_network stiffness=1e6 break_frequency=0 recovery_time=0.3 travel=1e-3"),
      entry("transient_network stiffness=1e6 break_frequency=2 recovery_time=20 travel=5e-3"),
      entry("payne_maxwell stiffness=1e6 break_frequency=2 recovery_time=0.3 travel=1e-3 dead_band=1e-4"),
      entry("transient_network stiffness=1e6 break_frequency=0 recovery_time=0.3 travel=1e-3 dead_band=1e-4"),
      entry("maxwell_behind_play stiffness=1e6 break_frequency=2 gap=2e-4"),
      entry("maxwell_behind_play stiffness=1e7 break_frequency=200 gap=4e-4"),
      entry("power_dashpot_behind_play stiffness=1e7 displacement=1e-4 reference_rate=0.02 exponent=2 gap=2e-4"),
      entry("power_dashpot_behind_play stiffness=1e7 displacement=1e-4 reference_rate=0.02 exponent=0.7 gap=2e-4"),
      entry("maxwell_along_curve displacement=-1e-3,5e-4,5e-4,2e-3 stiffness=4e5,1e6,1.5e6,3e6 break_frequency=2"),
      entry("maxwell_along_curve displacement=2e-3 stiffness=3e6 break_frequency=2 growth=2.5 side=1"),
      entry("dashpot_along_curve displacement=-1e-3,2e-3 damping=5e3,2e4"),
      entry("sliders_along_curve displacement=-1e-3,2e-3 factor=0.5,2 yield_displacement=4e-4,1e-4 stiffness=1e6,5e5"),
      entry("springpot stiffness=1e6 order=0.3 low_frequency=0.1 high_frequency=50"),
      entry("creep stiffness_per_decade=2e5 shortest_time=0.05 longest_time=5"),
      friction(5e3, 2.2e-3),
      entry("friction maximum_force=2e3 displacement=3e-4 dead_band=2e-5"),
      entry("bouc_wen stiffness=2e6 beta=600 gamma=300"),
      entry("bouc_wen stiffness=2e6 beta=0.1 gamma=-0.05 exponent=2"),
      entry("bouc_wen stiffness=2e6 beta=5 gamma=4 exponent=1.5"),
      entry("inertia_track mass=250 damping=6e3 stiffness=1e6"),
      entry("inertia_track mass=20 damping=2e4 stiffness=1e6"),
      entry("inertia_track inertance=1e7 resistance=2.5e8 compliance=2.5e-11 pumping_area=5e-3"),
      entry("inertia_track mass=250 damping=6e3 stiffness=1e6 free_travel=2e-4"),
      entry("inertia_track mass=250 damping=3e3 stiffness=1e6 quadratic_damping=1e5"),
      entry("inertia_track mass=250 damping=3e3 stiffness=1e6 free_travel=2e-4 quadratic_damping=1e5"),
      entry("coulomb_friction maximum_force=2e3 stiffness=1e7"),
      entry("iwan maximum_force=5e3 displacement=1e-3"),
      entry("iwan maximum_force=5e3 displacement=1e-3 sliders=3"),
      entry("iwan_table yield_displacement=2e-3,1e-4,5e-4 stiffness=4e5,2e6,1e6"),
      entry("variable_friction stiffness=1e6 yield_displacement=4e-4 growth_displacement=1e-3"),
      entry("variable_friction stiffness=1e6 yield_displacement=6e-4 travel=0.05"),
      entry("variable_friction stiffness=1e6 yield_displacement=6e-4 travel=0.02 build_up_time=0.3"),
      entry("viscoplastic_friction stiffness=1e6 yield_displacement=4e-4 half_rate=5e-3"),
      entry("overstress stiffness=1e6 yield_displacement=4e-4 reference_rate=5e-3"),
      entry("overstress stiffness=1e6 yield_displacement=2e-4 reference_rate=5e-2 power=3.5"),
      entry("friction_behind_play stiffness=1e6 yield_displacement=4e-4 gap=2e-4"),
      entry("first_loading stiffness=1e6 yield_share=0.5"),
      entry("first_loading stiffness=1e6 yield_share=0.1 side=-1"),
      entry("stress_softening reduction=0.3"),
      entry("stress_softening reduction=0.3 width=0.2 path=0.01"),
      entry("stress_softening reduction=0.4 reach_exponent=2 full_reach=4e-3 side=1"),
      entry("stress_softening reduction=0.3 recovery_time=0.05"),
      entry("stress_softening reduction=0.3 width=1.5 ratio_power=1"),
      entry("self_heating energy_sensitivity=1e-3 time_constant=20"),
      entry("wlf_shift c1=6.14 c2=146.6 reference=20"),
      entry("arrhenius_shift activation_energy=5e4 reference=20 vertical=3.4e-3"),
      entry("vertical_shift coefficient=-5e-3 reference=20"),
      entry("transition_shift share=0.1 width=8 reference=20"),
      entry("sensor_gain gain=0.08"),
      entry("free_play gap=2e-4"),
      entry("free_play gap=4e-4 share=0.6"),
      entry("series_compliance stiffness=3e7"),
      entry("series_compliance stiffness=1e7 side=-1"),
      entry("series_compliance stiffness=1e7 closing_force=2e3"),
      entry("lift_off side=1"),
      entry("lift_off side=-1 slack_stiffness=1e6"),
      entry("lift_off side=1 preload=800"),
      entry("lift_off side=-1 slack_stiffness=1e6 preload=800"),
      entry("time_delay delay=3.3e-3"),
      entry("time_delay delay=-2.5e-4"),
      entry("inertia mass=12"),
      entry("inertia mass=12 bandwidth=30"),
      entry("force_offset offset=-150"),
      entry("force_drift rate=20"),
      typicalResidual(),
  };
}

/// Returns true for laws that add a force, false for mounts and for effects on displacement or force.
inline bool addsForce(const element::ElementDescription& description) {
  return element::lawOf(element::makeElement(description)).action() == element::Action::adds_force;
}

/// Returns a component for tests of a law: the law alone if it adds a force, otherwise a specimen with loss, the
/// elements `with` and the law.
inline component::Component subject(const element::ElementDescription& description,
                                    const std::vector<element::ElementDescription>& with = {
                                        entry("coulomb_friction maximum_force=1e3 stiffness=5e6")}) {
  std::vector<element::ElementDescription> elements;
  if (!addsForce(description)) {
    elements = {spring(3e6), maxwell(1e6, 2.0)};
    elements.insert(elements.end(), with.begin(), with.end());
  }
  elements.push_back(description);
  return component::Component(elements);
}

/// Returns the law on a linear specimen for tests of K*.
inline component::Component linearSubject(const element::ElementDescription& description) {
  return subject(description, {});
}

inline bool isOneOf(const element::ElementDescription& description, const std::vector<std::string>& types) {
  return std::find(types.begin(), types.end(), description.type) != types.end();
}

inline bool isPassive(const element::ElementDescription& description) {
  return element::lawOf(element::makeElement(description)).passive();
}

/// Returns true if the law is a force of the component, not of the rig, that depends on the displacement alone.
inline bool isElastic(const element::ElementDescription& description) {
  const element::ElementPointer element = element::makeElement(description);
  const auto* law = std::get_if<std::shared_ptr<const element::ParallelElement>>(&element);
  return law != nullptr && !(*law)->onRig() && (*law)->part() == element::Part::elastic;
}

/// Returns true if a step of any length is exact for linearly varying displacement. Free play and delay are excluded,
/// because they bend the line between two samples; their own tests cover this.
inline bool isExact(const element::ElementDescription& description) {
  const bool approximate =
      isOneOf(description,
              {"self_heating", "series_compliance", "lift_off", "inertia", "free_play", "time_delay", "power_dashpot",
               "position_dashpot", "thinning_dashpot", "power_dashpot_behind_play", "overstress", "nonlinear_maxwell",
               "variable_friction", "viscoplastic_friction", "residual", "dashpot_along_curve"});
  const bool softens_slowly = description.type == "stress_softening" &&
                              (description.values.count("path") != 0 || description.values.count("recovery_time") != 0);
  // The mean speed changes within such a step, and a dead band ends within it.
  const bool softens_in_motion =
      (description.type == "payne_maxwell" && description.value("recovery_time") > 0.0) ||
      (description.type == "transient_network" && description.values.count("dead_band") != 0);
  const bool smooth = description.type == "dashpot" && description.values.count("order") != 0;
  const bool substepped = description.type == "bouc_wen" && description.values.count("exponent") != 0;
  const bool turbulent = description.values.count("quadratic_damping") != 0;
  return !approximate && !softens_slowly && !softens_in_motion && !smooth && !substepped && !turbulent;
}

}  // namespace rubber_suspension::test

namespace rubber_suspension {

/// Prints an entry in the messages of parameterised tests.
inline void PrintTo(const element::ElementDescription& description, std::ostream* stream) {
  *stream << description.type;
  for (const auto& [name, values] : description.values) {
    *stream << ' ' << name << '=';
    for (const double value : values) {
      *stream << value << ' ';
    }
  }
}

}  // namespace rubber_suspension
