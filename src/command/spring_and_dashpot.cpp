// Computes stiffness and damping constant of a component under one sine, and the error under other sines.
#include "command/spring_and_dashpot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "command/sweep_values.h"
#include "element/refuse.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/response/sweep.h"

namespace rubber_suspension::command {
namespace {

std::complex<double> stiffnessAt(const component::Component& component, const WorkingPoint& at) {
  const response::Characteristics values =
      response::characteristicsAt(component, at.frequency, at.amplitude).characteristics;
  return std::polar(values.stiffness, values.loss_angle);
}

std::string text(std::complex<double> stiffness) {
  return fmt::format("{:.4g} kN/mm and {:.3g} degrees", 1e-6 * std::abs(stiffness), kDegrees * std::arg(stiffness));
}

std::string text(const WorkingPoint& at) {
  return fmt::format("{:g} Hz and {:g} mm", at.frequency, 1e3 * at.amplitude);
}

}  // namespace

std::string stiffnessText(const component::Component& component, const WorkingPoint& at) {
  return text(stiffnessAt(component, at)) + " at " + text(at);
}

SpringAndDashpot springAndDashpot(const component::Component& component, const WorkingPoint& at) {
  element::refuseIf(!(at.frequency > 0.0 && at.amplitude > 0.0) || !std::isfinite(at.frequency + at.amplitude),
                    "a sine of {:g} Hz and {:g} m is impossible; accepted: both greater than 0", at.frequency,
                    at.amplitude);
  const double omega = 2.0 * element::kPi * at.frequency;
  const std::complex<double> stiffness = stiffnessAt(component, at);
  SpringAndDashpot result{stiffness.real(), std::max(0.0, stiffness.imag()) / omega, {}};
  const auto compare = [&](const WorkingPoint& elsewhere) {
    const std::complex<double> own(result.stiffness, 2.0 * element::kPi * elsewhere.frequency * result.damping);
    result.notes.push_back(fmt::format("at {} the component has {}; the spring and the dashpot have {}",
                                       text(elsewhere), text(stiffnessAt(component, elsewhere)), text(own)));
  };
  compare({0.1 * at.frequency, at.amplitude});
  compare({10.0 * at.frequency, at.amplitude});
  if (!component.linear()) {
    compare({at.frequency, 0.1 * at.amplitude});
    compare({at.frequency, 3.0 * at.amplitude});
  }
  return result;
}

std::string toYaml(const std::string& name, const SpringAndDashpot& values, const WorkingPoint& at) {
  const std::complex<double> stiffness(values.stiffness, 2.0 * element::kPi * at.frequency * values.damping);
  return fmt::format(
             "# {}, by rubber_suspension: spring and dashpot in parallel, with the values of the component:\n# {} at "
             "{}\nk_N_per_m: {:.9g}\nc_Ns_per_m: {:.9g}\nk_N_per_mm: {:.9g}\nc_Ns_per_mm: {:.9g}\n",
             name, text(stiffness), text(at), values.stiffness, values.damping, 1e-3 * values.stiffness,
             1e-3 * values.damping) +
         asComments(values.notes, "#");
}

std::string asComments(const std::vector<std::string>& notes, const std::string& mark) {
  std::string text;
  for (const std::string& note : notes) {
    text += mark + " " + note + "\n";
  }
  return text;
}

}  // namespace rubber_suspension::command
