// A component as one stiffness and one constant of damping, to be pasted into a program that has nothing else.
#pragma once

#include <string>
#include <vector>

#include "rubber_suspension/component/component.h"

namespace rubber_suspension::command {

/// A sine, and what a component answers to it.
struct WorkingPoint {
  double frequency = 0.0;  ///< [Hz]
  double amplitude = 0.0;  ///< [m]
};

/// K and loss angle of the settled loop at a point, as "4.2 kN/mm and 5.7 degrees at 4 Hz and 1 mm".
std::string stiffnessText(const component::Component& component, const WorkingPoint& at);

struct SpringAndDashpot {
  double stiffness = 0.0;          ///< k = Re K* [N/m]
  double damping = 0.0;            ///< c = Im K*/(2 pi f) [N s/m]
  std::vector<std::string> notes;  ///< what the two cannot say of the component, in numbers
};

/// Spring and dashpot side by side that have the component's complex stiffness at the point. Throws
/// std::invalid_argument for a point that is no sine.
SpringAndDashpot springAndDashpot(const component::Component& component, const WorkingPoint& at);

/// YAML with both in N, m, s and in N, mm, s; notes as comments.
std::string toYaml(const std::string& name, const SpringAndDashpot& values, const WorkingPoint& at);

/// Notes as comments, a line each, behind this mark.
std::string asComments(const std::vector<std::string>& notes, const std::string& mark);

}  // namespace rubber_suspension::command
