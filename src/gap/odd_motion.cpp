// Compares the scales of a log with those of the component, because a wrong unit changes a scale by a factor of 1000.
#include "gap/odd_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rubber_suspension::gap {
namespace {

// Millimetres instead of metres are a factor of 1000. This limit, about 3 sqrt(1000), detects a log in millimetres with
// more than a tenth of the amplitude of the component, and accepts a log in metres with thirty times this amplitude.
constexpr double kOddFactor = 100.0;

// Longer than any travel of a rubber spring [m]. Used for components that state no length at all.
constexpr double kLongestAmplitude = 0.5;

double rangeOf(const std::vector<double>& values) {
  if (values.empty()) {
    return 0.0;
  }
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return *high - *low;
}

double longestLength(const std::vector<element::ElementDescription>& elements) {
  double longest = 0.0;
  for (const element::ElementDescription& element : elements) {
    for (const element::ParameterInfo& parameter : element::findElementType(element.type)->parameters) {
      if (parameter.unit == "m" && element.values.count(parameter.name) > 0) {
        for (const double value : element.list(parameter.name)) {
          longest = std::max(longest, std::abs(value));
        }
      }
    }
  }
  return longest;
}

// Checks the stiffness of the log, which depends on the units of both columns. Returns nullopt if a range is 0.
std::optional<std::string> oddStiffness(double stroke, double measured, double simulated) {
  if (!(stroke > 0.0) || !(measured > 0.0) || !(simulated > 0.0)) {
    return std::nullopt;
  }
  const double ratio = measured / simulated;
  if (ratio > 1.0 / kOddFactor && ratio < kOddFactor) {
    return std::nullopt;
  }
  return fmt::format(
      "the log has a stroke of {:.3g} m and a measured force range of {:.3g} N, which is {:.2g} times {} than the "
      "model predicts ({:.3g} N): are the units of the columns right?",
      stroke, measured, ratio < 1.0 ? 1.0 / ratio : ratio, ratio < 1.0 ? "softer" : "stiffer", simulated);
}

}  // namespace

MotionScale motionScaleOf(const io::ComponentDescription& description) {
  const std::optional<double> nominal = description.specification().find("nominal_amplitude");
  const double longest = longestLength(description.allElements());
  return nominal || longest == 0.0 ? nominal : longest;
}

std::optional<std::string> oddAmplitude(double amplitude, const MotionScale& scale) {
  if (scale) {
    const double ratio = amplitude / *scale;
    return ratio > kOddFactor
               ? std::optional(fmt::format("{:.3g} m is {:.2g} times the component's nominal amplitude of {:.3g} m",
                                           amplitude, ratio, *scale))
               : std::nullopt;
  }
  return amplitude > kLongestAmplitude
             ? std::optional(fmt::format("{:.3g} m is more than the travel of any rubber component", amplitude))
             : std::nullopt;
}

std::optional<std::string> oddMotion(const log::Log& log, const std::vector<double>& force, const MotionScale& scale) {
  const double stroke = rangeOf(log.displacement);
  const double measured = rangeOf(log.force);
  const double simulated = rangeOf(force);
  if (measured > 0.0 && simulated > 0.0) {
    return oddStiffness(stroke, measured, simulated);
  }
  const std::optional<std::string> odd = oddAmplitude(0.5 * stroke, scale);
  return odd ? std::optional("an amplitude of " + *odd + ": is the displacement column in millimetres?") : std::nullopt;
}

std::optional<std::string> oddMotion(const log::Log& log, const io::ComponentDescription& description) {
  const auto [low, high] = std::minmax_element(log.displacement.begin(), log.displacement.end());
  const component::Component component = description.makeComponent();
  component::ComponentState state = component.makeState();
  const double force_low = component.initialise(state, *low).total;
  const double force_high = component.initialise(state, *high).total;
  return oddMotion(log, {force_low, force_high}, motionScaleOf(description));
}

std::optional<std::string> beyondValid(const log::Log& log, const io::ComponentDescription& description) {
  const std::optional<element::Range> valid = description.validDisplacement();
  const auto beyond = [&](double displacement) { return !valid->contains(displacement); };
  const auto first =
      valid ? std::find_if(log.displacement.begin(), log.displacement.end(), beyond) : log.displacement.end();
  if (first == log.displacement.end()) {
    return std::nullopt;
  }
  return fmt::format(
      "{} of {} samples lie beyond valid_displacement ({:g} to {:g} mm); the first is sample {} at {:g} mm",
      std::count_if(first, log.displacement.end(), beyond), log.size(), 1e3 * valid->lower, 1e3 * valid->upper,
      first - log.displacement.begin() + 1, 1e3 * *first);
}

}  // namespace rubber_suspension::gap
