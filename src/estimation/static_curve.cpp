// The static curve of a component.
#include "rubber_suspension/estimation/static_curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "element/refuse.h"
#include "estimation/models.h"
#include "rubber_suspension/element/catalogue.h"
#include "rubber_suspension/element/slider_bank.h"

namespace rubber_suspension::estimation {
namespace {

// Returns the index of the piece that contains a displacement. The first and last piece extend beyond the curve.
std::size_t pieceAt(const std::vector<double>& displacement, double z) {
  const auto after = std::upper_bound(displacement.begin() + 1, displacement.end() - 1, z);
  return static_cast<std::size_t>(after - displacement.begin()) - 1;
}

}  // namespace

std::vector<double> StaticCurve::slopes() const {
  std::vector<double> slopes;
  for (std::size_t i = 1; i < displacement.size(); ++i) {
    slopes.push_back((force[i] - force[i - 1]) / (displacement[i] - displacement[i - 1]));
  }
  return slopes;
}

void StaticCurve::check() const {
  element::refuseIf(
      displacement.size() < 2 || force.size() != displacement.size(),
      "static_curve: has {} forces for {} displacements; accepted: one force for each of at least 2 displacements",
      force.size(), displacement.size());
  for (std::size_t i = 1; i < displacement.size(); ++i) {
    if (!(displacement[i] > displacement[i - 1])) {
      throw std::invalid_argument(
          fmt::format("static_curve: the displacement {:g} m follows {:g} m; accepted: displacements that increase",
                      displacement[i], displacement[i - 1]));
    }
    const double rise = force[i] - force[i - 1];
    const std::string place = fmt::format("static_curve: the force {} from {:g} m to {:g} m",
                                          rise < 0.0 ? "falls" : "does not rise", displacement[i - 1], displacement[i]);
    element::refuseIf(scales && !(rise > 0.0),
                      "{}, and elements that scale with the curve would create energy there; accepted: forces that "
                      "rise, or scale_with: none",
                      place);
    element::refuseIf(monotone && rise < 0.0, "{}; with monotone: true the forces must not decrease", place);
  }
}

double StaticCurve::forceAt(double z) const {
  const std::size_t i = pieceAt(displacement, z);
  return force[i] + slopes()[i] * (z - displacement[i]);
}

double StaticCurve::tangentAt(double z) const {
  const std::vector<double> slope = slopes();
  const std::size_t i = pieceAt(displacement, z);
  return i > 0 && z == displacement[i] ? 0.5 * (slope[i - 1] + slope[i]) : slope[i];
}

double StaticCurve::displacementAt(double wanted) const {
  const std::vector<double> slope = slopes();
  std::vector<double> found;
  for (std::size_t i = 0; i < slope.size(); ++i) {
    const double z = displacement[i] + (wanted - force[i]) / slope[i];
    const bool after = i == 0 || z >= displacement[i];
    const bool before = i + 1 == slope.size() || z < displacement[i + 1];
    if (std::isfinite(z) && after && before) {
      found.push_back(z);
    }
  }
  element::refuseIf(found.size() != 1,
                    "nominal_force: static_curve has {} displacements with a force of {:g} N; accepted: a force that "
                    "occurs exactly once, or nominal_displacement",
                    found.size(), wanted);
  return found.front();
}

namespace {

// The slope of the curve relative to that at the working point, with a step at each point of the curve.
struct SlopeFactor {
  std::vector<double> displacement;
  std::vector<double> factor;

  SlopeFactor(const StaticCurve& curve, double nominal_displacement) {
    const double nominal = curve.tangentAt(nominal_displacement);
    const std::vector<double> slopes = curve.slopes();
    for (std::size_t i = 0; i < slopes.size(); ++i) {
      displacement.insert(displacement.end(), {curve.displacement[i], curve.displacement[i + 1]});
      factor.insert(factor.end(), 2, slopes[i] / nominal);
    }
  }

  std::vector<double> times(double value) const {
    std::vector<double> values = factor;
    std::for_each(values.begin(), values.end(), [&](double& entry) { entry *= value; });
    return values;
  }
};

std::optional<element::ElementDescription> scaledEntry(const SlopeFactor& slope,
                                                       const element::ElementDescription& entry) {
  if (entry.type == "maxwell") {
    return {{"maxwell_along_curve",
             {{"displacement", slope.displacement},
              {"stiffness", slope.times(entry.value("stiffness"))},
              {"break_frequency", {entry.value("break_frequency")}}}}};
  }
  if (entry.type == "dashpot") {
    return {{"dashpot_along_curve",
             {{"displacement", slope.displacement}, {"damping", slope.times(entry.value("damping"))}}}};
  }
  const element::ElementPointer element = element::makeElement(entry);
  const auto* bank = dynamic_cast<const element::SliderBank*>(element::parallelLaw(element));
  if (bank == nullptr) {
    return std::nullopt;
  }
  element::ElementDescription scaled{"sliders_along_curve",
                                     {{"displacement", slope.displacement}, {"factor", slope.factor}}};
  for (const element::JenkinsSlider& slider : bank->sliders()) {
    scaled.values["yield_displacement"].push_back(slider.yield_displacement);
    scaled.values["stiffness"].push_back(slider.stiffness);
  }
  return scaled;
}

}  // namespace

element::ElementDescription scaledAlong(const StaticCurve& curve, double nominal_displacement,
                                        const element::ElementDescription& entry) {
  if (auto scaled = scaledEntry(SlopeFactor(curve, nominal_displacement), entry)) {
    return *scaled;
  }
  throw std::invalid_argument(
      fmt::format("{}.scale_with: this element cannot scale with a curve; accepted: maxwell, dashpot, "
                  "coulomb_friction, iwan, iwan_table",
                  entry.type));
}

element::ElementDescription springOf(const StaticCurve& curve) {
  return {"spring_table", {{"displacement", curve.displacement}, {"force", curve.force}, {"monotone", {0.0}}}};
}

std::vector<element::ElementDescription> alongCurve(const StaticCurve& curve, double nominal_displacement,
                                                    std::vector<element::ElementDescription> elements) {
  const SlopeFactor slope(curve, nominal_displacement);
  for (element::ElementDescription& element : elements) {
    if (element.type == "spring") {
      element = springOf(curve);
    } else if (curve.scales && element.type != "friction") {
      element = scaledEntry(slope, element).value();
    }
  }
  return elements;
}

}  // namespace rubber_suspension::estimation
