// Writes bushing property files.
#include "command/bushing_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <set>
#include <stdexcept>

#include "command/spring_and_dashpot.h"
#include "command/sweep_values.h"
#include "element/refuse.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/response/sweep.h"

namespace rubber_suspension::command {
namespace {

const std::array<const char*, 6> kNames = {"FX", "FY", "FZ", "TX", "TY", "TZ"};

// A direction in which the component has forces, with its data in the units of the file.
struct Direction {
  component::Direction direction;
  const component::Component& component;
  BushingCurve extent;              // [m, rad]
  std::vector<double> position{};   // [mm, deg]
  std::vector<double> force{};      // [N, N mm]
  double damping = 0.0;             // [N s/mm, N mm s/deg]
  std::complex<double> measured{};  // K* of the component under the sine [N/m, N m/rad]
  bool settled = true;

  bool turns() const { return component::isRotation(direction); }
  std::string name() const { return kNames[direction]; }
  double lengths() const { return turns() ? kDegrees : 1e3; }  // units of length or angle of the file per SI unit
  double forces() const { return turns() ? 1e3 : 1.0; }
};

void checkOptions(const Direction& direction, const BushingFileOptions& options) {
  const BushingCurve& extent = direction.extent;
  const char* unit = direction.turns() ? "rad" : "m";
  const bool sine = options.frequency > 0.0 && extent.amplitude > 0.0;
  element::refuseIf(!sine || !std::isfinite(options.frequency + extent.amplitude),
                    "{}: a sine of {:g} Hz and {:g} {} is impossible; accepted: both greater than 0",
                    component::toString(direction.direction), options.frequency, extent.amplitude, unit);
  element::refuseIf(
      !(extent.largest > 0.0) || !std::isfinite(extent.largest) || options.points < 3 || options.points % 2 == 0,
      "{}: a curve up to {:g} {} with {} points is impossible; accepted: greater than 0, an odd number of 3 or more",
      component::toString(direction.direction), extent.largest, unit, options.points);
}

// Returns the force [N, N m] of a new component that rests at this displacement.
double forceAtRest(const component::Component& component, double displacement) {
  component::ComponentState state = component.makeState();
  return component.initialise(state, displacement).total;
}

void fill(Direction& direction, const BushingFileOptions& options) {
  checkOptions(direction, options);
  for (int i = 0; i < options.points; ++i) {
    const double displacement = (2.0 * i / (options.points - 1) - 1.0) * direction.extent.largest;
    direction.position.push_back(direction.lengths() * displacement);
    direction.force.push_back(direction.forces() * forceAtRest(direction.component, displacement));
  }
  const response::SweepPoint point =
      response::characteristicsAt(direction.component, options.frequency, direction.extent.amplitude);
  direction.measured = std::polar(point.characteristics.stiffness, point.characteristics.loss_angle);
  direction.settled = point.settled;
  direction.damping = std::max(0.0, direction.measured.imag()) / (2.0 * element::kPi * options.frequency) *
                      direction.forces() / direction.lengths();
}

std::vector<Direction> directionsOf(const Bushing& bushing, const BushingFileOptions& options) {
  std::vector<Direction> directions;
  for (std::size_t i = 0; i < bushing.directions.size(); ++i) {
    if (bushing.directions[i]) {
      const auto direction = static_cast<component::Direction>(i);
      directions.push_back({direction, *bushing.directions[i],
                            component::isRotation(direction) ? options.rotation : options.translation});
      fill(directions.back(), options);
    }
  }
  return directions;
}

std::string rule(const std::string& block) {
  return "$" + std::string(79 - block.size(), '-') + block + "\n[" + block + "]\n";
}

std::string fileHeader(const char* block, const char* type, const char* version, const char* angle) {
  return rule(block) +
         fmt::format(" FILE_TYPE     =  '{}'\n FILE_VERSION  =  {}\n FILE_FORMAT   =  'ASCII'\n", type, version) +
         rule("UNITS") +
         fmt::format(
             " LENGTH  =  'mm'\n ANGLE   =  '{}'\n FORCE   =  'newton'\n MASS    =  'kg'\n TIME    =  'second'\n",
             angle);
}

std::string curve(const Direction& direction) {
  std::string text;
  for (std::size_t i = 0; i < direction.position.size(); ++i) {
    text += fmt::format(" {:.9g}  {:.9g}\n", direction.position[i], direction.force[i]);
  }
  return text;
}

const Direction* find(const std::vector<Direction>& directions, const char* name) {
  const auto found = std::find_if(directions.begin(), directions.end(),
                                  [&](const Direction& direction) { return direction.name() == name; });
  return found == directions.end() ? nullptr : &*found;
}

std::string adamsBlocks(const std::vector<Direction>& directions) {
  std::string text = fileHeader("MDI_HEADER", "bus", "4.0", "degrees") + rule("DAMPING");
  for (const char* name : kNames) {
    const Direction* own = find(directions, name);
    text += fmt::format(" {}_DAMPING  =  {:.9g}\n", name, own != nullptr ? own->damping : 0.0);
  }
  for (const char* name : kNames) {
    const Direction* own = find(directions, name);
    text += rule(std::string(name) + "_CURVE") + (own != nullptr ? curve(*own) : " -1  0\n 0  0\n 1  0\n");
  }
  return text;
}

// Returns the stiffness [N/mm, N mm/deg] if the curve is a line through 0 up to rounding; otherwise nullopt.
std::optional<double> straight(const Direction& direction) {
  const double stiffness = direction.force.back() / direction.position.back();
  for (std::size_t i = 0; i < direction.force.size(); ++i) {
    if (std::abs(direction.force[i] - stiffness * direction.position[i]) > 1e-9 * std::abs(direction.force.back())) {
      return std::nullopt;
    }
  }
  return stiffness;
}

// Returns the coupling for the file. The format has a single one for forces and moments, cylindrical about z only.
std::string couplingWord(const Bushing& bushing) {
  if (bushing.translation == component::Coupling::cylindrical && bushing.axis == 2) {
    return "cylindrical";
  }
  return bushing.translation == component::Coupling::spherical ? "spherical" : "uncoupled";
}

std::string altairBlocks(const std::vector<Direction>& directions, const Bushing& bushing) {
  std::string blocks;
  const auto row = [&](const char* formulation, auto has) {
    std::string text = fmt::format(" {:20}", fmt::format("'{}'", formulation));
    for (const char* name : kNames) {
      const Direction* own = find(directions, name);
      text += own != nullptr && has(*own) ? "  1" : "  0";
    }
    return text + "\n";
  };
  for (const Direction& own : directions) {
    const std::optional<double> constant = straight(own);
    blocks += constant ? rule("CONSTANT_STIFFNESS_" + own.name()) + fmt::format(" K  =  {:.9g}\n", *constant)
                       : rule("SPLINE_STIFFNESS_" + own.name()) + "(SPLINE_DATA)\n{ disp  force }\n" + curve(own);
    blocks += rule("CONSTANT_DAMPING_" + own.name()) + fmt::format(" C  =  {:.9g}\n", own.damping);
  }
  const auto none = [](const Direction&) { return false; };
  return fileHeader("HEADER", "gbs", "'1'", "degree") + rule("GLOBAL") +
         fmt::format(" COUPLING  =  '{}'\n", couplingWord(bushing)) + rule("DIRECTIONS") +
         "(ACTIVITY)\n{ formulation         FX FY FZ TX TY TZ }\n" +
         row("SPLINE_STIFFNESS", [](const Direction& own) { return !straight(own); }) +
         row("CONSTANT_STIFFNESS", [](const Direction& own) { return straight(own).has_value(); }) +
         row("CUBIC_STIFFNESS", none) + row("CONSTANT_DAMPING", [](const Direction&) { return true; }) +
         row("RUBBER_DAMPING", none) + row("HYDROMOUNT_DAMPING", none) + blocks;
}

std::string lossOf(const std::string& type) {
  static const std::set<std::string> said = {"spring",       "dashpot",   "progressive_stiffness",
                                             "spring_table", "bump_stop", "asymmetric_stiffness"};
  return said.count(type) > 0
             ? ""
             : type + ": of this element the file contains only the force at rest and the loss under this one sine";
}

// Returns a note that compares the component under the sine with the static curve and the dashpot of the file.
std::string comparison(const Direction& direction, const BushingFileOptions& options) {
  const double amplitude = direction.extent.amplitude;
  const double difference = forceAtRest(direction.component, amplitude) - forceAtRest(direction.component, -amplitude);
  const std::complex<double> of_file(0.5 * difference / amplitude, std::max(0.0, direction.measured.imag()));
  const auto stiffness = [&](const std::complex<double>& value) {
    return direction.turns() ? fmt::format("{:.4g} N m/deg", std::abs(value) / kDegrees)
                             : fmt::format("{:.4g} kN/mm", 1e-6 * std::abs(value));
  };
  return fmt::format(
      "{}: at {:g} Hz and {:g} {} the component has {} and {:.3g} degrees, but the file {} and {:.3g} degrees: its "
      "static curve and its damping constant depend on neither frequency nor amplitude",
      component::toString(direction.direction), options.frequency, direction.lengths() * amplitude,
      direction.turns() ? "degrees" : "mm", stiffness(direction.measured), kDegrees * std::arg(direction.measured),
      stiffness(of_file), kDegrees * std::arg(of_file));
}

std::string couplingNote(const Bushing& bushing, const BushingFileOptions& options) {
  using component::Coupling;
  const bool adams = options.format == BushingFormat::adams;
  const bool lost = adams ? bushing.translation != Coupling::rectangular || bushing.rotation != Coupling::rectangular
                          : (couplingWord(bushing) == "uncoupled") != (bushing.translation == Coupling::rectangular) ||
                                bushing.rotation != bushing.translation;
  return !lost   ? ""
         : adams ? "coupling: the file cannot represent the coupling, because each direction has a separate curve"
                 : fmt::format("coupling: the file has a single coupling for forces and moments, '{}'",
                               couplingWord(bushing));
}

std::vector<std::string> notesOn(const std::vector<Direction>& directions, const Bushing& bushing,
                                 const BushingFileOptions& options) {
  std::vector<std::string> notes;
  const auto add = [&](const std::string& note) {
    if (!note.empty() && std::find(notes.begin(), notes.end(), note) == notes.end()) {
      notes.push_back(note);
    }
  };
  for (const Direction& direction : directions) {
    add(comparison(direction, options));
    add(direction.settled
            ? ""
            : fmt::format("{}: the loop under this sine did not settle", component::toString(direction.direction)));
    for (const element::ElementDescription& element : direction.component.elements()) {
      add(lossOf(element.type));
    }
  }
  std::vector<std::string> free;
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (!bushing.directions[i]) {
      free.emplace_back(component::toString(static_cast<component::Direction>(i)));
    }
  }
  add(free.empty() ? "" : fmt::format("{}: free; the file has no force in these directions", fmt::join(free, ", ")));
  add(couplingNote(bushing, options));
  for (const std::string& key : bushing.left_out) {
    add(key);
  }
  return notes;
}

}  // namespace

Bushing bushingAlong(component::Direction axis, const component::Component& component) {
  Bushing bushing;
  bushing.directions[axis] = component;
  return bushing;
}

Bushing bushingOf(const component::SixDirections& component) {
  const component::SixDirectionsLaws& laws = component.laws();
  Bushing bushing;
  bushing.translation = laws.translation;
  bushing.rotation = laws.rotation;
  bushing.axis = laws.axis;
  const auto partners = [&](std::size_t i, std::size_t j) {
    const component::Coupling coupling = i < 3 ? laws.translation : laws.rotation;
    return i / 3 == j / 3 &&
           (coupling == component::Coupling::spherical ||
            (coupling == component::Coupling::cylindrical && i % 3 != laws.axis && j % 3 != laws.axis));
  };
  for (std::size_t i = 0; i < component::kDirections; ++i) {
    for (std::size_t j = 0; j < component::kDirections; ++j) {
      if (!laws.elements[j].empty() && (i == j || (laws.elements[i].empty() && partners(i, j)))) {
        bushing.directions[i] = component::Component(laws.elements[j]);
      }
    }
  }
  const auto is_placed = [](const Eigen::Isometry3d& frame) { return !frame.isApprox(Eigen::Isometry3d::Identity()); };
  if (is_placed(laws.on_a) || is_placed(laws.on_b)) {
    bushing.left_out.emplace_back("frame: the file cannot represent it; place the bushing in the model accordingly");
  }
  bushing.left_out.emplace_back(
      laws.measure == component::RotationMeasure::vector
          ? "rotation: the component uses the rotation vector, the other program its own measure; the two agree to "
            "first order of the angle"
          : "rotation: the component uses body-fixed x-y-z angles, the other program its own measure");
  return bushing;
}

BushingFile makeBushingFile(const std::string& name, const Bushing& bushing, const BushingFileOptions& options) {
  const std::vector<Direction> directions = directionsOf(bushing, options);
  const std::string blocks =
      options.format == BushingFormat::adams ? adamsBlocks(directions) : altairBlocks(directions, bushing);
  const std::vector<std::string> notes = notesOn(directions, bushing, options);
  return {"$ " + name + ", by rubber_suspension\n" + asComments(notes, "$") + blocks, notes};
}

}  // namespace rubber_suspension::command
