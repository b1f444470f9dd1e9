// A component of six directions, such as a bush: the wrench between two bodies as a function of their relative pose.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "rubber_suspension/component/component.h"
#include "rubber_suspension/component/rotation_measure.h"

namespace rubber_suspension::component {

/// Directions, in the order of wrenches and coordinates.
enum Direction : std::size_t { kX, kY, kZ, kRx, kRy, kRz, kDirections };

/// Returns the key in a component file: "x" to "rz".
const char* toString(Direction direction);

/// Returns the direction with this name, or nullopt.
std::optional<Direction> directionFromString(const std::string& name);

inline bool isRotation(Direction direction) { return direction >= kRx; }

/// Coupling of the three translations, or of the three rotations.
enum class Coupling {
  rectangular,  ///< the directions are independent
  cylindrical,  ///< the two directions perpendicular to an axis are coupled by their radius
  spherical,    ///< all three directions are coupled by their radius
};

/// One number for each direction: coordinates [m, rad] or generalised forces [N, N m].
using SixNumbers = Eigen::Matrix<double, 6, 1>;

/// Elements of each direction.
using SixElements = std::array<std::vector<element::ElementDescription>, kDirections>;

struct Wrench {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< [N]
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< about an origin that the user of the struct chooses [N m]
};

/// Velocity of body B relative to body A, in A's axes.
struct Twist {
  Eigen::Vector3d linear = Eigen::Vector3d::Zero();   ///< rate of the position of B's origin [m/s]
  Eigen::Vector3d angular = Eigen::Vector3d::Zero();  ///< [rad/s]
};

/// Parts of a component of six directions.
struct SixDirectionsLaws {
  /// Elements of each direction, for rotations in rad and N m. A direction without elements is free. If elements are
  /// given for only one of several coupled directions, they apply to all.
  SixElements elements;
  Coupling translation = Coupling::rectangular;
  Coupling rotation = Coupling::rectangular;
  std::size_t axis = 2;  ///< axis of cylindrical coupling: 0 x, 1 y, 2 z
  RotationMeasure measure = RotationMeasure::vector;
  double valid_rotation = kVectorEnd;                      ///< larger sizeOf() of a rotation is an extrapolation [rad]
  Eigen::Isometry3d on_a = Eigen::Isometry3d::Identity();  ///< frame of the bush on body A, in A
  Eigen::Isometry3d on_b = Eigen::Isometry3d::Identity();  ///< frame of the bush on body B, in B
};

struct BushForce {
  Wrench wrench;  ///< wrench on B, about B's origin, that holds the pose; in A's axes
  /// Generalised forces [N, N m] of the directions with their parts, in the axes of the bush on A.
  std::array<element::ComponentForce, kDirections> direction;
};

/// Wrenches of the bush on the bodies, in A's axes.
struct Reactions {
  Wrench on_a;  ///< wrench about A's origin: (F, M + d x F), with B's origin at d
  Wrench on_b;  ///< wrench about B's origin: (-F, -M)
};

/// Linearisation of one step about its end. The derivative of the wrench with respect to a small motion (translation of
/// B's origin, rotation) in A's axes is stiffness + damping/dt. It is not symmetric if a load turns with the pose.
struct SixTangent {
  Eigen::Matrix<double, 6, 6> stiffness;  ///< due to elastic and friction forces and turning axes [N/m, N, N m]
  Eigen::Matrix<double, 6, 6> damping;    ///< dt times the derivative of viscous forces
};

/// Memory of a component of six directions. Copy it to save it.
class SixDirectionsState {
 public:
  /// Copies the memory of another state of the same component. This is faster than a full copy.
  void copyFrom(const SixDirectionsState& other);

  /// Returns the coordinates at the last sample [m, rad].
  SixNumbers coordinates() const { return SixNumbers(coordinates_.data()); }

  /// Returns the memory for SixDirections::restore().
  std::vector<double> numbers() const;

 private:
  friend class SixDirections;

  std::array<ComponentState, kDirections> directions_;  // states of the directions that are not free
  std::vector<double> coupled_;                         // memory of the couplings
  std::array<double, kDirections> coordinates_{};
};

class RadialCoupling;

/// Computes a wrench from the pose of body B in body A:
///
///   1. The frames of the bush on the bodies determine six coordinates q: the translation d of the bush on B in the
///   axes of the bush on A, and three coordinates of the rotation (RotationMeasure).
///   2. Each direction is a Component, whose displacement is its coordinate. Coupled directions share laws.
///   3. The generalised forces Q of the directions satisfy F = Q_xyz and M . omega = Q_r . q_r'. They are converted to
///   a wrench about B's origin in A's axes.
///
/// Sign: as in one direction, the wrench has to be applied to B to hold the pose; reactions() act on the bodies.
/// Between two samples the coordinates are linear in time, as the exact step of every element requires. This is not the
/// screw motion between the poses (docs/six_directions.md). A common motion of both bodies changes nothing. Sources:
/// translation in A's axes and cardan angles as in Simbody's Force::LinearBushing; conjugate moment of the rotation
/// vector by its left Jacobian, see T. Barfoot, State Estimation for Robotics (2017), section 7.1. Validity: d and the
/// forces refer to A's axes, so A and B are not interchangeable at large rotations.
class SixDirections {
 public:
  /// Throws std::invalid_argument that begins with the direction, if an element or a coupling is rejected.
  explicit SixDirections(SixDirectionsLaws laws);

  const SixDirectionsLaws& laws() const { return laws_; }

  /// Returns a state of the right size, at rest at the identity pose.
  SixDirectionsState makeState() const;

  /// Initialises at rest at a pose of B in A, relaxed and never loaded before. A twist causes forces of dashpots only.
  BushForce initialise(SixDirectionsState& state, const Eigen::Isometry3d& pose, const Twist& twist = {}) const;

  /// Relaxes the component by a long rest at a pose. Permanent changes remain.
  BushForce relax(SixDirectionsState& state, const Eigen::Isometry3d& pose) const;

  /// Advances by dt > 0 [s] to a pose. Allocates nothing. The wrench is undefined if holds() returns false.
  BushForce step(SixDirectionsState& state, double dt, const Eigen::Isometry3d& pose) const;

  /// Advances with the twist at the pose, which pure dashpots use instead of the mean rate of the step. All other
  /// elements, and dashpots behind free play, compliance or similar effects, use only the poses.
  BushForce step(SixDirectionsState& state, double dt, const Eigen::Isometry3d& pose, const Twist& twist) const;

  /// Linearises the step of dt [s] from `state` to a pose about its end. `trial` is working space from makeState(). The
  /// laws are differentiated by central differences over 10 nm and 10 nrad, the axes with an error of 1e-9.
  SixTangent tangent(const SixDirectionsState& state, double dt, const Eigen::Isometry3d& pose,
                     SixDirectionsState& trial) const;

  /// Returns the coordinates of the bush [m, rad] for a pose of the bodies.
  SixNumbers coordinates(const Eigen::Isometry3d& pose) const;

  /// Returns the pose of the bodies for coordinates of the bush [m, rad].
  Eigen::Isometry3d pose(const SixNumbers& coordinates) const;

  /// Returns true if the rotation is within the limits of its measure.
  bool holds(const SixNumbers& coordinates) const { return measureHolds(laws_.measure, coordinates.tail<3>()); }

  /// Returns true if the rotation is within the stated validity.
  bool isValid(const SixNumbers& coordinates) const {
    return sizeOf(laws_.measure, coordinates.tail<3>()) <= laws_.valid_rotation;
  }

  /// Returns the generalised forces [N, N m] of the directions that are equivalent to a wrench on B at a pose. This is
  /// the inverse of the conversion in step().
  SixNumbers directionForces(const Eigen::Isometry3d& pose, const Wrench& wrench) const;

  /// Returns the wrenches on both bodies for a wrench that step() returned at a pose.
  static Reactions reactions(const Eigen::Isometry3d& pose, const Wrench& wrench);

  /// Temperature dependence of all directions, as in Component.
  bool shiftsWithTemperature() const;
  element::Range temperatures() const;
  void setTemperature(SixDirectionsState& state, double temperature) const;

  /// Continues from SixDirectionsState::numbers(). Throws std::invalid_argument, without changing the state, like
  /// Component::restore().
  void restore(SixDirectionsState& state, const std::vector<double>& numbers) const;

 private:
  using Coordinates = std::array<double, kDirections>;

  // Geometry of the bush at a pose.
  struct Place {
    Eigen::Vector3d translation;  // d in the axes of the bush on A [m]
    RotationCoordinates rotation;
    Eigen::Vector3d arm;  // vector from B's origin to the bush on B, in A's axes [m]

    Coordinates coordinates() const {
      const Eigen::Vector3d& turn = rotation.value;
      return {translation.x(), translation.y(), translation.z(), turn.x(), turn.y(), turn.z()};
    }
  };

  void couple(std::vector<Direction> directions, SixElements& elements);
  void coupleRadial(Direction first, SixElements& elements);
  void addCoupling(std::vector<Direction> directions, SixElements& elements);
  BushForce start(SixDirectionsState& state, const Place& place, bool as_new) const;
  Place placeAt(const Eigen::Isometry3d& pose) const;
  Place framedPlaceAt(const Eigen::Isometry3d& pose) const;
  SixNumbers ratesOf(const Place& place, const Twist& twist) const;
  void stepCoupled(SixDirectionsState& state, double dt, Coordinates coordinates, BushForce& force) const;
  BushForce stepInline(SixDirectionsState& state, double dt, const Coordinates& coordinates) const;
  BushForce stepDirections(SixDirectionsState& state, double dt, const Coordinates& coordinates) const;
  void addDamping(const SixNumbers& rates, BushForce& force) const;
  Wrench carriedToB(const Wrench& wrench, const Eigen::Vector3d& arm) const;
  void complete(const Place& place, BushForce& force) const;
  Eigen::Matrix<double, 6, 6> coordinateJacobian(const Place& place) const;
  Eigen::Matrix3d turningMoment(const Place& place, const Eigen::Vector3d& moments) const;

  SixDirectionsLaws laws_;
  bool framed_;  // true if a frame of the bush differs from the frame of the body
  std::array<std::optional<Component>, kDirections> directions_;  // nullopt if free or entirely coupled
  std::array<double, kDirections> damping_{};                     // damping of dashpots that use a twist [N s/m]
  std::vector<std::shared_ptr<const RadialCoupling>> couplings_;
  std::size_t coupled_size_ = 0;  // size of the memory of all couplings
};

}  // namespace rubber_suspension::component
