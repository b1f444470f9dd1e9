// One side of a bogie as a Simbody model: frame on two primary springs, body on a secondary one, above a track.
// Simbody's headers take long to compile: include this file only where the model itself is stepped.
#pragma once

#include <Simbody.h>

#include "vehicle/parameters.h"
#include "vehicle/track.h"

namespace rubber_suspension::vehicle {

/// Force [N] of a component at its compression [m].
using StrutLaw = LoadLaw<double, double>;

/// Motion about the equilibrium, so without gravity and preload.
class HalfBogie {
 public:
  /// Track and law must outlive the vehicle.
  HalfBogie(const VehicleParameters& parameters, const Track& track, StrutLaw& law);
  HalfBogie(const HalfBogie&) = delete;
  HalfBogie& operator=(const HalfBogie&) = delete;

  const SimTK::MultibodySystem& system() const { return system_; }
  const SimTK::SimbodyMatterSubsystem& matter() const { return matter_; }

  /// At rest at time 0.
  SimTK::State restState() const { return system_.getDefaultState(); }

  /// Compression of each component [m].
  PerStrut compressions(const SimTK::State& state) const;

  /// Generalised forces per force [N] in one component; the state has to be realized to Stage::Position.
  SimTK::Vector direction(const SimTK::State& state, std::size_t strut) const;

 private:
  class StrutForces;

  double height(const SimTK::State& state, SimTK::MobilizedBodyIndex body, double station) const;
  void apply(const SimTK::State& state, std::size_t strut, double force,
             SimTK::Vector_<SimTK::SpatialVec>& body_forces) const;

  VehicleParameters parameters_;
  const Track& track_;
  SimTK::MultibodySystem system_;
  SimTK::SimbodyMatterSubsystem matter_;
  SimTK::GeneralForceSubsystem forces_;
  SimTK::MobilizedBodyIndex frame_;
  SimTK::MobilizedBodyIndex body_;
};

}  // namespace rubber_suspension::vehicle
