// A component in six directions, such as a bush: the wrench between two bodies from their relative pose.
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

/// Directions in the order of wrenches and coordinates.
enum Direction : std::size_t { kX, kY, kZ, kRx, kRy, kRz, kDirections };

/// Returns the key in a component file: "x" to "rz".
const char* toString(Direction direction);

/// Returns the direction of that name, or nullopt.
std::optional<Direction> directionFromString(const std::string& name);

inline bool isRotation(Direction direction) { return direction >= kRx; }

/// Coupling of the three translations, or of the three rotations.
enum class Coupling {
  rectangular,  ///< each independent
  cylindrical,  ///< the two across an axis by their radius
  spherical,    ///< all three by their radius
};

/// Six numbers by direction: coordinates [m, rad], generalised forces [N, N m].
using SixNumbers = Eigen::Matrix<double, 6, 1>;

/// Elements by direction.
using SixElements = std::array<std::vector<element::ElementDescription>, kDirections>;

struct Wrench {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< [N]
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< about the origin that its owner defines [N m]
};

/// Velocity of B relative to A, in A's axes.
struct Twist {
  Eigen::Vector3d linear = Eigen::Vector3d::Zero();   ///< rate of the position of B's origin [m/s]
  Eigen::Vector3d angular = Eigen::Vector3d::Zero();  ///< [rad/s]
};

/// Parts of a component of six directions.
struct SixDirectionsLaws {
  /// Elements of each direction, rotations in rad and N m; none: the direction is free. If only one of several coupled
  /// directions is given, it applies to all.
  SixElements elements;
  Coupling translation = Coupling::rectangular;
  Coupling rotation = Coupling::rectangular;
  std::size_t axis = 2;  ///< of cylindrical coupling: 0 x, 1 y, 2 z
  RotationMeasure measure = RotationMeasure::vector;
  double valid_rotation = kVectorEnd;                      ///< sizeOf() beyond which forces are an extrapolation [rad]
  Eigen::Isometry3d on_a = Eigen::Isometry3d::Identity();  ///< where the bush sits on body A: its frame in A
  Eigen::Isometry3d on_b = Eigen::Isometry3d::Identity();  ///< where it sits on body B: its frame in B
};

/// Result of a step.
struct BushForce {
  Wrench wrench;  ///< to be applied to B, at B's origin, to hold the pose; in A's axes
  /// Generalised forces [N, N m] of the directions, in the bush's axes on A, with their parts.
  std::array<element::ComponentForce, kDirections> direction;
};

/// Wrenches of the bush on the bodies, in A's axes.
struct Reactions {
  Wrench on_a;  ///< about A's origin: (F, M + d x F)
  Wrench on_b;  ///< about B's origin: (-F, -M)
};

/// Linearisation of one step about its end. A small motion is (translation of B's origin, rotation), in A's axes; the
/// derivative of the wrench by it is stiffness + damping/dt. Not symmetric where a load turns with the pose.
struct SixTangent {
  Eigen::Matrix<double, 6, 6> stiffness;  ///< of the elastic and friction parts, and of the axes [N/m, N, N m]
  Eigen::Matrix<double, 6, 6> damping;    ///< dt times that of the viscous parts
};

/// Memory of a component of six directions; copy it to save it.
class SixDirectionsState {
 public:
  /// Copies the memory of another state of the same component; faster than copying all.
  void copyFrom(const SixDirectionsState& other);

  /// Returns the coordinates at the last sample [m, rad].
  SixNumbers coordinates() const { return SixNumbers(coordinates_.data()); }

  /// Returns the memory for SixDirections::restore().
  std::vector<double> numbers() const;

 private:
  friend class SixDirections;

  std::array<ComponentState, kDirections> directions_;  // of the directions that are not free
  std::vector<double> coupled_;                         // memory of the couplings
  std::array<double, kDirections> coordinates_{};
};

class RadialCoupling;

/// Pose of body B in body A -> wrench.
///
///   1. The frames of the bush on the bodies give the translation d of the bush on B in the axes of the bush on A, and
///      three coordinates of the rotation (RotationMeasure): six coordinates q.
///   2. Each direction is a Component of its own, with its coordinate as displacement; coupled directions share laws.
///   3. The forces Q of the directions are conjugate to q, F = Q_xyz and M . omega = Q_r . q_r', and are converted to
///      B's origin and A's axes.
///
/// Sign: as in one direction, the wrench has to be applied to B to hold the pose; reactions() act on the bodies.
/// Between two samples the coordinates are linear in time, so that the exact step of every element holds; this is not
/// the screw between the poses (docs/six_directions.md). A common motion of both bodies changes nothing.
/// Sources: translation in A's axes and cardan angles as Simbody's Force::LinearBushing; the conjugate moment of the
/// rotation vector by its left Jacobian, e.g. T. Barfoot, State Estimation for Robotics (2017), section 7.1.
/// Validity: d and the axes of the forces are those of A, so A and B are not interchangeable for large rotations.
class SixDirections {
 public:
  /// Throws std::invalid_argument that begins with the direction, if an element or a coupling is refused.
  explicit SixDirections(SixDirectionsLaws laws);

  const SixDirectionsLaws& laws() const { return laws_; }

  /// Returns a state of the right size, at rest at the identity pose.
  SixDirectionsState makeState() const;

  /// Initialises at rest at a pose of B in A, relaxed and never loaded before; with a twist, dashpots already move.
  BushForce initialise(SixDirectionsState& state, const Eigen::Isometry3d& pose, const Twist& twist = {}) const;

  /// Relaxes the component by a long rest at a pose; permanent changes remain.
  BushForce relax(SixDirectionsState& state, const Eigen::Isometry3d& pose) const;

  /// Advances by dt > 0 [s] to a pose. Allocates nothing. The wrench is undefined unless holds().
  BushForce step(SixDirectionsState& state, double dt, const Eigen::Isometry3d& pose) const;

  /// Advances with the twist at the pose, which pure dashpots use in place of the mean rate of the step. All other
  /// elements, and dashpots behind free play, compliance or the like, use the poses alone.
  BushForce step(SixDirectionsState& state, double dt, const Eigen::Isometry3d& pose, const Twist& twist) const;

  /// Linearises the step of dt [s] from `state` to a pose about its end. `trial` is working space from makeState().
  /// Derivatives of the laws are central differences over 10 nm and 10 nrad, those of the axes exact to 1e-9.
  SixTangent tangent(const SixDirectionsState& state, double dt, const Eigen::Isometry3d& pose,
                     SixDirectionsState& trial) const;

  /// Returns the coordinates of the bush [m, rad] at a pose of the bodies.
  SixNumbers coordinates(const Eigen::Isometry3d& pose) const;

  /// Returns the pose of the bodies from coordinates of the bush [m, rad].
  Eigen::Isometry3d pose(const SixNumbers& coordinates) const;

  /// Returns true if the rotation is within its measure.
  bool holds(const SixNumbers& coordinates) const { return measureHolds(laws_.measure, coordinates.tail<3>()); }

  /// Returns true if the rotation is within the stated validity.
  bool isValid(const SixNumbers& coordinates) const {
    return sizeOf(laws_.measure, coordinates.tail<3>()) <= laws_.valid_rotation;
  }

  /// Returns the generalised forces [N, N m] of the directions that are equivalent to a wrench on B at a pose: the
  /// inverse of the conversion in step().
  SixNumbers directionForces(const Eigen::Isometry3d& pose, const Wrench& wrench) const;

  /// Returns the wrenches on the bodies for one that step() returned at a pose.
  static Reactions reactions(const Eigen::Isometry3d& pose, const Wrench& wrench);

  /// Temperature dependence, as in Component, for all directions.
  bool shiftsWithTemperature() const;
  element::Range temperatures() const;
  void setTemperature(SixDirectionsState& state, double temperature) const;

  /// Continues from SixDirectionsState::numbers(). Throws std::invalid_argument, without changing the state, as
  /// Component::restore() does.
  void restore(SixDirectionsState& state, const std::vector<double>& numbers) const;

 private:
  using Coordinates = std::array<double, kDirections>;

  // Position of the bush at a pose.
  struct Place {
    Eigen::Vector3d translation;  // d in the axes of the bush on A [m]
    RotationCoordinates rotation;
    Eigen::Vector3d arm;  // from B's origin to the bush on B, in A's axes [m]

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
  bool framed_;  // the bush does not sit at the origins of the bodies, along their axes
  std::array<std::optional<Component>, kDirections> directions_;  // nullopt: free, or entirely coupled
  std::array<double, kDirections> damping_{};                     // of dashpots that depend on a twist [N s/m]
  std::vector<std::shared_ptr<const RadialCoupling>> couplings_;
  std::size_t coupled_size_ = 0;  // of their memory
};

}  // namespace rubber_suspension::component
