// Vehicles on components of six directions as Simbody models: a body on four bushes, and half a bogie.
// Simbody's headers take long to compile: include this file only where the model itself is stepped.
#pragma once

#include <Simbody.h>

#include <vector>

#include "rubber_suspension/component/six_directions.h"
#include "vehicle/parameters.h"
#include "vehicle/track.h"

namespace rubber_suspension::vehicle {

/// The wrench of a component as it is to be applied to its body B, at a pose of B in A.
using WrenchLaw = LoadLaw<Eigen::Isometry3d, component::Wrench>;

/// Motion about the equilibrium, so without gravity and preload. Axes as in REP 103: x forward, z up. The bodies'
/// frames lie at their centres of gravity, A of a component on the track in that frame as well: where the bush sits is
/// up to its own frames.
class BushedVehicle {
 public:
  /// Track and law must outlive the vehicle.
  BushedVehicle(BushedKind kind, const VehicleParameters& parameters, const Track& track, WrenchLaw& law);
  BushedVehicle(const BushedVehicle&) = delete;
  BushedVehicle& operator=(const BushedVehicle&) = delete;

  const SimTK::MultibodySystem& system() const { return system_; }

  /// At rest at time 0.
  SimTK::State restState() const { return system_.getDefaultState(); }

  /// Pose of B in A of each component.
  PerBush<Eigen::Isometry3d> motions(const SimTK::State& state) const;

 private:
  class BushForces;

  struct Mount {
    SimTK::MobilizedBodyIndex a;  // the ground, raised by the track, where the component stands on it
    SimTK::MobilizedBodyIndex b;
    double delay = 0.0;  // of the track below [s]
  };

  void makeBody(const VehicleParameters& parameters);
  void makeHalfBogie(const VehicleParameters& parameters);
  Eigen::Isometry3d motion(const SimTK::State& state, const Mount& mount) const;
  void apply(const SimTK::State& state, const Mount& mount, const component::Reactions& reactions,
             SimTK::Vector_<SimTK::SpatialVec>& body_forces) const;

  const Track& track_;
  SimTK::MultibodySystem system_;
  SimTK::SimbodyMatterSubsystem matter_;
  SimTK::GeneralForceSubsystem forces_;
  std::vector<Mount> mounts_;
};

}  // namespace rubber_suspension::vehicle
