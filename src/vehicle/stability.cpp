// Up to which step a loop with delayed forces stays stable.
#include "vehicle/stability.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <stdexcept>

#include "element/refuse.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::vehicle {
namespace {

using Complex = std::complex<double>;
using ComplexMatrix = Eigen::Matrix3cd;
using Roots = Eigen::Vector3cd;

// The vehicle for small motion, in the coordinates of HalfBogie.
struct LinearVehicle {
  LinearVehicle(const VehicleParameters& parameters, const std::vector<component::Component>& all) : components(all) {
    const double a = parameters.semi_wheelbase;
    mass = Eigen::Vector3d(parameters.frame_mass, parameters.frame_inertia, parameters.body_mass).asDiagonal();
    direction.col(0) << 1.0, a, 0.0;
    direction.col(1) << 1.0, -a, 0.0;
    direction.col(2) << -1.0, 0.0, 1.0;
    damping = parameters.secondary_damping * direction.col(2) * direction.col(2).transpose();
  }

  // The value of exp(-i w T) for which the vehicle oscillates on at w.
  Roots factors(double omega) const {
    ComplexMatrix stiffness = ComplexMatrix::Zero();
    for (std::size_t i = 0; i < kStruts; ++i) {
      const auto dynamic = components[i].complexStiffness(omega / (2.0 * element::kPi));
      if (!dynamic) {
        throw std::invalid_argument(
            fmt::format("component {} is not linear; a delay margin is that of linear components", strutNames()[i]));
      }
      const auto column = direction.col(static_cast<int>(i));
      stiffness += *dynamic * (column * column.transpose()).cast<Complex>();
    }
    const ComplexMatrix rest = (omega * omega * mass).cast<Complex>() - Complex(0.0, omega) * damping.cast<Complex>();
    const ComplexMatrix quotient = stiffness.inverse() * rest;
    return quotient.eigenvalues();
  }

  const std::vector<component::Component>& components;
  Eigen::Matrix3d mass;
  Eigen::Matrix3d damping;
  Eigen::Matrix3d direction;
};

Complex nearest(const Roots& roots, Complex to) {
  return *std::min_element(roots.data(), roots.data() + roots.size(),
                           [to](Complex a, Complex b) { return std::abs(a - to) < std::abs(b - to); });
}

// The delay that belongs to a factor of magnitude 1.
double delayOf(Complex factor, double omega) {
  const double phase = -std::arg(factor);
  return (phase > 0.0 ? phase : phase + 2.0 * element::kPi) / omega;
}

// Follow a branch of factors from one frequency to the next; where it crosses magnitude 1, bisect.
void takeCrossing(const LinearVehicle& vehicle, double low, double high, Complex at_low, DelayMargin& margin) {
  const Complex at_high = nearest(vehicle.factors(high), at_low);
  if ((std::abs(at_low) - 1.0) * (std::abs(at_high) - 1.0) > 0.0) {
    return;
  }
  constexpr int kBisections = 60;
  for (int i = 0; i < kBisections; ++i) {
    const double middle = 0.5 * (low + high);
    const Complex value = nearest(vehicle.factors(middle), at_low);
    const bool same_side = (std::abs(value) - 1.0) * (std::abs(at_low) - 1.0) > 0.0;
    (same_side ? low : high) = middle;
    at_low = same_side ? value : at_low;
  }
  const double delay = delayOf(at_low, low);
  if (delay < margin.delay) {
    margin = {delay, low / (2.0 * element::kPi)};
  }
}

double energy(const VehicleParameters& parameters, const Coordinates& speed) {
  return 0.5 * (parameters.frame_mass * speed[0] * speed[0] + parameters.frame_inertia * speed[1] * speed[1] +
                parameters.body_mass * speed[2] * speed[2]);
}

// Mean kinetic energy between two records, from differences of positions.
double meanEnergy(const VehicleParameters& parameters, const History& history, std::size_t from, std::size_t to) {
  double sum = 0.0;
  for (std::size_t n = from + 1; n < to; ++n) {
    const double dt = history.time[n] - history.time[n - 1];
    Coordinates speed{};
    for (std::size_t i = 0; i < speed.size(); ++i) {
      speed[i] = (history.position[n][i] - history.position[n - 1][i]) / dt;
    }
    sum += energy(parameters, speed);
  }
  return sum / static_cast<double>(to - from - 1);
}

}  // namespace

DelayMargin delayMargin(const VehicleParameters& parameters, const std::vector<component::Component>& components) {
  constexpr double kLowest = 2.0 * element::kPi * 0.05;
  constexpr double kHighest = 2.0 * element::kPi * 500.0;
  constexpr int kPoints = 4000;
  const LinearVehicle vehicle(parameters, components);
  DelayMargin margin{std::numeric_limits<double>::infinity(), 0.0};
  const double ratio = std::pow(kHighest / kLowest, 1.0 / kPoints);
  for (int i = 0; i < kPoints; ++i) {
    const double low = kLowest * std::pow(ratio, i);
    const Roots roots = vehicle.factors(low);
    for (int j = 0; j < roots.size(); ++j) {
      takeCrossing(vehicle, low, low * ratio, roots[j], margin);
    }
  }
  element::refuseIf(!std::isfinite(margin.delay), "no delay makes this vehicle oscillate between 0.05 and 500 Hz");
  return margin;
}

double growthRate(const VehicleParameters& parameters, const std::vector<component::Component>& components,
                  std::int64_t step, int delay, double duration) {
  constexpr double kTooFast = 1e6;  // [m/s]; a run that gets there is unstable, whatever it would do then
  Scene scene;
  scene.parameters = parameters;
  scene.duration = duration;
  scene.step = step;
  scene.kick = {1e-4, 1e-4, 0.0};  // so little that the pitch stays small while it grows
  LibraryExchange exchange(components);
  const History history = runExchange(scene, exchange, delay, kTooFast);
  const std::size_t count = history.size();
  if (count < 16) {
    return std::numeric_limits<double>::infinity();
  }
  const double before = meanEnergy(parameters, history, count / 2, 3 * count / 4);
  const double after = meanEnergy(parameters, history, 3 * count / 4, count);
  return 0.5 * std::log(after / before) / (0.25 * (history.time.back() - history.time.front()));
}

double largestStableStep(const VehicleParameters& parameters, const std::vector<component::Component>& components,
                         int delay, double guess) {
  constexpr double kAccuracy = 1.01;
  constexpr double kShortest = 1e-6;  // [s]; not searched further down
  const auto stable = [&](double step) {
    return growthRate(parameters, components, std::llround(step * 1e9), delay) < 0.0;
  };
  double low = 0.95 * guess;
  double high = 1.05 * guess;
  while (!stable(low)) {
    high = low;
    low *= 0.7;
    if (low < kShortest) {
      return 0.0;
    }
  }
  while (stable(high)) {
    low = high;
    high *= 1.4;
  }
  while (high > kAccuracy * low) {
    const double middle = std::sqrt(low * high);
    (stable(middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace rubber_suspension::vehicle
