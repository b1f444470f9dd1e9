// Diagnoses of virtual rigs, each run once per process and shared by all tests that use it.
#pragma once

#include <algorithm>
#include <cmath>

#include "checked_diagnosis.h"
#include "rig.h"

namespace rubber_suspension {

inline double stop(double /*time*/, double z, double /*rate*/) {
  const double depth = std::max(0.0, std::abs(z) - 0.0012);
  return std::copysign(3e6 * depth * std::sqrt(depth / 0.0008), z);  // softer at first touch than the candidate's stops
}

inline double linearStop(double /*time*/, double z, double /*rate*/) {
  return std::copysign(2e6 * std::max(0.0, std::abs(z) - 0.0012), z);
}

/// Returns a hum [N] of a drive that starts and stops. It is neither a function of the motion nor a steady line.
inline double hum(double time, double /*displacement*/, double /*rate*/) {
  return std::sin(1.3 * time) > 0.0 ? 170.0 * std::sin(314.159 * time) : 0.0;
}

/// Diagnoses three logs of a rig, and holds a fourth log out.
inline diagnosis::Diagnosis diagnoseRig(const RigEffect& effect,
                                        const io::ComponentDescription& component = rigComponent()) {
  return checkedDiagnosis(component, runRigs({1, 2, 4}, effect), runRigs({3}, effect));
}

inline const diagnosis::Diagnosis& ofNothing() {
  static const diagnosis::Diagnosis run = diagnoseRig(nothing);
  return run;
}

inline const diagnosis::Diagnosis& ofAStop() {
  static const diagnosis::Diagnosis run = diagnoseRig(stop);
  return run;
}

inline const diagnosis::Diagnosis& ofHum() {
  static const diagnosis::Diagnosis run = diagnoseRig(hum);
  return run;
}

/// Returns the diagnosis of one log without a gap and without a held-out log.
inline const diagnosis::Diagnosis& ofOneLog() {
  static const diagnosis::Diagnosis run = checkedDiagnosis(rigComponent(), runRigs({1}, nothing), {});
  return run;
}

}  // namespace rubber_suspension
