// Computes the linear part of a component as a state-space model, for linearised calculations of a vehicle.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "rubber_suspension/io/component_file.h"

namespace rubber_suspension::command {

/// State-space model dx/dt = A x + B u, F = C x + D u, u = (z, dz/dt), with z and F relative to the nominal position.
struct LinearPart {
  std::string component;
  Eigen::MatrixXd a;
  Eigen::MatrixXd b;  ///< two columns, in the units of the states times 1/(m s) and 1/m
  Eigen::RowVectorXd c;
  Eigen::RowVector2d d;               ///< [N/m], [N s/m]
  std::vector<std::string> tangents;  ///< types of nonlinear springs that are linearised at the nominal displacement
  std::vector<std::string> left_out;  ///< types of elements that are omitted: friction, effects, elements of the rig
};

LinearPart linearPartOf(const io::ComponentDescription& description);

/// Writes the parts as FILE.json, or a single component as FILE.mat. Throws std::runtime_error if the file cannot be
/// written, and std::invalid_argument for another extension or several parts in a .mat file.
void writeLinearParts(const std::vector<LinearPart>& parts, const std::string& path);

}  // namespace rubber_suspension::command
