// Iwan's friction.
#include "rubber_suspension/element/iwan.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "element/registry.h"

namespace rubber_suspension::element {
namespace {

constexpr int kMaximumSliders = 64;
constexpr double kGreatestYield = 50.0;  // greatest yield displacement divided by z2

int sliderCount(const ElementDescription& description) {
  const double count = description.value("sliders");
  if (count != std::floor(count)) {
    refuseValue(description.type, "sliders", count, "1", fmt::format("a whole number in [2, {}]", kMaximumSliders));
  }
  return static_cast<int>(count);
}

}  // namespace

std::vector<JenkinsSlider> slidersFromTable(const ElementDescription& description) {
  const std::vector<double>& yield = description.list("yield_displacement");
  const std::vector<double>& stiffness = description.list("stiffness");
  if (yield.empty() || yield.size() > kMaximumSliders || stiffness.size() != yield.size()) {
    throw std::invalid_argument(
        fmt::format("{}.stiffness: has {} values for {} yield displacements; accepted: two lists of equal length, with "
                    "1 to {} values",
                    description.type, stiffness.size(), yield.size(), kMaximumSliders));
  }
  std::vector<JenkinsSlider> sliders;
  for (std::size_t i = 0; i < yield.size(); ++i) {
    sliders.push_back({yield[i], stiffness[i]});
  }
  return sliders;
}

std::vector<JenkinsSlider> iwanSliders(double maximum_force, double displacement, int count) {
  const int middle = count / 2;
  const double ratio = std::pow(kGreatestYield, 1.0 / (count - middle));
  // The knee z2' is chosen so that h(z) = (z2' + Y)/Y z/(z2' + z) is 1/2 at z2 and 1 at the greatest yield displacement
  // Y.
  const double greatest = kGreatestYield * displacement;
  const double knee = displacement * greatest / (greatest - 2.0 * displacement);
  const auto hyperbola = [&](double z) { return maximum_force * (knee + greatest) / greatest * z / (knee + z); };

  std::vector<JenkinsSlider> sliders(static_cast<std::size_t>(count));
  double previous = 0.0;
  for (int i = 0; i < count; ++i) {
    JenkinsSlider& slider = sliders[static_cast<std::size_t>(i)];
    slider.yield_displacement = displacement * std::pow(ratio, i + 1 - middle);
    // This is the slope of the chord that ends here. The next slope is then subtracted from it.
    slider.stiffness =
        (hyperbola(slider.yield_displacement) - hyperbola(previous)) / (slider.yield_displacement - previous);
    if (i > 0) {
      sliders[static_cast<std::size_t>(i - 1)].stiffness -= slider.stiffness;
    }
    previous = slider.yield_displacement;
  }
  return sliders;
}

namespace {

const ElementEntry kIwanEntry(
    260, {"iwan",
          "Friction with memory: a bank of Jenkins sliders (Iwan), whose force from rest follows a hyperbola.",
          {{"maximum_force", "N", Role::scale, Range::positive(), "force F_max when all sliders slide"},
           {"displacement", "m", Role::shape, Range::positive(),
            "displacement z2 from rest at which friction reaches half of its maximum"},
           {"sliders", "1", Role::choice, Range::closed(2.0, kMaximumSliders), "whole number of sliders", 16.0}},
          [](const ElementDescription& description) -> ElementPointer {
            return std::make_shared<const SliderBank>(iwanSliders(
                description.value("maximum_force"), description.value("displacement"), sliderCount(description)));
          }});

const ElementEntry kIwanTableEntry(270,
                                   {"iwan_table",
                                    "Friction with memory: a bank of Jenkins sliders (Iwan), each with its own values.",
                                    {{"yield_displacement", "m", Role::shape, Range::positive(),
                                      "displacement at which each slider starts to slide", std::nullopt, true},
                                     {"stiffness", "N/m", Role::scale, Range::positive(),
                                      "stiffness of each slider's spring", std::nullopt, true}},
                                    [](const ElementDescription& description) -> ElementPointer {
                                      return std::make_shared<const SliderBank>(slidersFromTable(description));
                                    }});

}  // namespace
}  // namespace rubber_suspension::element
