// M2 with n_M Maxwell elements from five inputs.
// Source: Polach (IAVSD 2015), Eqs. 17 to 22. Eq. 22 is illegible in the source; f_l = n_M f_h/10^(n_M - 1) is a
// reconstruction, the reading that keeps its symbols and agrees with the text around Fig. 8.
#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <complex>
#include <limits>

#include "models.h"

namespace rubber_suspension {
namespace {

using Complex = std::complex<double>;

// Keeps the roots away from alpha = 0 and infinity, where some elements vanish.
constexpr double kMargin = 1e-9;
// Steps of the scan for a high frequency that gives a loss angle.
constexpr int kBandSteps = 60;

int elementCount(const Specification& specification) {
  return static_cast<int>(valueOrDefault(specification, "maxwell_elements"));
}

// Eq. 22 as reconstructed, unless the user gives f_l.
double lowFrequency(const Specification& specification, double high_frequency) {
  const int count = elementCount(specification);
  return specification.valueOr("low_frequency", count * high_frequency / std::pow(10.0, count - 1));
}

// Eq. 17: arithmetic means of the edges of n_M bands that are equal on a log axis over [f_l, f_h].
std::vector<double> breakFrequencies(const Specification& specification, double high_frequency) {
  const int count = elementCount(specification);
  const double low_frequency = lowFrequency(specification, high_frequency);
  const double q = std::pow(high_frequency / low_frequency, 1.0 / count);
  std::vector<double> frequencies(count);
  for (int i = 0; i < count; ++i) {
    frequencies[i] = low_frequency * std::pow(q, i) * 0.5 * (1.0 + q);
  }
  return frequencies;
}

// Eq. 18: shares alpha^(n_M - i)/sum of alpha^(j - 1), `visit` gets each with the index of its element. Powers of what
// is at most 1, from the element with the largest share on, so that none overflows.
template <class Visit>
void forEachShare(double alpha, std::size_t count, Visit visit) {
  const bool rising = alpha < 1.0;  // the last element has the largest share
  const double ratio = rising ? alpha : 1.0 / alpha;
  double sum = 0.0;
  double power = 1.0;
  for (std::size_t i = 0; i < count; ++i, power *= ratio) {
    sum += power;
  }
  power = 1.0;
  for (std::size_t i = 0; i < count; ++i, power *= ratio) {
    visit(rising ? count - 1 - i : i, power / sum);
  }
}

// K* over k of each Maxwell element at a frequency.
std::vector<Complex> relativeStiffnesses(const std::vector<double>& break_frequencies, double frequency) {
  std::vector<Complex> stiffness(break_frequencies.size());
  std::transform(break_frequencies.begin(), break_frequencies.end(), stiffness.begin(), [&](double break_frequency) {
    const double ratio = frequency / break_frequency;
    const double storage = ratio * ratio / (1.0 + ratio * ratio);
    return Complex(storage, ratio / (1.0 + ratio * ratio));
  });
  return stiffness;
}

// K* of all Maxwell elements over the sum of their stiffnesses, from those of each.
Complex relativeStiffness(double alpha, const std::vector<Complex>& of_each) {
  Complex sum = 0.0;
  forEachShare(alpha, of_each.size(), [&](std::size_t i, double share) { sum += share * of_each[i]; });
  return sum;
}

// alpha at which an increasing function of it vanishes.
template <class Function>
double solveAlpha(Function function) {
  boost::uintmax_t iterations = 200;
  const auto bracket = boost::math::tools::bracket_and_solve_root(
      function, 1.0, 8.0, true, boost::math::tools::eps_tolerance<double>(50), iterations);
  return 0.5 * (bracket.first + bracket.second);
}

// A frequency within the elements' break frequencies: then alpha can weight them to act like one element there.
bool embraces(const std::vector<double>& break_frequencies, double frequency) {
  return break_frequencies.front() * (1.0 + kMargin) < frequency &&
         frequency < break_frequencies.back() * (1.0 - kMargin);
}

// The solved model in the terms of Eqs. 17 to 19.
struct Solution {
  double high_frequency;
  double maximum_stiffness;
  double alpha;
};

// |K*(f_n)| = K_n over alpha, Eqs. 20 and 21; the stiffness rises with alpha, so the root is the only one.
double alphaForStiffness(const Specification& specification, double high_frequency) {
  const double k_st = specification.at("static_stiffness");
  const double added = specification.at("maximum_stiffness") - k_st;
  const double target = specification.at("dynamic_stiffness");
  const std::vector<Complex> of_each =
      relativeStiffnesses(breakFrequencies(specification, high_frequency), specification.at("nominal_frequency"));
  return solveAlpha([&](double alpha) { return std::abs(k_st + added * relativeStiffness(alpha, of_each)) - target; });
}

// Loss angle at f_n of the model with this high frequency that meets K_n and K_max.
double angleForBand(const Specification& specification, double high_frequency) {
  const double k_st = specification.at("static_stiffness");
  const double alpha = alphaForStiffness(specification, high_frequency);
  const std::vector<Complex> of_each =
      relativeStiffnesses(breakFrequencies(specification, high_frequency), specification.at("nominal_frequency"));
  return std::arg(k_st + (specification.at("maximum_stiffness") - k_st) * relativeStiffness(alpha, of_each));
}

// The working point has to lie in the band that a user gives. A low frequency from Eq. 22 is but a means to place the
// elements; whether they can meet the working point is judged by their break frequencies.
bool bandIsOrdered(const Specification& specification, double high_frequency) {
  const double f_n = specification.at("nominal_frequency");
  return f_n < high_frequency && (!specification.has("low_frequency") || specification.at("low_frequency") < f_n);
}

bool bandMeetsStiffness(const Specification& specification, double high_frequency) {
  return bandIsOrdered(specification, high_frequency) &&
         embraces(breakFrequencies(specification, high_frequency), breakFrequencyForMaximum(specification));
}

// The lowest high frequency at which the model that meets K_n and K_max has the loss angle too. Where elements lie
// closer the loss is spread wider and is lower, so two bands often meet it; the narrower one has the smoother curves.
std::optional<double> highFrequencyForAngle(const Specification& specification) {
  const double f_n = specification.at("nominal_frequency");
  const double target = lossAngle(specification);
  const auto mismatch = [&](double log_ratio) {
    return angleForBand(specification, f_n * std::exp(log_ratio)) - target;
  };
  // The elements reach down to about f_l/2 and the band is at most as wide as Eq. 22 or 10^4 f_n makes it.
  const double widest = std::log(1e4);
  double before = 0.0;
  double mismatch_before = std::numeric_limits<double>::quiet_NaN();  // compares false with anything
  for (int i = 1; i <= kBandSteps; ++i) {
    const double log_ratio = widest * i / kBandSteps;
    const bool possible = bandMeetsStiffness(specification, f_n * std::exp(log_ratio));
    const double mismatch_now = possible ? mismatch(log_ratio) : std::numeric_limits<double>::quiet_NaN();
    if (mismatch_before * mismatch_now <= 0.0) {
      boost::uintmax_t iterations = 100;
      const auto bracket = boost::math::tools::toms748_solve(mismatch, before, log_ratio, mismatch_before, mismatch_now,
                                                             boost::math::tools::eps_tolerance<double>(50), iterations);
      return f_n * std::exp(0.5 * (bracket.first + bracket.second));
    }
    before = log_ratio;
    mismatch_before = mismatch_now;
  }
  return std::nullopt;
}

Solution solveForMaximum(const Specification& specification) {
  const double f_n = specification.at("nominal_frequency");
  const double high_frequency = specification.at("high_frequency");
  const std::vector<Complex> of_each = relativeStiffnesses(breakFrequencies(specification, high_frequency), f_n);
  // Loss over storage of the elements is the mean of f_b/f_n weighted by their storage; it falls with alpha.
  const double ratio = breakFrequencyForLossAngle(specification) / f_n;
  const double alpha = solveAlpha([&](double trial) {
    const Complex relative = relativeStiffness(trial, of_each);
    return ratio - relative.imag() / relative.real();
  });
  const Complex dynamic = std::polar(specification.at("dynamic_stiffness"), lossAngle(specification));
  const double k_st = specification.at("static_stiffness");
  const double added = (dynamic.real() - k_st) / relativeStiffness(alpha, of_each).real();
  return {high_frequency, k_st + added, alpha};
}

Solution solve(const Specification& specification) {
  if (!specification.has("maximum_stiffness")) {
    return solveForMaximum(specification);
  }
  const double high_frequency = specification.has("high_frequency") ? specification.at("high_frequency")
                                                                    : highFrequencyForAngle(specification).value();
  return {high_frequency, specification.at("maximum_stiffness"), alphaForStiffness(specification, high_frequency)};
}

std::optional<Obstacle> orderObstacle(const Specification& specification) {
  const double high_frequency = specification.at("high_frequency");
  if (specification.at("nominal_frequency") >= high_frequency) {
    return Obstacle{"nominal_frequency", "is not below " + inputText(specification, "high_frequency")};
  }
  if (bandIsOrdered(specification, high_frequency)) {
    return std::nullopt;
  }
  return Obstacle{"low_frequency", "is not below " + inputText(specification, "nominal_frequency")};
}

Obstacle notEmbraced(const std::string& key, const Specification& specification, double frequency) {
  const std::vector<double> b = breakFrequencies(specification, specification.at("high_frequency"));
  return {key,
          fmt::format("needs a break frequency of {:.6g} Hz on average, which is outside those of the {} elements, "
                      "{:.6g} to {:.6g} Hz",
                      frequency, b.size(), b.front(), b.back())};
}

std::optional<Obstacle> stiffnessTargetObstacle(const Specification& specification) {
  if (auto obstacle = orderObstacle(specification)) {
    return obstacle;
  }
  const double frequency = breakFrequencyForMaximum(specification);
  if (embraces(breakFrequencies(specification, specification.at("high_frequency")), frequency)) {
    return std::nullopt;
  }
  return notEmbraced("dynamic_stiffness", specification, frequency);
}

std::optional<Obstacle> angleTargetObstacle(const Specification& specification) {
  if (auto obstacle = orderObstacle(specification)) {
    return obstacle;
  }
  if (auto obstacle = storageObstacle(specification)) {
    return obstacle;
  }
  const double frequency = breakFrequencyForLossAngle(specification);
  if (embraces(breakFrequencies(specification, specification.at("high_frequency")), frequency)) {
    return std::nullopt;
  }
  return notEmbraced("loss_angle", specification, frequency);
}

}  // namespace

std::optional<Obstacle> multiMaxwellObstacle(const Specification& specification) {
  if (!specification.has("loss_angle")) {
    return stiffnessTargetObstacle(specification);
  }
  if (!specification.has("maximum_stiffness")) {
    return angleTargetObstacle(specification);
  }
  if (highFrequencyForAngle(specification)) {
    return std::nullopt;
  }
  return Obstacle{"loss_angle",
                  fmt::format("is not reached with the other inputs by {} elements, whatever the high "
                              "frequency above {}",
                              elementCount(specification), inputText(specification, "nominal_frequency"))};
}

Band multiMaxwellBand(const Specification& specification) {
  const double high_frequency = solve(specification).high_frequency;
  return {lowFrequency(specification, high_frequency), high_frequency};
}

std::vector<ElementDescription> estimateMultiMaxwell(const Specification& specification) {
  const Solution solution = solve(specification);
  const double k_st = specification.at("static_stiffness");
  const std::vector<double> break_frequencies = breakFrequencies(specification, solution.high_frequency);
  std::vector<ElementDescription> elements(1 + break_frequencies.size());
  elements[0].type = "spring";
  elements[0].values["stiffness"] = {k_st};
  forEachShare(solution.alpha, break_frequencies.size(), [&](std::size_t i, double share) {
    ElementDescription& element = elements[1 + i];
    element.type = "maxwell";
    element.values["stiffness"] = {share * (solution.maximum_stiffness - k_st)};
    element.values["break_frequency"] = {break_frequencies[i]};
  });
  return elements;
}

}  // namespace rubber_suspension
