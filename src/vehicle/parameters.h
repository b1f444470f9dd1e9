// The data of the vehicles: masses and lengths.
#pragma once

#include <array>

namespace rubber_suspension::vehicle {

/// Kind of vehicle. Half a bogie is a frame on two primary springs, which carries a body on a secondary spring. A body
/// alone is rigid, such as a cab, and has six degrees of freedom on four bushes.
enum class Kind {
  struts,  ///< half a bogie on components of one direction
  bushes,  ///< half a bogie on components of six directions
  body,    ///< a body on components of six directions
};

/// Data of a body on four bushes: rounded numbers of a truck cab.
struct HungBody {
  double mass = 900.0;                                    ///< [kg]
  std::array<double, 3> inertia = {220.0, 700.0, 800.0};  ///< moments about x (forward), y and z (upward) [kg m^2]
  double wheelbase = 2.2;                                 ///< from front to rear bushes, which meet the track later [m]
};

/// Masses and lengths of half of a bogie and a quarter of a body of the Manchester benchmark coach [S. Iwnicki (ed.),
/// The Manchester Benchmarks for Rail Vehicle Simulation, Vehicle System Dynamics 31 Suppl. (1998)].
struct VehicleParameters {
  double frame_mass = 2615.0 / 2;     ///< [kg]
  double frame_inertia = 1476.0 / 2;  ///< moment about the lateral axis [kg m^2]
  double body_mass = 32000.0 / 4;     ///< [kg]
  double semi_wheelbase = 1.28;       ///< [m]
  double secondary_damping = 20e3;    ///< hydraulic damper in parallel with the secondary spring [N s/m]
  double speed = 160.0 / 3.6;         ///< [m/s]
  HungBody hung;
};

}  // namespace rubber_suspension::vehicle
