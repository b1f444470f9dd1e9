// Specifications drawn within their tolerances.
#include "campaign/tolerance_draws.h"

#include <fmt/format.h>

#include <boost/math/special_functions/erf.hpp>
#include <cmath>
#include <random>
#include <stdexcept>

#include "log/text.h"

namespace rubber_suspension::campaign {
namespace {

// In (0, 1), never its ends: a normal number would be infinite there.
double uniform(std::mt19937_64& generator) {
  constexpr int kBits = 53;  // of a double's significand
  return std::ldexp(static_cast<double>(generator() >> (64 - kBits)) + 0.5, -kBits);
}

double draw(double nominal, const Tolerance& tolerance, std::mt19937_64& generator) {
  const double width = tolerance.is_share ? tolerance.width * std::abs(nominal) : tolerance.width;
  const double place = 2.0 * uniform(generator) - 1.0;
  return nominal +
         width * (tolerance.shape == Tolerance::Shape::uniform ? place : std::sqrt(2.0) * boost::math::erf_inv(place));
}

void checkNames(const estimation::Specification& nominal, const MonteCarlo& study) {
  std::vector<std::string> names;
  for (const auto& [name, value] : nominal.values()) {
    names.push_back(name);
  }
  for (const auto& [name, tolerance] : study.tolerances) {
    if (!nominal.has(name)) {
      throw std::invalid_argument(
          fmt::format("monte_carlo.tolerances.{}: the component does not specify it; accepted: {}", name,
                      names.empty() ? "a component with a specification" : log::join(names)));
    }
  }
}

}  // namespace

std::vector<std::map<std::string, double>> drawSpecifications(const estimation::Specification& nominal,
                                                              const MonteCarlo& study) {
  checkNames(nominal, study);
  std::mt19937_64 generator(study.seed);
  std::vector<std::map<std::string, double>> draws(study.runs);
  for (auto& numbers : draws) {
    for (const auto& [name, tolerance] : study.tolerances) {
      numbers[name] = draw(nominal.at(name), tolerance, generator);
    }
  }
  return draws;
}

}  // namespace rubber_suspension::campaign
