// A rotation as three coordinates with conjugate moments: either the rotation vector, or body-fixed x-y-z angles. No
// function here throws.
#pragma once

#include <Eigen/Geometry>

#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::component {

/// The three coordinates q [rad] by which a component measures the rotation R of body B in body A. A moment M and the
/// generalised moments Q satisfy M . omega = Q . q', where omega is the angular velocity of B relative to A in A's
/// axes. So forces with a potential in q do no work over a closed path.
enum class RotationMeasure {
  vector,  ///< q = theta = log R; M = J(theta)^-T Q with the left Jacobian J; |theta| below kVectorEnd
  cardan,  ///< R = R_x(q_1) R_y(q_2) R_z(q_3); M = N^-T Q with omega = N q'; |q_2| below kCardanEnd
};

/// Limits of the coordinates [rad]. Beyond them coordinates jump between samples, or their rates grow without bound.
constexpr double kVectorEnd = 179.0 * element::kPi / 180.0;  // length of the vector; angles about x and z
constexpr double kCardanEnd = 85.0 * element::kPi / 180.0;   // cardan angle about y

/// Returns the matrix B at coordinates q [rad], which gives the rates q' = B omega and the moment M = B^T Q.
Eigen::Matrix3d ratesAt(RotationMeasure measure, const Eigen::Vector3d& value);

/// Coordinates of a rotation, with all data for the conversion of generalised moments to a moment.
struct RotationCoordinates {
  RotationMeasure measure;
  Eigen::Vector3d value;  ///< q [rad]
  double curvature;  ///< (1 - (a/2) cot(a/2))/a^2 of a rotation vector, a = |q|: J^-1 = 1 - [q]/2 + curvature [q]^2

  Eigen::Matrix3d rates() const { return ratesAt(measure, value); }

  /// Returns M = rates^T Q [N m].
  Eigen::Vector3d momentOf(const Eigen::Vector3d& moments) const {
    if (measure == RotationMeasure::cardan) {
      return rates().transpose() * moments;
    }
    const Eigen::Vector3d across = value.cross(moments);
    return moments + 0.5 * across + curvature * value.cross(across);
  }
};

/// Returns the coordinates of a rotation, whose quaternion has to have length 1.
RotationCoordinates coordinatesOf(RotationMeasure measure, const Eigen::Quaterniond& rotation);

/// Series of a/sin a and of the curvature above, in one vector, for angles a up to 20.7 deg, with t = sin^2 a <= kMost.
/// The polynomials interpolate at ten Chebyshev points; the error of either is below 1e-16.
struct RotationSeries {
  using Pair = double __attribute__((vector_size(2 * sizeof(double))));
  static constexpr double kMost = 0.125;

  static Pair at(double t) {
    const double t2 = t * t;
    const Pair low =
        Pair{0x1.0000000000000p+0, 0x1.5555555555555p-4} + t * Pair{0x1.5555555555b45p-3, 0x1.6c16c16c17012p-10} +
        t2 *
            (Pair{0x1.333333326fdf6p-4, 0x1.041041038d3c7p-11} + t * Pair{0x1.6db6dc0928801p-5, 0x1.1ae42bd2cde2ep-12});
    const Pair middle =
        Pair{0x1.f1c6ddd11a5bcp-6, 0x1.6f0589257e008p-13} + t * Pair{0x1.6e92da456e5bcp-6, 0x1.065e098106da8p-13} +
        t2 *
            (Pair{0x1.1bcdfdec88984p-6, 0x1.8e27b86a1e702p-14} + t * Pair{0x1.d49864b02bab1p-7, 0x1.43acc85b48c88p-14});
    const Pair high =
        Pair{0x1.3366a4ef8d5d1p-7, 0x1.a607515859a0bp-15} + t * Pair{0x1.18ce9eb9b9a92p-6, 0x1.7b1beb7363b2fp-14};
    const double t4 = t2 * t2;
    return low + t4 * (middle + t4 * high);
  }
};

/// Returns the coordinates of a rotation matrix. Code for rotation vectors up to 20 deg is inlined.
template <class Matrix>
__attribute__((always_inline)) inline RotationCoordinates coordinatesOf(RotationMeasure measure,
                                                                        const Eigen::MatrixBase<Matrix>& r) {
  const Eigen::Vector3d sine(0.5 * (r(2, 1) - r(1, 2)), 0.5 * (r(0, 2) - r(2, 0)), 0.5 * (r(1, 0) - r(0, 1)));
  const double square = sine.x() * sine.x() + sine.y() * sine.y() + sine.z() * sine.z();
  const bool acute = r(0, 0) + r(1, 1) + r(2, 2) > 1.0;  // the trace is 1 + 2 cos a
  if (!(square <= RotationSeries::kMost && acute && measure == RotationMeasure::vector)) {
    return coordinatesOf(measure, Eigen::Quaterniond(Eigen::Matrix3d(r)));
  }
  const RotationSeries::Pair series = RotationSeries::at(square);
  return {measure, series[0] * sine, series[1]};
}

/// Returns the rotation with these coordinates [rad].
Eigen::Quaterniond rotationOf(RotationMeasure measure, const Eigen::Vector3d& value);

/// Returns true if the coordinates [rad] are within the limits of the measure.
bool measureHolds(RotationMeasure measure, const Eigen::Vector3d& value);

/// Returns the size of a rotation in its measure [rad]: the length of the vector, or the largest angle.
double sizeOf(RotationMeasure measure, const Eigen::Vector3d& value);

}  // namespace rubber_suspension::component
