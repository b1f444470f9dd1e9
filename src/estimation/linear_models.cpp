// M1 (Kelvin-Voigt), M2 with one Maxwell element and M3 (Maxwell element and dashpot) in closed form. Source: Polach
// (IAVSD 2015), Eqs. 10 to 16. Symbols are those of specification.h.
#include <fmt/format.h>

#include <cmath>
#include <complex>

#include "estimation/models.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::estimation {
namespace {

// Returns the stiffness k1 that gives |K*(f_n)| = K_n at a break frequency f_b: the positive root of k1^2 + 2 K_st k1 =
// (K_n^2 - K_st^2)(1 + (f_b/f_n)^2).
double maxwellStiffness(const Specification& specification, double break_frequency) {
  const double k_st = specification.at("static_stiffness");
  const double k_n = specification.at("dynamic_stiffness");
  const double ratio = break_frequency / specification.at("nominal_frequency");
  const double right = (k_n - k_st) * (k_n + k_st) * (1.0 + ratio * ratio);
  return right / (k_st + std::sqrt(k_st * k_st + right));
}

}  // namespace

double breakFrequencyForLossAngle(const Specification& specification) {
  const std::complex<double> dynamic = std::polar(specification.at("dynamic_stiffness"), lossAngle(specification));
  return specification.at("nominal_frequency") * dynamic.imag() /
         (dynamic.real() - specification.at("static_stiffness"));
}

double breakFrequencyForMaximum(const Specification& specification) {
  const double k_st = specification.at("static_stiffness");
  const double k_n = specification.at("dynamic_stiffness");
  const double k_max = specification.at("maximum_stiffness");
  return specification.at("nominal_frequency") *
         std::sqrt((k_max - k_n) * (k_max + k_n) / ((k_n - k_st) * (k_n + k_st)));
}

std::optional<Obstacle> storageObstacle(const Specification& specification) {
  const double angle = lossAngle(specification);
  const double storage = specification.at("dynamic_stiffness") * std::cos(angle);
  if (storage > specification.at("static_stiffness")) {
    return std::nullopt;
  }
  const std::string key = specification.has("loss_angle") ? "loss_angle" : "relative_damping";
  return Obstacle{key, fmt::format("gives a storage stiffness K_n cos(delta) of {:.6g} N/m, which is not above {}",
                                   storage, inputText(specification, "static_stiffness"))};
}

double breakFrequencyForHighStiffness(const Specification& specification) {
  const auto added = [&](const char* key) {
    const double stiffness = specification.at(key);
    const double k_st = specification.at("static_stiffness");
    return (stiffness - k_st) * (stiffness + k_st);
  };
  const double f_n = specification.at("nominal_frequency");
  const double f_h = specification.at("high_frequency");
  // K^2 - K_st^2 at a frequency f is proportional to f^2/(f^2 + f_b^2).
  const double ratio = added("dynamic_stiffness") / added("high_frequency_stiffness") * (f_h / f_n) * (f_h / f_n);
  return std::sqrt((f_h * f_h - ratio * f_n * f_n) / (ratio - 1.0));
}

double highStiffnessOfOne(const Specification& specification, double break_frequency) {
  const double k_st = specification.at("static_stiffness");
  const std::complex<double> ratio(0.0, specification.at("high_frequency") / break_frequency);
  return std::abs(k_st + maxwellStiffness(specification, break_frequency) * ratio / (1.0 + ratio));
}

std::optional<Obstacle> highFrequencyObstacle(const Specification& specification) {
  if (specification.at("nominal_frequency") >= specification.at("high_frequency")) {
    return Obstacle{"high_frequency", "is not above " + inputText(specification, "nominal_frequency")};
  }
  if (specification.at("high_frequency_stiffness") <= specification.at("dynamic_stiffness")) {
    return Obstacle{"high_frequency_stiffness", "is not above " + inputText(specification, "dynamic_stiffness")};
  }
  return std::nullopt;
}

std::optional<Obstacle> maxwellObstacle(const Specification& specification) {
  if (specification.has("high_frequency_stiffness")) {
    auto obstacle = highFrequencyObstacle(specification);
    // With a break frequency far above f_h the element acts as a dashpot, whose stiffness rises most.
    if (!obstacle && !std::isfinite(breakFrequencyForHighStiffness(specification))) {
      obstacle = Obstacle{"high_frequency_stiffness", "rises more from f_n to f_h than one Maxwell element allows"};
    }
    return obstacle;
  }
  const bool by_angle = specification.has("loss_angle") || specification.has("relative_damping");
  return by_angle ? storageObstacle(specification) : std::nullopt;
}

std::optional<Obstacle> maxwellDashpotObstacle(const Specification& specification) {
  if (auto obstacle = storageObstacle(specification)) {
    return obstacle;
  }
  const double limit = breakFrequencyForLossAngle(specification);
  if (specification.at("break_frequency") < limit) {
    return std::nullopt;
  }
  return Obstacle{"break_frequency",
                  fmt::format("gives the Maxwell element alone a larger loss than the loss angle allows, so that the "
                              "dashpot would be negative; the largest break frequency is {:.6g} Hz",
                              limit)};
}

std::vector<element::ElementDescription> estimateKelvinVoigt(const Specification& specification) {
  // Eq. 11: tan(delta) = 2 pi f c0/k0 = 2 D. K_n is the storage stiffness k0, so |K*| = K_n/cos(delta).
  const double stiffness = specification.at("dynamic_stiffness");
  const double damping =
      stiffness * std::tan(lossAngle(specification)) / (2.0 * element::kPi * specification.at("nominal_frequency"));
  return {{"spring", {{"stiffness", {stiffness}}}}, {"dashpot", {{"damping", {damping}}}}};
}

std::vector<element::ElementDescription> estimateMaxwell(const Specification& specification) {
  const double k_st = specification.at("static_stiffness");
  double stiffness = 0.0;
  double break_frequency = 0.0;
  if (specification.has("maximum_stiffness")) {
    break_frequency = breakFrequencyForMaximum(specification);
    stiffness = specification.at("maximum_stiffness") - k_st;
  } else {
    break_frequency = specification.has("break_frequency")            ? specification.at("break_frequency")
                      : specification.has("high_frequency_stiffness") ? breakFrequencyForHighStiffness(specification)
                                                                      : breakFrequencyForLossAngle(specification);
    stiffness = maxwellStiffness(specification, break_frequency);
  }
  return {{"spring", {{"stiffness", {k_st}}}},
          {"maxwell", {{"stiffness", {stiffness}}, {"break_frequency", {break_frequency}}}}};
}

std::vector<element::ElementDescription> estimateMaxwellDashpot(const Specification& specification) {
  const double k_st = specification.at("static_stiffness");
  const double f_n = specification.at("nominal_frequency");
  const double f_b = specification.at("break_frequency");
  const std::complex<double> dynamic = std::polar(specification.at("dynamic_stiffness"), lossAngle(specification));
  const double storage = dynamic.real() - k_st;              // storage stiffness of the Maxwell element
  const double loss = dynamic.imag() - storage * f_b / f_n;  // loss stiffness of the dashpot
  const double stiffness = storage * (1.0 + (f_b / f_n) * (f_b / f_n));
  return {{"spring", {{"stiffness", {k_st}}}},
          {"maxwell", {{"stiffness", {stiffness}}, {"break_frequency", {f_b}}}},
          {"dashpot", {{"damping", {loss / (2.0 * element::kPi * f_n)}}}}};
}

}  // namespace rubber_suspension::estimation
