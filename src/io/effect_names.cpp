// Names of effects.
#include "io/effect_names.h"

namespace rubber_suspension::io {

const std::vector<std::string>& effectNames() {
  static const std::vector<std::string> names = {"asymmetric_stiffness",
                                                 "backlash",
                                                 "bump_stop",
                                                 "creep",
                                                 "fluid_inertia",
                                                 "force_drift",
                                                 "force_offset",
                                                 "free_play",
                                                 "friction",
                                                 "inertia",
                                                 "lift_off",
                                                 "payne_effect",
                                                 "progressive_stiffness",
                                                 "radial_coupling",
                                                 "rate_amplitude_coupling",
                                                 "relaxation",
                                                 "self_heating",
                                                 "sensor_gain",
                                                 "series_compliance",
                                                 "stress_softening",
                                                 "temperature",
                                                 "time_delay",
                                                 "viscous_damping"};
  return names;
}

}  // namespace rubber_suspension::io
