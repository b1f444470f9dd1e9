// The blocks of a bushing property file.
#include "command/bushing_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <set>
#include <stdexcept>

#include "command/sweep_values.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/response/sweep.h"

namespace rubber_suspension::command {
namespace {

void checkOptions(const BushingFileOptions& options) {
  const bool good = std::string("xyz").find(options.axis) != std::string::npos && options.largest_displacement > 0.0 &&
                    std::isfinite(options.largest_displacement) && options.points >= 3 && options.points % 2 == 1;
  const bool sine =
      options.frequency > 0.0 && options.amplitude > 0.0 && std::isfinite(options.frequency + options.amplitude);
  if (!sine) {
    throw std::invalid_argument(fmt::format("{:g} Hz, {:g} m make no sine; accepted: both greater than 0",
                                            options.frequency, options.amplitude));
  }
  if (!good) {
    throw std::invalid_argument(
        fmt::format("axis {}, {:g} m, {} points; accepted: x, y or z, greater than 0, an odd number of 3 or more",
                    options.axis, options.largest_displacement, options.points));
  }
}

std::string rule(const std::string& block) {
  return "$" + std::string(79 - block.size(), '-') + block + "\n[" + block + "]\n";
}

std::string fileHeader() {
  return rule("MDI_HEADER") + " FILE_TYPE     =  'bus'\n FILE_VERSION  =  4.0\n FILE_FORMAT   =  'ASCII'\n" +
         rule("UNITS") +
         " LENGTH  =  'mm'\n ANGLE   =  'degrees'\n FORCE   =  'newton'\n MASS    =  'kg'\n TIME    =  'second'\n";
}

// Force that a new component at rest has at this displacement.
double forceAtRest(const component::Component& component, double displacement) {
  component::ComponentState state = component.makeState();
  return component.initialise(state, displacement).total;
}

std::string curve(const component::Component& component, const BushingFileOptions& options) {
  std::string text;
  for (int i = 0; i < options.points; ++i) {
    const double share = 2.0 * i / (options.points - 1) - 1.0;
    const double displacement = share * options.largest_displacement;
    text += fmt::format(" {:.9g}  {:.9g}\n", 1e3 * displacement, forceAtRest(component, displacement));
  }
  return text;
}

// The spring of the curve and the dashpot under a sine.
std::complex<double> stiffnessOfFile(const component::Component& component, double damping,
                                     const BushingFileOptions& options) {
  const double difference = forceAtRest(component, options.amplitude) - forceAtRest(component, -options.amplitude);
  return {0.5 * difference / options.amplitude, 2.0 * element::kPi * options.frequency * damping};
}

std::string lossOf(const std::string& type) {
  static const std::set<std::string> said = {"spring",       "dashpot",   "progressive_stiffness",
                                             "spring_table", "bump_stop", "asymmetric_stiffness"};
  return said.count(type) > 0 ? ""
                              : type + ": of it the file has the force at rest, and the loss under this one sine alone";
}

std::vector<std::string> notesOn(const component::Component& component, std::complex<double> measured,
                                 std::complex<double> of_file, const BushingFileOptions& options) {
  std::vector<std::string> notes = {fmt::format(
      "at {:g} Hz and {:g} mm the component has {:.4g} kN/mm and {:.3g} degrees, the file {:.4g} kN/mm and {:.3g} "
      "degrees: it has a static curve and a constant of damping, and neither frequency nor amplitude",
      options.frequency, 1e3 * options.amplitude, 1e-6 * std::abs(measured), kDegrees * std::arg(measured),
      1e-6 * std::abs(of_file), kDegrees * std::arg(of_file))};
  for (const element::ElementDescription& element : component.elements()) {
    const std::string loss = lossOf(element.type);
    if (!loss.empty() && std::find(notes.begin(), notes.end(), loss) == notes.end()) {
      notes.push_back(loss);
    }
  }
  notes.emplace_back("the component is along one axis: the other five directions of the file have no force");
  return notes;
}

}  // namespace

BushingFile makeBushingFile(const std::string& name, const component::Component& component,
                            const BushingFileOptions& options) {
  checkOptions(options);
  const response::SweepPoint point = response::characteristicsAt(component, options.frequency, options.amplitude);
  const auto measured = std::polar(point.characteristics.stiffness, point.characteristics.loss_angle);
  const double damping = std::max(0.0, measured.imag()) / (2.0 * element::kPi * options.frequency);
  BushingFile file;
  file.text = "$ " + name + ", by rubber_suspension\n" + fileHeader() + rule("DAMPING");
  const std::string own = fmt::format("F{}", static_cast<char>(options.axis - 'x' + 'X'));
  const std::vector<std::string> directions = {"FX", "FY", "FZ", "TX", "TY", "TZ"};
  for (const std::string& direction : directions) {
    file.text += fmt::format(" {}_DAMPING  =  {:.9g}\n", direction, direction == own ? 1e-3 * damping : 0.0);
  }
  for (const std::string& direction : directions) {
    file.text += rule(direction + "_CURVE");
    file.text += direction == own ? curve(component, options) : " -1  0\n 0  0\n 1  0\n";
  }
  file.notes = notesOn(component, measured, stiffnessOfFile(component, damping, options), options);
  if (!point.settled) {
    file.notes.emplace_back("the loop of this sine had not settled");
  }
  return file;
}

}  // namespace rubber_suspension::command
