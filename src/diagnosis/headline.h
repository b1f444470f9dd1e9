// Effects in few numbers, as engineers say them.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "rubber_suspension/element/parameter.h"

namespace rubber_suspension::diagnosis {

/// One headline number of an effect.
struct HeadlineValue {
  std::string name;
  std::string unit;  ///< SI; "1" for none
  double value = 0.0;
  bool is_scale = false;  ///< the effect is gone at 0
};

/// Headline numbers of an effect, as an engineer says them: what a fit moved, without choices and references. Of all
/// that yields in a friction together the maximum force and the displacement at which half of it is reached from rest,
/// as of the element `friction`; of stops the gap and the stiffness of each side; of a contact that opens what holds it
/// then; of dead zones the motion that they lose together; of what follows the temperature the change of stiffness and
/// of rates per kelvin at the reference; of other entries of one type the sum of the first parameter of their law, as
/// total_NAME.
std::vector<HeadlineValue> headlineValuesOf(const std::vector<element::ElementDescription>& entries);

/// The same by name, as report.json has them.
std::map<std::string, double> headlineOf(const std::vector<element::ElementDescription>& entries);

}  // namespace rubber_suspension::diagnosis
