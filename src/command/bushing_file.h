// A component as a bushing property file of Adams: a text of blocks, with curves of force and constants of damping.
#pragma once

#include <string>
#include <vector>

#include "rubber_suspension/component/component.h"

namespace rubber_suspension::command {

/// What the file is to have.
struct BushingFileOptions {
  char axis = 'z';                    ///< of the bushing that the component is along: x, y or z
  double largest_displacement = 0.0;  ///< the curve goes as far to both sides [m]
  int points = 41;                    ///< of the curve, odd, so that 0 is one of them
  double frequency = 0.0;             ///< of the sine whose loss the damping has [Hz]
  double amplitude = 0.0;             ///< of it [m]
};

struct BushingFile {
  std::string text;
  std::vector<std::string> notes;  ///< what the format cannot say of this component
};

/// Static curve and one constant of damping, c = Im K*/(2 pi f) of the settled loop under the sine given, in mm, N and
/// s. The other five directions have a curve of no force. A positive displacement has a positive force, as everywhere
/// in this package. Throws std::invalid_argument for options that make no curve or no sine.
BushingFile makeBushingFile(const std::string& name, const component::Component& component,
                            const BushingFileOptions& options);

}  // namespace rubber_suspension::command
