// The linear part of a component as a state-space model, for linearised calculations of a vehicle.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "rubber_suspension/io/component_file.h"

namespace rubber_suspension::command {

/// dx/dt = A x + B u, F = C x + D u with u = (z, dz/dt), z from the nominal displacement and F from the force there.
struct LinearPart {
  std::string component;
  Eigen::MatrixXd a;
  Eigen::MatrixXd b;  ///< two columns: [1/m], [s/m] of the states' units
  Eigen::RowVectorXd c;
  Eigen::RowVector2d d;               ///< [N/m], [N s/m]
  std::vector<std::string> tangents;  ///< nonlinear springs, taken by their slope at the nominal displacement
  std::vector<std::string> left_out;  ///< what has no linear form in these terms: friction, effects, the rig
};

LinearPart linearPartOf(const io::ComponentDescription& description);

/// Write the parts: FILE.json, or FILE.mat of a single component. Throws std::runtime_error with the path that cannot
/// be written, std::invalid_argument for another name.
void writeLinearParts(const std::vector<LinearPart>& parts, const std::string& path);

}  // namespace rubber_suspension::command
