// A rotation by three coordinates, and what is conjugate to them: the rotation vector, or body-fixed x-y-z angles.
// Throws nothing.
#pragma once

#include <Eigen/Geometry>

#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::component {

/// The three coordinates q [rad] by which a component measures the rotation R of B in A. Generalised moments Q belong
/// to a moment M by M . omega = Q . q', omega being that of B against A in A's axes, so that what has a potential in q
/// does no work over a closed path.
enum class RotationMeasure {
  vector,  ///< theta = log R; M = J(theta)^-T Q, J the left Jacobian; below kVectorEnd
  cardan,  ///< R = R_x(q_1) R_y(q_2) R_z(q_3); M = N^-T Q with omega = N q'; |q_2| below kCardanEnd
};

/// Where the measures end [rad]: beyond, coordinates jump from one sample to the next, or their rates grow without
/// limit.
constexpr double kVectorEnd = 179.0 * element::kPi / 180.0;  // of the angle, and of the cardan angles about x and z
constexpr double kCardanEnd = 85.0 * element::kPi / 180.0;   // of the cardan angle about y

struct RotationCoordinates {
  Eigen::Vector3d value;  ///< q [rad]
  Eigen::Matrix3d rates;  ///< q' = rates omega, and M = rates^T Q
};

/// The coordinates of a rotation; the quaternion is of length 1.
RotationCoordinates coordinatesOf(RotationMeasure measure, const Eigen::Quaterniond& rotation);

/// The rates at coordinates [rad].
Eigen::Matrix3d ratesAt(RotationMeasure measure, const Eigen::Vector3d& value);

/// The rotation that has these coordinates [rad].
Eigen::Quaterniond rotationOf(RotationMeasure measure, const Eigen::Vector3d& value);

/// True for coordinates [rad] before the end of the measure.
bool measureHolds(RotationMeasure measure, const Eigen::Vector3d& value);

/// How large a rotation is in its measure [rad]: the length of the vector, or the largest of the angles.
double sizeOf(RotationMeasure measure, const Eigen::Vector3d& value);

}  // namespace rubber_suspension::component
