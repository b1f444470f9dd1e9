// Converts the pose of two bodies to coordinates of a bush, computes its directions, and converts forces to a wrench.
#include "rubber_suspension/component/six_directions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <utility>

#include "component/radial_coupling.h"
#include "rubber_suspension/element/radial_stiffness.h"
#include "rubber_suspension/element/temperature_shift.h"

namespace rubber_suspension::component {
namespace {

constexpr std::array<const char*, kDirections> kDirectionNames = {"x", "y", "z", "rx", "ry", "rz"};

using Matrix6 = Eigen::Matrix<double, 6, 6>;

// Returns the damping [N s/m] of the dashpots that act directly on the coordinate, in real time.
double directDamping(const std::vector<element::ElementDescription>& elements) {
  element::BasicLaws sum;
  for (const element::ElementDescription& description : elements) {
    const element::ElementPointer element = element::makeElement(description);
    const element::ParallelElement* law = element::parallelLaw(element);
    if (law == nullptr) {
      return 0.0;
    }
    if (description.type == "dashpot") {
      law->addTo(sum);
    }
  }
  return sum.damping;
}

Eigen::Matrix3d crossing(const Eigen::Vector3d& v) {
  Eigen::Matrix3d matrix;
  matrix << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return matrix;
}

// Returns the directions of a triple (translations or rotations) on which a coupling acts.
std::vector<Direction> coupledDirections(Direction first, Coupling coupling, std::size_t axis) {
  std::vector<Direction> directions;
  for (std::size_t i = 0; i < 3; ++i) {
    if (coupling == Coupling::spherical || (coupling == Coupling::cylindrical && i != axis)) {
      directions.push_back(static_cast<Direction>(first + i));
    }
  }
  return directions;
}

SixNumbers totals(const BushForce& force) {
  SixNumbers numbers;
  for (std::size_t i = 0; i < kDirections; ++i) {
    numbers[static_cast<Eigen::Index>(i)] = force.direction[i].total;
  }
  return numbers;
}

SixNumbers viscousParts(const BushForce& force) {
  SixNumbers numbers;
  for (std::size_t i = 0; i < kDirections; ++i) {
    numbers[static_cast<Eigen::Index>(i)] = force.direction[i].viscous;
  }
  return numbers;
}

}  // namespace

const char* toString(Direction direction) { return kDirectionNames[direction]; }

std::optional<Direction> directionFromString(const std::string& name) {
  const auto* const found = std::find(kDirectionNames.begin(), kDirectionNames.end(), name);
  return found == kDirectionNames.end() ? std::nullopt
                                        : std::optional(static_cast<Direction>(found - kDirectionNames.begin()));
}

void SixDirectionsState::copyFrom(const SixDirectionsState& other) {
  for (std::size_t i = 0; i < kDirections; ++i) {
    directions_[i].copyFrom(other.directions_[i]);
  }
  std::copy(other.coupled_.begin(), other.coupled_.end(), coupled_.begin());
  coordinates_ = other.coordinates_;
}

std::vector<double> SixDirectionsState::numbers() const {
  std::vector<double> numbers(coordinates_.begin(), coordinates_.end());
  numbers.insert(numbers.end(), coupled_.begin(), coupled_.end());
  for (const ComponentState& direction : directions_) {
    const std::vector<double> memory = direction.memory();
    numbers.insert(numbers.end(), memory.begin(), memory.end());
  }
  return numbers;
}

SixDirections::SixDirections(SixDirectionsLaws laws)
    : laws_(std::move(laws)),
      framed_(!laws_.on_a.isApprox(Eigen::Isometry3d::Identity(), 0.0) ||
              !laws_.on_b.isApprox(Eigen::Isometry3d::Identity(), 0.0)) {
  auto elements = laws_.elements;
  for (const auto& [first, coupling] : {std::pair(kX, laws_.translation), std::pair(kRx, laws_.rotation)}) {
    if (coupling == Coupling::rectangular) {
      coupleRadial(first, elements);
    } else {
      couple(coupledDirections(first, coupling, laws_.axis), elements);
    }
  }
  for (std::size_t i = 0; i < kDirections; ++i) {
    const auto direction = static_cast<Direction>(i);
    try {
      damping_[i] = directDamping(elements[i]);
      if (!elements[i].empty()) {
        directions_[i].emplace(elements[i]);
      }
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(fmt::format("{}: {}", toString(direction), error.what()));
    }
  }
}

// Moves elements that depend on the radius into a coupling. The other elements remain in the directions.
void SixDirections::couple(std::vector<Direction> directions, SixElements& elements) {
  const auto given = std::count_if(directions.begin(), directions.end(),
                                   [&](Direction direction) { return !elements[direction].empty(); });
  if (given == 0) {
    return;
  }
  const Direction first = *std::find_if(directions.begin(), directions.end(),
                                        [&](Direction direction) { return !elements[direction].empty(); });
  for (const Direction direction : directions) {
    if (elements[direction].empty() && given > 1) {
      throw std::invalid_argument(
          fmt::format("{}: is missing, but several directions coupled with it are given; accepted: all coupled "
                      "directions, or one direction for all of them",
                      toString(direction)));
    }
    if (elements[direction].empty()) {
      elements[direction] = elements[first];
    }
  }
  addCoupling(std::move(directions), elements);
}

void SixDirections::addCoupling(std::vector<Direction> directions, SixElements& elements) {
  couplings_.push_back(std::make_shared<const RadialCoupling>(std::move(directions), elements));
  coupled_size_ += couplings_.back()->memorySize();
}

// Couples elements by the radius in the two directions perpendicular to the axis, which have no other coupling.
void SixDirections::coupleRadial(Direction first, SixElements& elements) {
  const std::vector<Direction> across = coupledDirections(first, Coupling::cylindrical, laws_.axis);
  SixElements radial;
  for (std::size_t direction = first; direction < first + 3U; ++direction) {
    auto& own = elements[direction];
    const auto by_radius = std::stable_partition(own.begin(), own.end(), std::not_fn(element::isRadial));
    radial[direction].assign(by_radius, own.end());
    own.erase(by_radius, own.end());
  }
  const bool any = !radial[across[0]].empty() || !radial[across[1]].empty();
  for (std::size_t direction = first; direction < first + 3U; ++direction) {
    const bool shares = any && direction != first + laws_.axis;
    if (radial[direction].empty() == shares) {
      throw std::invalid_argument(
          fmt::format("{}: radial_stiffness acts in the two directions across coupling.axis; accepted: the element in "
                      "both {} and {}, or in neither",
                      kDirectionNames[direction], toString(across[0]), toString(across[1])));
    }
  }
  if (any) {
    addCoupling(across, radial);
  }
}

SixDirectionsState SixDirections::makeState() const {
  SixDirectionsState state;
  state.coupled_.resize(coupled_size_);
  for (std::size_t i = 0; i < kDirections; ++i) {
    if (directions_[i]) {
      state.directions_[i] = directions_[i]->makeState();
    }
  }
  initialise(state, pose(SixNumbers::Zero()));
  return state;
}

__attribute__((always_inline)) inline SixDirections::Place SixDirections::placeAt(const Eigen::Isometry3d& pose) const {
  if (framed_) {
    return framedPlaceAt(pose);
  }
  return {pose.translation(), coordinatesOf(laws_.measure, pose.linear()), Eigen::Vector3d::Zero()};
}

SixDirections::Place SixDirections::framedPlaceAt(const Eigen::Isometry3d& pose) const {
  const Eigen::Vector3d arm = pose.linear() * laws_.on_b.translation();
  const Eigen::Matrix3d rotation = laws_.on_a.linear().transpose() * pose.linear() * laws_.on_b.linear();
  return {laws_.on_a.linear().transpose() * (pose.translation() + arm - laws_.on_a.translation()),
          coordinatesOf(laws_.measure, rotation), arm};
}

SixNumbers SixDirections::coordinates(const Eigen::Isometry3d& pose) const {
  return SixNumbers(placeAt(pose).coordinates().data());
}

Eigen::Isometry3d SixDirections::pose(const SixNumbers& coordinates) const {
  Eigen::Isometry3d bush = Eigen::Isometry3d::Identity();
  bush.translation() = coordinates.head<3>();
  bush.linear() = rotationOf(laws_.measure, coordinates.tail<3>()).toRotationMatrix();
  return framed_ ? laws_.on_a * bush * laws_.on_b.inverse() : bush;
}

// With the rates q' = B (v, omega) of the coordinates, the wrench is B^T Q.
__attribute__((always_inline)) inline void SixDirections::complete(const Place& place, BushForce& force) const {
  const auto& q = force.direction;
  force.wrench.force = {q[kX].total, q[kY].total, q[kZ].total};
  force.wrench.moment = place.rotation.momentOf({q[kRx].total, q[kRy].total, q[kRz].total});
  if (framed_) {
    force.wrench = carriedToB(force.wrench, place.arm);
  }
}

Wrench SixDirections::carriedToB(const Wrench& wrench, const Eigen::Vector3d& arm) const {
  const Eigen::Vector3d force = laws_.on_a.linear() * wrench.force;
  return {force, laws_.on_a.linear() * wrench.moment + arm.cross(force)};
}

SixNumbers SixDirections::ratesOf(const Place& place, const Twist& twist) const {
  const Eigen::Matrix3d to_bush = laws_.on_a.linear().transpose();
  SixNumbers rates;
  rates << to_bush * (twist.linear + twist.angular.cross(place.arm)),
      place.rotation.rates() * (to_bush * twist.angular);
  return rates;
}

// Adds the forces of dashpots at the given rates, which their step did not include.
void SixDirections::addDamping(const SixNumbers& rates, BushForce& force) const {
  for (std::size_t i = 0; i < kDirections; ++i) {
    const double added = damping_[i] * rates[static_cast<Eigen::Index>(i)];
    force.direction[i].viscous += added;
    force.direction[i].total += added;
  }
}

BushForce SixDirections::start(SixDirectionsState& state, const Place& place, bool as_new) const {
  state.coordinates_ = place.coordinates();
  BushForce force;
  for (std::size_t i = 0; i < kDirections; ++i) {
    if (directions_[i]) {
      force.direction[i] = as_new ? directions_[i]->initialise(state.directions_[i], state.coordinates_[i])
                                  : directions_[i]->relax(state.directions_[i], state.coordinates_[i]);
    }
  }
  double* memory = state.coupled_.data();
  for (const auto& coupling : couplings_) {
    coupling->initialise(state.coordinates_, memory, force);
    memory += coupling->memorySize();
  }
  return force;
}

BushForce SixDirections::initialise(SixDirectionsState& state, const Eigen::Isometry3d& pose,
                                    const Twist& twist) const {
  const Place place = placeAt(pose);
  BushForce force = start(state, place, true);
  addDamping(ratesOf(place, twist), force);
  complete(place, force);
  return force;
}

BushForce SixDirections::relax(SixDirectionsState& state, const Eigen::Isometry3d& pose) const {
  const Place place = placeAt(pose);
  BushForce force = start(state, place, false);
  complete(place, force);
  return force;
}

// Coordinates are passed by value, because they could not stay in registers if their address was taken.
void SixDirections::stepCoupled(SixDirectionsState& state, double dt, Coordinates at, BushForce& force) const {
  double* memory = state.coupled_.data();
  for (const auto& coupling : couplings_) {
    coupling->step(dt, state.coordinates_, at, memory, force);
    memory += coupling->memorySize();
  }
}

// Each direction is written out, so that coordinates and forces stay in registers.
__attribute__((always_inline)) inline BushForce SixDirections::stepInline(SixDirectionsState& state, double dt,
                                                                          const Coordinates& at) const {
  const auto step = [&](std::size_t i) __attribute__((always_inline)) {
    return directions_[i] ? directions_[i]->step(state.directions_[i], dt, at[i]) : element::ComponentForce();
  };
  BushForce force{{}, {step(kX), step(kY), step(kZ), step(kRx), step(kRy), step(kRz)}};
  if (!couplings_.empty()) {
    stepCoupled(state, dt, at, force);
  }
  state.coordinates_ = at;
  return force;
}

BushForce SixDirections::stepDirections(SixDirectionsState& state, double dt, const Coordinates& at) const {
  return stepInline(state, dt, at);
}

BushForce SixDirections::step(SixDirectionsState& state, double dt, const Eigen::Isometry3d& pose) const {
  const Place place = placeAt(pose);
  BushForce force = stepInline(state, dt, place.coordinates());
  complete(place, force);
  return force;
}

BushForce SixDirections::step(SixDirectionsState& state, double dt, const Eigen::Isometry3d& pose,
                              const Twist& twist) const {
  const Place place = placeAt(pose);
  const Coordinates at = place.coordinates();
  const SixNumbers mean_rates = (SixNumbers(at.data()) - state.coordinates()) / dt;
  BushForce force = stepDirections(state, dt, at);
  addDamping(ratesOf(place, twist) - mean_rates, force);
  complete(place, force);
  return force;
}

// Returns the matrix B that maps the motion of body B to the rates of the coordinates.
Eigen::Matrix<double, 6, 6> SixDirections::coordinateJacobian(const Place& place) const {
  const Eigen::Matrix3d to_bush = laws_.on_a.linear().transpose();
  Matrix6 jacobian;
  jacobian << to_bush, -to_bush * crossing(place.arm), Eigen::Matrix3d::Zero(), place.rotation.rates() * to_bush;
  return jacobian;
}

// Returns the derivative of the moment rates^T Q with respect to the coordinates, for constant `moments` Q [N m].
Eigen::Matrix3d SixDirections::turningMoment(const Place& place, const Eigen::Vector3d& moments) const {
  constexpr double kDistance = 1e-5;  // [rad]; error 1e-10 of the moment
  Eigen::Matrix3d derivative;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const Eigen::Vector3d step = kDistance * Eigen::Vector3d::Unit(i);
    derivative.col(i) =
        (ratesAt(laws_.measure, place.rotation.value + step) - ratesAt(laws_.measure, place.rotation.value - step))
            .transpose() *
        moments / (2.0 * kDistance);
  }
  return derivative;
}

SixTangent SixDirections::tangent(const SixDirectionsState& state, double dt, const Eigen::Isometry3d& pose,
                                  SixDirectionsState& trial) const {
  constexpr double kDistance = 1e-8;  // [m, rad], as in Component::tangent()
  const Place place = placeAt(pose);
  const Coordinates coordinates = place.coordinates();
  const auto forces = [&](const Coordinates& at) {
    trial.copyFrom(state);
    return stepDirections(trial, dt, at);
  };
  Matrix6 retained;
  Matrix6 viscous;
  for (std::size_t i = 0; i < kDirections; ++i) {
    Coordinates above = coordinates;
    Coordinates below = coordinates;
    above[i] += kDistance;
    below[i] -= kDistance;
    const BushForce upper = forces(above);
    const BushForce lower = forces(below);
    const double distance = above[i] - below[i];
    const auto column = static_cast<Eigen::Index>(i);
    viscous.col(column) = (viscousParts(upper) - viscousParts(lower)) / distance;
    retained.col(column) = (totals(upper) - totals(lower)) / distance - viscous.col(column);
  }
  const SixNumbers held = totals(forces(coordinates));
  const Matrix6 jacobian = coordinateJacobian(place);
  SixTangent tangent{jacobian.transpose() * retained * jacobian, dt * jacobian.transpose() * viscous * jacobian};
  const Eigen::Matrix3d& axes = laws_.on_a.linear();
  tangent.stiffness.bottomRightCorner<3, 3>() +=
      crossing(axes * held.head<3>()) * crossing(place.arm) +
      axes * turningMoment(place, held.tail<3>()) * place.rotation.rates() * axes.transpose();
  return tangent;
}

SixNumbers SixDirections::directionForces(const Eigen::Isometry3d& pose, const Wrench& wrench) const {
  const Place place = placeAt(pose);
  const Eigen::Matrix3d to_bush = laws_.on_a.linear().transpose();
  const Eigen::Matrix3d rates = place.rotation.rates();
  // Solves rates^T Q = M for Q by Cramer's rule.
  const Eigen::Vector3d moment = to_bush * (wrench.moment - place.arm.cross(wrench.force));
  const Eigen::Vector3d first = rates.row(0);
  const Eigen::Vector3d second = rates.row(1);
  const Eigen::Vector3d third = rates.row(2);
  const double determinant = first.dot(second.cross(third));
  SixNumbers forces;
  forces << to_bush * wrench.force, moment.dot(second.cross(third)) / determinant,
      moment.dot(third.cross(first)) / determinant, moment.dot(first.cross(second)) / determinant;
  return forces;
}

Reactions SixDirections::reactions(const Eigen::Isometry3d& pose, const Wrench& wrench) {
  return {{wrench.force, wrench.moment + pose.translation().cross(wrench.force)}, {-wrench.force, -wrench.moment}};
}

bool SixDirections::shiftsWithTemperature() const {
  return std::any_of(directions_.begin(), directions_.end(),
                     [](const auto& component) { return component && component->shiftsWithTemperature(); });
}

element::Range SixDirections::temperatures() const {
  element::Range range;
  for (const auto& component : directions_) {
    range = component ? element::intersection(range, component->temperatures()) : range;
  }
  return range;
}

void SixDirections::setTemperature(SixDirectionsState& state, double temperature) const {
  for (std::size_t i = 0; i < kDirections; ++i) {
    if (directions_[i]) {
      directions_[i]->setTemperature(state.directions_[i], temperature);
    }
  }
}

void SixDirections::restore(SixDirectionsState& state, const std::vector<double>& numbers) const {
  SixDirectionsState restored = makeState();
  const std::size_t size = restored.numbers().size();
  if (numbers.size() != size) {
    throw std::invalid_argument(
        fmt::format("the state has {} numbers, but this component needs {}", numbers.size(), size));
  }
  if (!std::all_of(numbers.begin(), numbers.end(), [](double number) { return std::isfinite(number); })) {
    throw std::invalid_argument("the state contains numbers that are not finite");
  }
  const double* next = numbers.data();
  std::copy_n(next, kDirections, restored.coordinates_.begin());
  next += kDirections;
  std::copy_n(next, restored.coupled_.size(), restored.coupled_.begin());
  next += restored.coupled_.size();
  for (std::size_t i = 0; i < kDirections; ++i) {
    if (directions_[i]) {
      const std::size_t count = restored.directions_[i].memory().size();
      directions_[i]->restore(restored.directions_[i], restored.coordinates_[i], {next, next + count});
      next += count;
    }
  }
  state = std::move(restored);
}

}  // namespace rubber_suspension::component
