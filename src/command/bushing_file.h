// A component as a bushing property file of Adams or Altair: a text of blocks, with curves of force and constants of
// damping.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "rubber_suspension/component/six_directions.h"

namespace rubber_suspension::command {

/// Program that reads the file.
enum class BushingFormat { adams, altair };

/// Range of the curve and of the sine in one direction.
struct BushingCurve {
  double largest = 0.0;    ///< end of the curve to either side [m, rad]
  double amplitude = 0.0;  ///< amplitude of the sine that gives the damping [m, rad]
};

struct BushingFileOptions {
  BushingFormat format = BushingFormat::adams;
  int points = 41;         ///< number of points of a curve; odd, so that one of them is at 0
  double frequency = 0.0;  ///< frequency of the sine [Hz]
  BushingCurve translation;
  BushingCurve rotation;
};

/// Components by direction, rotations in rad and N m; a direction without a component is free.
struct Bushing {
  std::array<std::optional<component::Component>, component::kDirections> directions;
  component::Coupling translation = component::Coupling::rectangular;
  component::Coupling rotation = component::Coupling::rectangular;
  std::size_t axis = 2;               ///< axis of cylindrical coupling
  std::vector<std::string> left_out;  ///< notes on keys of the component file that a property file cannot represent
};

/// Returns the bushing of a component of six directions. Coupled directions without a law get that of a partner.
Bushing bushingOf(const component::SixDirections& component);

/// Returns the bushing of a component of one direction that acts along `axis`.
Bushing bushingAlong(component::Direction axis, const component::Component& component);

struct BushingFile {
  std::string text;
  std::vector<std::string> notes;  ///< properties of the component that the format cannot represent
};

/// Returns a file with a static curve and a damping constant for each direction, c = Im K*/(2 pi f) of the settled loop
/// under the given sine, in mm, N, degrees and s. A positive displacement has a positive force, as in this package.
///
/// Adams (.bus): blocks DAMPING and FX_CURVE to TZ_CURVE; a free direction has a curve of no force.
/// Altair (.gbs): SPLINE_STIFFNESS or, where the curve is a straight line, CONSTANT_STIFFNESS, and CONSTANT_DAMPING,
/// all switched on in DIRECTIONS; a free direction has none. RUBBER_DAMPING and HYDROMOUNT_DAMPING are laws that this
/// package does not have. Source of the keys: the help of Altair's bushing model, pages "Bushing Property File",
/// "Global Block", "Directions Block", "Spline Stiffness Block", "Constant Stiffness Block", "Constant Damping Block",
/// "Units Block" (help.altair.com, tools/bushing_model_property_file_*).
///
/// Throws std::invalid_argument for an invalid curve or sine of a direction that is not free.
BushingFile makeBushingFile(const std::string& name, const Bushing& bushing, const BushingFileOptions& options);

}  // namespace rubber_suspension::command
