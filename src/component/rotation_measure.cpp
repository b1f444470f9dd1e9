// Rotation vector and cardan angles.
#include "rubber_suspension/component/rotation_measure.h"

#include <cmath>

namespace rubber_suspension::component {
namespace {

// The inverse of the left Jacobian, 1 - [theta]/2 + c [theta]^2 with c = (1 - (a/2) cot(a/2))/a^2, a = |theta|.
Eigen::Matrix3d inverseLeftJacobian(const Eigen::Vector3d& theta, double half_angle_cotangent) {
  constexpr double kSeries = 0.01;  // of a^2; below, the first term left out is under 3e-16 of c
  const double square = theta.squaredNorm();
  const double c = square < kSeries ? 1.0 / 12 + square * (1.0 / 720 + square * (1.0 / 30240 + square / 1209600))
                                    : (1.0 - half_angle_cotangent) / square;
  Eigen::Matrix3d rates = c * theta * theta.transpose();
  const double diagonal = 1.0 - c * square;
  const Eigen::Vector3d half = 0.5 * theta;
  rates(0, 0) += diagonal;
  rates(1, 1) += diagonal;
  rates(2, 2) += diagonal;
  rates(0, 1) += half.z();
  rates(1, 0) -= half.z();
  rates(0, 2) -= half.y();
  rates(2, 0) += half.y();
  rates(1, 2) += half.x();
  rates(2, 1) -= half.x();
  return rates;
}

RotationCoordinates vectorOf(const Eigen::Quaterniond& rotation) {
  // Of q and -q, which are one rotation, that of the angle up to 180 deg.
  const double sign = rotation.w() < 0.0 ? -1.0 : 1.0;
  const double w = sign * rotation.w();
  const double square = rotation.vec().squaredNorm();
  constexpr double kSeries = 1e-8;  // below, the first term left out is under 1e-16 of the angle
  if (square < kSeries) {
    const Eigen::Vector3d theta = sign * 2.0 / w * (1.0 - square / (3.0 * w * w)) * rotation.vec();
    return {theta, inverseLeftJacobian(theta, 1.0)};
  }
  const double sine = std::sqrt(square);
  const double half_angle = std::atan2(sine, w);
  const Eigen::Vector3d theta = sign * 2.0 * half_angle / sine * rotation.vec();
  return {theta, inverseLeftJacobian(theta, half_angle * w / sine)};
}

// Rows by q' = N^-1 omega, N the columns e_x, R_x e_y and R_x R_y e_z.
Eigen::Matrix3d cardanRates(double sin1, double cos1, double sin2, double cos2) {
  Eigen::Matrix3d rates;
  rates << 1.0, sin1 * sin2 / cos2, -cos1 * sin2 / cos2,  //
      0.0, cos1, sin1,                                    //
      0.0, -sin1 / cos2, cos1 / cos2;
  return rates;
}

RotationCoordinates cardanOf(const Eigen::Quaterniond& rotation) {
  const Eigen::Matrix3d r = rotation.toRotationMatrix();
  const double cos2 = std::hypot(r(1, 2), r(2, 2));
  const Eigen::Vector3d value(std::atan2(-r(1, 2), r(2, 2)), std::atan2(r(0, 2), cos2), std::atan2(-r(0, 1), r(0, 0)));
  return {value, cardanRates(-r(1, 2) / cos2, r(2, 2) / cos2, r(0, 2), cos2)};
}

}  // namespace

RotationCoordinates coordinatesOf(RotationMeasure measure, const Eigen::Quaterniond& rotation) {
  return measure == RotationMeasure::vector ? vectorOf(rotation) : cardanOf(rotation);
}

Eigen::Matrix3d ratesAt(RotationMeasure measure, const Eigen::Vector3d& value) {
  if (measure == RotationMeasure::cardan) {
    return cardanRates(std::sin(value.x()), std::cos(value.x()), std::sin(value.y()), std::cos(value.y()));
  }
  const double half = 0.5 * value.norm();
  return inverseLeftJacobian(value, half > 0.0 ? half / std::tan(half) : 1.0);
}

Eigen::Quaterniond rotationOf(RotationMeasure measure, const Eigen::Vector3d& value) {
  if (measure == RotationMeasure::cardan) {
    return Eigen::AngleAxisd(value.x(), Eigen::Vector3d::UnitX()) *
           Eigen::AngleAxisd(value.y(), Eigen::Vector3d::UnitY()) *
           Eigen::AngleAxisd(value.z(), Eigen::Vector3d::UnitZ());
  }
  const double half = 0.5 * value.norm();
  const double share = half > 0.0 ? std::sin(half) / half : 1.0;
  const Eigen::Vector3d vector = 0.5 * share * value;
  return {std::cos(half), vector.x(), vector.y(), vector.z()};
}

bool measureHolds(RotationMeasure measure, const Eigen::Vector3d& value) {
  return measure == RotationMeasure::vector
             ? value.norm() < kVectorEnd
             : std::abs(value.y()) < kCardanEnd && std::abs(value.x()) < kVectorEnd && std::abs(value.z()) < kVectorEnd;
}

double sizeOf(RotationMeasure measure, const Eigen::Vector3d& value) {
  return measure == RotationMeasure::vector ? value.norm() : value.cwiseAbs().maxCoeff();
}

}  // namespace rubber_suspension::component
