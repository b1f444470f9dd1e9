// Directions that are coupled by their radius: laws that do not act separately in each direction.
#pragma once

#include <array>
#include <vector>

#include "rubber_suspension/component/six_directions.h"
#include "rubber_suspension/element/radial_stiffness.h"
#include "rubber_suspension/element/slider_bank.h"

namespace rubber_suspension::component {

/// The static curve, stops and radial stiffnesses of one direction as functions of the radius r >= 0.
class RadialLaw {
 public:
  /// Throws std::invalid_argument if the curve is not odd, or if there already is a curve.
  void addCurve(const element::ElementDescription& table);
  void addStop(const element::ElementDescription& stop);
  void addStiffening(const element::ElementDescription& radial);

  double curve(double r) const;  ///< force of the curve [N]
  double force(double r) const;  ///< force of all laws [N]
  double curveEnergy(double r) const;
  double energy(double r) const;  ///< energy of all laws [J]

  /// Returns the force [N] to subtract: that of the radial stiffnesses for a displacement in this direction alone.
  double own(double displacement) const;

  /// Returns the ratio of an entry's stiffness or damping to the slope of the curve. Throws std::invalid_argument if
  /// the entry's `values` are not proportional to the slope.
  double ratioOf(const element::ElementDescription& entry, const std::string& values) const;

  bool hasCurve() const { return !points_.empty(); }
  bool empty() const { return points_.empty() && stops_.empty() && stiffenings_.empty(); }
  void appendRadii(std::vector<double>& radii) const;  ///< appends the radii at which the slope changes

 private:
  struct Point {
    double radius;
    double force;
    double slope;   // slope beyond this radius
    double energy;  // energy up to this radius
  };
  struct Stop {
    element::ElementPointer law;
    double gap;
    double exponent;
  };

  const Point& pointBefore(double r) const;

  std::vector<Point> points_;
  std::vector<Stop> stops_;
  std::vector<element::RadialStiffness> stiffenings_;
};

/// Couples two directions (cylindrical) or three (spherical) with the coordinates d and radius r = |d|:
///   - spring, Maxwell element, dashpot and springpot act separately in each direction, as a vector law does;
///   - static curve, stop and radial_stiffness have the potential U = sum c_i^2 U_i(r), where c = d/r and U_i is the
///   potential of direction i. The radial force is the elliptic interpolation sum c_i^2 F_i(r), and a tangential force
///   ensures that no work is done over closed loops. If all directions have the same law, F = F(r) c. The force of a
///   radial_stiffness in one direction alone is subtracted;
///   - a branch that is scaled along the curve follows the force F_s of the curves, dF_j/dt = (k_j/k_0) dF_s/dt -
///   F_j/tau_j, and a dashpot has F_j = (c/k_0) dF_s/dt. F_s is assumed linear in time between radii at which the slope
///   changes, which is exact for radial motion;
///   - each slider of a bank has a force vector, whose magnitude is limited.
/// Other laws are rejected. The bushing of Adams Car uses the same interpolation without the tangential force.
class RadialCoupling {
 public:
  using Coordinates = std::array<double, kDirections>;  // [m, rad]

  /// Moves the laws that do not act separately in each direction from `elements` into the coupling. Throws
  /// std::invalid_argument that begins with the direction.
  RadialCoupling(std::vector<Direction> directions, SixElements& elements);

  std::size_t memorySize() const { return 3 * sliders_.size() + branch_count_; }

  /// Initialises the memory for a relaxed state at rest at the coordinates, and adds the forces.
  void initialise(const Coordinates& coordinates, double* memory, BushForce& force) const;

  /// Advances by a step in which the coordinates are linear, and adds the forces at its end.
  void step(double dt, const Coordinates& begin, const Coordinates& end, double* memory, BushForce& force) const;

 private:
  struct Branch {
    double ratio;  // ratio of stiffnesses k_j/k_0 [-]
    double rate;   // inverse relaxation time 1/tau [1/s]
  };

  void takeElastic(std::size_t axis, const std::vector<element::ElementDescription>& elastic);
  void takeScaled(std::size_t axis, const std::vector<element::ElementDescription>& scaled);

  Eigen::Vector3d vectorOf(const Coordinates& coordinates) const;
  Eigen::Vector3d elasticForce(const Eigen::Vector3d& d, bool with_stops) const;
  Eigen::Vector3d heldForce(const Eigen::Vector3d& d) const;
  void add(const Eigen::Vector3d& sum, double element::ComponentForce::* part, BushForce& force) const;
  Eigen::Vector3d stepSliders(const Eigen::Vector3d& d, double* memory) const;
  Eigen::Vector3d stepBranches(double dt, const Eigen::Vector3d& begin, const Eigen::Vector3d& end,
                               double* memory) const;
  template <class Visit>
  void visitPieces(const Eigen::Vector3d& begin, const Eigen::Vector3d& end, Visit visit) const;

  std::vector<Direction> directions_;
  std::array<RadialLaw, 3> laws_;
  bool one_law_ = true;
  bool elastic_ = false;
  std::vector<element::JenkinsSlider> sliders_;
  std::array<std::vector<Branch>, 3> branches_;
  std::size_t branch_count_ = 0;
  Eigen::Vector3d damping_ratio_ = Eigen::Vector3d::Zero();  // c/k_0 of dashpots along the curve [s]
  bool follows_ = false;                                     // true if branches or dashpots are scaled along the curve
  std::vector<double> radii_;                                // radii at which the slope of a curve changes, increasing
};

}  // namespace rubber_suspension::component
