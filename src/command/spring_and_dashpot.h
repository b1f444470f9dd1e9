// A component as one stiffness and one damping constant, for programs that have nothing else.
#pragma once

#include <string>
#include <vector>

#include "rubber_suspension/component/component.h"

namespace rubber_suspension::command {

/// Frequency and amplitude of a sine.
struct WorkingPoint {
  double frequency = 0.0;  ///< [Hz]
  double amplitude = 0.0;  ///< [m]
};

/// Returns K and loss angle of the settled loop at a point as "4.2 kN/mm and 5.7 degrees at 4 Hz and 1 mm".
std::string stiffnessText(const component::Component& component, const WorkingPoint& at);

struct SpringAndDashpot {
  double stiffness = 0.0;          ///< k = Re K* [N/m]
  double damping = 0.0;            ///< c = Im K*/(2 pi f) [N s/m]
  std::vector<std::string> notes;  ///< differences from the component at other frequencies and amplitudes
};

/// Returns a spring and a dashpot in parallel with the component's complex stiffness at the point. Throws
/// std::invalid_argument unless frequency and amplitude are positive and finite.
SpringAndDashpot springAndDashpot(const component::Component& component, const WorkingPoint& at);

/// Returns YAML with both values in N, m, s and in N, mm, s, and notes as comments.
std::string toYaml(const std::string& name, const SpringAndDashpot& values, const WorkingPoint& at);

/// Returns the notes as lines that begin with `mark`.
std::string asComments(const std::vector<std::string>& notes, const std::string& mark);

}  // namespace rubber_suspension::command
