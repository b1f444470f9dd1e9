// Vehicles on rubber components as Simbody models: half a bogie, and a body on four bushes. Include this file only
// where the model itself is stepped, because Simbody's headers are slow to compile.
#pragma once

#include <Simbody.h>

#include <vector>

#include "vehicle/bushes.h"
#include "vehicle/track.h"

namespace rubber_suspension::vehicle {

/// Computes the wrenches of the components of a vehicle.
class WrenchLaw {
 public:
  virtual ~WrenchLaw() = default;

  /// Returns the wrench of a component at a time [s] and a pose, also for trial steps, which may be rejected.
  virtual component::Wrench wrench(std::size_t bush, double time, const Eigen::Isometry3d& pose) = 0;
};

/// Simulates motion about the equilibrium, without gravity and preload. The axes are those of REP 103: x forward, z up.
/// The frames of the bodies are at their centres of gravity. At rest they coincide with the frame of the track, so that
/// the frames of a component alone determine its position. The coordinates of half a bogie are the height of the frame
/// [m], its pitch [rad] (positive lifts the front) and the height of the body [m].
class Vehicle {
 public:
  /// Track and law must outlive the vehicle.
  Vehicle(Kind kind, const VehicleParameters& parameters, const Track& track, WrenchLaw& law);
  Vehicle(const Vehicle&) = delete;
  Vehicle& operator=(const Vehicle&) = delete;

  const SimTK::MultibodySystem& system() const { return system_; }

  /// Returns the state at rest at time 0.
  SimTK::State restState() const { return system_.getDefaultState(); }

  Poses poses(const SimTK::State& state) const;

 private:
  class BushForces;

  struct Mount {
    SimTK::MobilizedBodyIndex a;  // a body, or the ground raised by the track
    SimTK::MobilizedBodyIndex b;
    double delay = 0.0;  // delay of the track below the component [s]
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
