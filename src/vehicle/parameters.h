// What everything about the vehicle knows of it: its rubber components, coordinates, masses and lengths.
#pragma once

#include <array>
#include <cstddef>
#include <string>

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

/// Height of the frame [m], its pitch [rad] (positive lifts the front), height of the body [m].
constexpr std::size_t kCoordinates = 3;
using Coordinates = std::array<double, kCoordinates>;

}  // namespace rubber_suspension::vehicle
