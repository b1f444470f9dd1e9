// Reduces a component to a stiffness and a damping constant, for programs that accept nothing else.
#pragma once

#include <string>
#include <vector>

#include "rubber_suspension/component/component.h"

namespace rubber_suspension::command {

/// The frequency and amplitude of a sine.
struct WorkingPoint {
  double frequency = 0.0;  ///< [Hz]
  double amplitude = 0.0;  ///< [m]
};

/// Returns stiffness and loss angle of the settled loop as text, "4.2 kN/mm and 5.7 degrees at 4 Hz and 1 mm".
std::string stiffnessText(const component::Component& component, const WorkingPoint& at);

struct SpringAndDashpot {
  double stiffness = 0.0;          ///< k = Re K* [N/m]
  double damping = 0.0;            ///< c = Im K*/(2 pi f) [N s/m]
  std::vector<std::string> notes;  ///< differences from the component at other frequencies and amplitudes
};

/// Returns a spring and a dashpot in parallel that have the complex stiffness of the component under this sine. Throws
/// std::invalid_argument unless frequency and amplitude are positive and finite.
SpringAndDashpot springAndDashpot(const component::Component& component, const WorkingPoint& at);

/// Returns YAML with both constants, in N, m, s and in N, mm, s. The notes are added as comments.
std::string toYaml(const std::string& name, const SpringAndDashpot& values, const WorkingPoint& at);

std::string asComments(const std::vector<std::string>& notes, const std::string& mark);

}  // namespace rubber_suspension::command
