// Rotation vector and cardan angles.
#include "rubber_suspension/component/rotation_measure.h"

#include <algorithm>
#include <cmath>

namespace rubber_suspension::component {
namespace {

// Returns (1 - (a/2) cot(a/2))/a^2 as a function of a^2. Below kSeries it uses the series, whose first omitted term is
// below a relative 1e-17.
double curvatureOf(double square, double half_angle_times_cotangent) {
  constexpr double kSeries = 0.01;
  return square < kSeries ? 1.0 / 12 + square * (1.0 / 720 + square * (1.0 / 30240 + square * (1.0 / 1209600)))
                          : (1.0 - half_angle_times_cotangent) / square;
}

RotationCoordinates vectorOf(const Eigen::Quaterniond& rotation) {
  // The quaternions q and -q are the same rotation. This sign gives an angle of at most 180 deg.
  const double sign = rotation.w() < 0.0 ? -1.0 : 1.0;
  const double w = sign * rotation.w();
  const double sine = rotation.vec().norm();
  const double half_angle = std::atan2(sine, w);
  constexpr double kSmall = 1e-8;  // sine and half angle are equal below this value
  const Eigen::Vector3d theta = sign * 2.0 * (sine < kSmall ? 1.0 / w : half_angle / sine) * rotation.vec();
  return {RotationMeasure::vector, theta, curvatureOf(theta.squaredNorm(), half_angle * w / std::max(sine, kSmall))};
}

RotationCoordinates cardanOf(const Eigen::Matrix3d& r) {
  return {
      RotationMeasure::cardan,
      {std::atan2(-r(1, 2), r(2, 2)), std::atan2(r(0, 2), std::hypot(r(1, 2), r(2, 2))), std::atan2(-r(0, 1), r(0, 0))},
      0.0};
}

// Returns N^-1, for q' = N^-1 omega. The columns of N are e_x, R_x e_y and R_x R_y e_z.
Eigen::Matrix3d cardanRates(const Eigen::Vector3d& angles) {
  const double sin1 = std::sin(angles.x());
  const double cos1 = std::cos(angles.x());
  const double cos2 = std::cos(angles.y());
  const double tan2 = std::sin(angles.y()) / cos2;
  Eigen::Matrix3d rates;
  rates << 1.0, sin1 * tan2, -cos1 * tan2,  //
      0.0, cos1, sin1,                      //
      0.0, -sin1 / cos2, cos1 / cos2;
  return rates;
}

}  // namespace

RotationCoordinates coordinatesOf(RotationMeasure measure, const Eigen::Quaterniond& rotation) {
  return measure == RotationMeasure::vector ? vectorOf(rotation) : cardanOf(rotation.toRotationMatrix());
}

Eigen::Matrix3d ratesAt(RotationMeasure measure, const Eigen::Vector3d& value) {
  if (measure == RotationMeasure::cardan) {
    return cardanRates(value);
  }
  const double half = 0.5 * value.norm();
  const double curvature = curvatureOf(value.squaredNorm(), half / std::tan(half));
  Eigen::Matrix3d cross;
  cross << 0.0, -value.z(), value.y(), value.z(), 0.0, -value.x(), -value.y(), value.x(), 0.0;
  return Eigen::Matrix3d::Identity() - 0.5 * cross + curvature * cross * cross;
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
