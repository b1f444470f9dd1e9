// One side of a bogie as a Simbody model: frame on two primary springs, body on a secondary one, above a track.
#pragma once

#include <Simbody.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "vehicle/track.h"

namespace rubber_suspension::vehicle {

/// The rubber components of the vehicle, in the order of all arrays below.
constexpr std::size_t kStruts = 3;
using PerStrut = std::array<double, kStruts>;
const std::array<std::string, kStruts>& strutNames();  ///< front_primary, rear_primary, secondary

/// Masses and lengths; half of a bogie and a quarter of a body of the Manchester benchmark coach [S. Iwnicki (ed.), The
/// Manchester Benchmarks for Rail Vehicle Simulation, Vehicle System Dynamics 31 Suppl. (1998)].
struct VehicleParameters {
  double frame_mass = 2615.0 / 2;     ///< [kg]
  double frame_inertia = 1476.0 / 2;  ///< about the lateral axis [kg m^2]
  double body_mass = 32000.0 / 4;     ///< [kg]
  double semi_wheelbase = 1.28;       ///< [m]
  double secondary_damping = 20e3;    ///< hydraulic damper beside the secondary spring [N s/m]
  double speed = 160.0 / 3.6;         ///< [m/s]
};

/// Where the vehicle gets the forces of its rubber components from.
class StrutLaw {
 public:
  virtual ~StrutLaw() = default;

  /// The force of a component [N] at a time [s] and compression [m]. Called for trial steps that may be taken back.
  virtual double force(std::size_t strut, double time, double compression) = 0;
};

/// Motion about the equilibrium, so without gravity and preload. Coordinates: height of the frame [m], its pitch [rad]
/// (positive lifts the front), height of the body [m].
class HalfBogie {
 public:
  static constexpr int kCoordinates = 3;

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
