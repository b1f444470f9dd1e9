// The data of the vehicle: its rubber components, coordinates, masses and lengths.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace rubber_suspension::vehicle {

/// The rubber components of the vehicle, in the order of all arrays below.
constexpr std::size_t kStruts = 3;
using PerStrut = std::array<double, kStruts>;
const std::array<std::string, kStruts>& strutNames();  ///< front_primary, rear_primary, secondary

/// Which vehicle stands on components of six directions.
enum class BushedKind {
  body,        ///< a rigid body, such as a cab, on four bushes; all six freedoms
  half_bogie,  ///< that of the struts, each of which is a component of six directions
};

/// The components in the order of all lists below: those of the body are front_left, front_right, rear_left,
/// rear_right; those of the half bogie are the struts.
const std::vector<std::string>& bushNames(BushedKind kind);
template <class Value>
using PerBush = std::vector<Value>;

/// A body on four bushes; round numbers of a truck's cab.
struct HungBody {
  double mass = 900.0;                                    ///< [kg]
  std::array<double, 3> inertia = {220.0, 700.0, 800.0};  ///< about x forward, y, z upward [kg m^2]
  double wheelbase = 2.2;                                 ///< the track comes later to the rear bushes [m]
};

/// Masses and lengths; half of a bogie and a quarter of a body of the Manchester benchmark coach [S. Iwnicki (ed.), The
/// Manchester Benchmarks for Rail Vehicle Simulation, Vehicle System Dynamics 31 Suppl. (1998)].
struct VehicleParameters {
  double frame_mass = 2615.0 / 2;     ///< [kg]
  double frame_inertia = 1476.0 / 2;  ///< about the lateral axis [kg m^2]
  double body_mass = 32000.0 / 4;     ///< [kg]
  double semi_wheelbase = 1.28;       ///< [m]
  double secondary_damping = 20e3;    ///< hydraulic damper beside the secondary spring [N s/m]
  double speed = 160.0 / 3.6;         ///< [m/s]
  HungBody hung;
};

/// Where a vehicle gets the loads of its components from.
template <class Motion, class Load>
class LoadLaw {
 public:
  virtual ~LoadLaw() = default;

  /// The load of a component at a time [s] and motion. Called for trial steps that may be taken back.
  virtual Load load(std::size_t component, double time, const Motion& motion) = 0;
};

/// Height of the frame [m], its pitch [rad] (positive lifts the front), height of the body [m].
constexpr std::size_t kCoordinates = 3;
using Coordinates = std::array<double, kCoordinates>;

}  // namespace rubber_suspension::vehicle
