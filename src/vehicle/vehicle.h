// Vehicles on rubber components as Simbody models: half a bogie, and a body on four bushes. Simbody's headers take long
// to compile: include this file only to step the model itself.
#pragma once

#include <Simbody.h>

#include <vector>

#include "vehicle/bushes.h"
#include "vehicle/track.h"

namespace rubber_suspension::vehicle {

/// Source of the wrenches of a vehicle's components.
class WrenchLaw {
 public:
  virtual ~WrenchLaw() = default;

  /// The wrench of a component at a time [s] and pose. Called for trial steps, which may be rejected.
  virtual component::Wrench wrench(std::size_t bush, double time, const Eigen::Isometry3d& pose) = 0;
};

/// Motion about the equilibrium, so without gravity and preload. Axes as in REP 103: x forward, z up. The bodies'
/// frames lie at their centres of gravity, A of a component on the track in that frame as well: where the bush sits is
/// up to its own frames. The coordinates of half a bogie are the height of the frame [m], its pitch [rad] (positive
/// lifts the front) and the height of the body [m].
class Vehicle {
 public:
  /// Track and law must outlive the vehicle.
  Vehicle(Kind kind, const VehicleParameters& parameters, const Track& track, WrenchLaw& law);
  Vehicle(const Vehicle&) = delete;
  Vehicle& operator=(const Vehicle&) = delete;

  const SimTK::MultibodySystem& system() const { return system_; }

  /// At rest at time 0.
  SimTK::State restState() const { return system_.getDefaultState(); }

  Poses poses(const SimTK::State& state) const;

 private:
  class BushForces;

  struct Mount {
    SimTK::MobilizedBodyIndex a;  // the ground, raised by the track, where the component stands on it
    SimTK::MobilizedBodyIndex b;
    double delay = 0.0;  // of the track below [s]
  };

  void makeBody(const VehicleParameters& parameters);
  void makeHalfBogie(const VehicleParameters& parameters);
  Eigen::Isometry3d pose(const SimTK::State& state, const Mount& mount) const;
  void apply(const SimTK::State& state, const Mount& mount, const component::Reactions& reactions,
             SimTK::Vector_<SimTK::SpatialVec>& body_forces) const;

  const Track& track_;
  SimTK::MultibodySystem system_;
  SimTK::SimbodyMatterSubsystem matter_;
  SimTK::GeneralForceSubsystem forces_;
  std::vector<Mount> mounts_;
};

}  // namespace rubber_suspension::vehicle
