// Converts a component to a bushing property file of Adams or Altair, with curves of force and damping constants.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "rubber_suspension/component/six_directions.h"

namespace rubber_suspension::command {

/// The program that is to read the file.
enum class BushingFormat { adams, altair };

/// The range of the curve, and the amplitude of the sine, in one direction.
struct BushingCurve {
  double largest = 0.0;    ///< largest displacement of the curve in both senses [m, rad]
  double amplitude = 0.0;  ///< amplitude of the sine from which the damping constant follows [m, rad]
};

struct BushingFileOptions {
  BushingFormat format = BushingFormat::adams;
  int points = 41;         ///< number of points of a curve; odd, so that one point is at 0
  double frequency = 0.0;  ///< frequency of the sine [Hz]
  BushingCurve translation;
  BushingCurve rotation;
};

/// The components by direction. Rotations are in rad and N m. A direction without a component is free of force.
struct Bushing {
  std::array<std::optional<component::Component>, component::kDirections> directions;
  component::Coupling translation = component::Coupling::rectangular;
  component::Coupling rotation = component::Coupling::rectangular;
  std::size_t axis = 2;               ///< axis of a cylindrical coupling
  std::vector<std::string> left_out;  ///< notes on keys of the component file that the property file cannot represent
};

/// Returns the bushing of a component of six directions. A direction without a law takes the law of a coupled one.
Bushing bushingOf(const component::SixDirections& component);

/// Returns the bushing of a component of one direction, which acts along `axis`.
Bushing bushingAlong(component::Direction axis, const component::Component& component);

struct BushingFile {
  std::string text;
  std::vector<std::string> notes;  ///< notes on properties of the component that the format cannot represent
};

/// Returns a property file with units mm, N, degrees and s. Each direction has a static curve of the force and a
/// damping constant c = Im K*/(2 pi f), where K* is the complex stiffness of the settled loop under the given sine of
/// frequency f. A positive displacement has a positive force, as in this package.
///
/// Adams (.bus): blocks DAMPING and FX_CURVE to TZ_CURVE. The curve of a free direction is 0.
/// Altair (.gbs): CONSTANT_DAMPING and SPLINE_STIFFNESS, or CONSTANT_STIFFNESS if the curve is a straight line, all
/// switched on in DIRECTIONS. A free direction has no block. RUBBER_DAMPING and HYDROMOUNT_DAMPING are laws that this
/// package lacks. Source of the keys: help of Altair's bushing model (help.altair.com,
/// tools/bushing_model_property_file_*), pages "Bushing Property File" and "Global", "Directions", "Spline Stiffness",
/// "Constant Stiffness", "Constant Damping" and "Units Block".
///
/// Throws std::invalid_argument if the curve or the sine of a direction that is not free is invalid.
BushingFile makeBushingFile(const std::string& name, const Bushing& bushing, const BushingFileOptions& options);

}  // namespace rubber_suspension::command
