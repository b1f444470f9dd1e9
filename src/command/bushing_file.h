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

/// The data of a direction that the file is to have.
struct BushingCurve {
  double largest = 0.0;    ///< the curve goes as far to both sides [m, rad]
  double amplitude = 0.0;  ///< of the sine whose loss the damping has [m, rad]
};

struct BushingFileOptions {
  BushingFormat format = BushingFormat::adams;
  int points = 41;         ///< of the curves, odd, so that 0 is one of them
  double frequency = 0.0;  ///< of the sine [Hz]
  BushingCurve translation;
  BushingCurve rotation;
};

/// Where the file has a force, rotations in rad and N m; nothing: the direction is free.
struct Bushing {
  std::array<std::optional<component::Component>, component::kDirections> directions;
  component::Coupling translation = component::Coupling::rectangular;
  component::Coupling rotation = component::Coupling::rectangular;
  std::size_t axis = 2;               ///< of cylindrical coupling
  std::vector<std::string> left_out;  ///< of the component file: keys whose content has no place in a property file
};

/// The bushing of a component of six directions. If only one of several coupled directions is given, it applies to all.
Bushing bushingOf(const component::SixDirections& component);

/// One of one direction, along an axis.
Bushing bushingAlong(component::Direction axis, const component::Component& component);

struct BushingFile {
  std::string text;
  std::vector<std::string> notes;  ///< what the format cannot say of this component
};

/// Static curves and a constant of damping each, c = Im K*/(2 pi f) of the settled loop under the sine given, in mm, N,
/// degrees and s. A positive displacement has a positive force, as everywhere in this package.
///
/// Adams (.bus): blocks DAMPING and FX_CURVE to TZ_CURVE; a free direction has a curve of no force.
/// Altair (.gbs): SPLINE_STIFFNESS or, where the curve is a straight line, CONSTANT_STIFFNESS, and CONSTANT_DAMPING,
/// all switched on in DIRECTIONS; a free direction has none. RUBBER_DAMPING and HYDROMOUNT_DAMPING are other laws than
/// any of this package, which their parameters cannot stand for. Source of the keys: the help of Altair's bushing
/// model, pages "Bushing Property File", "Global Block", "Directions Block", "Spline Stiffness Block", "Constant
/// Stiffness Block", "Constant Damping Block", "Units Block" (help.altair.com, tools/bushing_model_property_file_*).
///
/// Throws std::invalid_argument for options that make no curve or no sine of a direction that is there.
BushingFile makeBushingFile(const std::string& name, const Bushing& bushing, const BushingFileOptions& options);

}  // namespace rubber_suspension::command
