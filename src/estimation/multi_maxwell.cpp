// M2 with n_M Maxwell elements from five inputs. Source: Polach (IAVSD 2015), Eqs. 17 to 22. Eq. 22 is illegible in the
// source; f_l = n_M f_h/10^(n_M - 1) is reconstructed from its symbols and agrees with the text around Fig. 8.
#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <complex>
#include <limits>
#include <optional>
#include <utility>

#include "estimation/models.h"
#include "estimation/root.h"

namespace rubber_suspension::estimation {
namespace {

using Complex = std::complex<double>;

// Margin of the roots from alpha = 0 and infinity, where some elements vanish.
constexpr double kBandMargin = 1e-9;
// Relative margin at the limits of the search for K_max, where alpha reaches its limits.
constexpr double kEndMargin = 1e-6;
// Steps of the scan for the f_h that gives the loss angle.
constexpr int kBandSteps = 60;

// The inputs of the specification, which are looked up only once.
struct Inputs {
  const Specification& specification;  // source of inputs that are used once, and of messages
  double static_stiffness;
  double dynamic_stiffness;
  double nominal_frequency;
  std::optional<double> maximum_stiffness;
  std::optional<double> high_frequency;
  std::optional<double> low_frequency;
  std::optional<double> loss_angle;
  int elements;

  explicit Inputs(const Specification& given)
      : specification(given),
        static_stiffness(given.at("static_stiffness")),
        dynamic_stiffness(given.at("dynamic_stiffness")),
        nominal_frequency(given.at("nominal_frequency")),
        maximum_stiffness(given.find("maximum_stiffness")),
        high_frequency(given.find("high_frequency")),
        low_frequency(given.find("low_frequency")),
        loss_angle(given.find("loss_angle")),
        elements(static_cast<int>(valueOrDefault(given, "maxwell_elements"))) {}
};

// Returns f_l from the user, or else from Eq. 22 as reconstructed.
double lowFrequency(const Inputs& inputs, double high_frequency) {
  const int count = inputs.elements;
  return inputs.low_frequency ? *inputs.low_frequency : count * high_frequency / std::pow(10.0, count - 1);
}

// Returns the break frequencies (Eq. 17): arithmetic means of the limits of n_M bands of equal width on a log axis.
std::vector<double> breakFrequencies(const Inputs& inputs, double high_frequency) {
  const double low_frequency = lowFrequency(inputs, high_frequency);
  const double q = std::pow(high_frequency / low_frequency, 1.0 / inputs.elements);
  std::vector<double> frequencies(static_cast<std::size_t>(inputs.elements));
  double edge = low_frequency;
  for (double& frequency : frequencies) {
    frequency = edge * 0.5 * (1.0 + q);
    edge *= q;
  }
  return frequencies;
}

// Calls `visit` with index and share of each element, alpha^(n_M - i)/sum of alpha^(j - 1) (Eq. 18). It begins with the
// largest share, so that powers of a ratio of at most 1 cannot overflow.
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

// Returns K*/k of each Maxwell element with stiffness k at a frequency.
std::vector<Complex> relativeStiffnesses(const std::vector<double>& break_frequencies, double frequency) {
  std::vector<Complex> stiffness(break_frequencies.size());
  std::transform(break_frequencies.begin(), break_frequencies.end(), stiffness.begin(), [&](double break_frequency) {
    const double ratio = frequency / break_frequency;
    const double storage = ratio * ratio / (1.0 + ratio * ratio);
    return Complex(storage, ratio / (1.0 + ratio * ratio));
  });
  return stiffness;
}

// Returns K* of all Maxwell elements over the sum of their stiffnesses, from K*/k of each element.
Complex relativeStiffness(double alpha, const std::vector<Complex>& of_each) {
  Complex sum = 0.0;
  forEachShare(alpha, of_each.size(), [&](std::size_t i, double share) { sum += share * of_each[i]; });
  return sum;
}

// Returns true if alpha can make the elements act like one, because the frequency is between their break frequencies.
bool embraces(const std::vector<double>& break_frequencies, double frequency) {
  return break_frequencies.front() * (1.0 + kBandMargin) < frequency &&
         frequency < break_frequencies.back() * (1.0 - kBandMargin);
}

// Solved values of the quantities in Eqs. 17 to 19.
struct Solution {
  double high_frequency;
  std::vector<double> break_frequencies;
  double maximum_stiffness;
  double alpha;
};

// Returns the relative stiffness and its derivative with respect to ln(alpha).
std::pair<Complex, Complex> relativeStiffnessWithSlope(double alpha, const std::vector<Complex>& of_each) {
  Complex sum = 0.0;
  Complex moment = 0.0;
  double mean_exponent = 0.0;
  forEachShare(alpha, of_each.size(), [&](std::size_t i, double share) {
    const auto exponent = static_cast<double>(of_each.size() - 1 - i);
    sum += share * of_each[i];
    moment += exponent * share * of_each[i];
    mean_exponent += exponent * share;
  });
  return {sum, moment - mean_exponent * sum};
}

// Solves |K*(f_n)| = K_n for alpha (Eqs. 20 and 21). The root is unique, because the stiffness increases with alpha.
// Newton's method is applied to |K*|^2 as a function of ln(alpha), within bounds.
double alphaForStiffness(const Inputs& inputs, const std::vector<double>& break_frequencies) {
  constexpr double kWidest = 60.0;  // limit of ln(alpha); shares down to kBandMargin need at most 21
  constexpr int kDigits = 50;
  const double k_st = inputs.static_stiffness;
  const double added = inputs.maximum_stiffness.value() - k_st;
  const double target = inputs.dynamic_stiffness;
  const std::vector<Complex> of_each = relativeStiffnesses(break_frequencies, inputs.nominal_frequency);
  boost::uintmax_t iterations = 200;
  const double root = boost::math::tools::newton_raphson_iterate(
      [&](double log_alpha) {
        const auto [relative, slope] = relativeStiffnessWithSlope(std::exp(log_alpha), of_each);
        const Complex stiffness = k_st + added * relative;
        return std::make_pair(std::norm(stiffness) - target * target,
                              2.0 * added * (stiffness.real() * slope.real() + stiffness.imag() * slope.imag()));
      },
      0.0, -kWidest, kWidest, kDigits, iterations);
  return std::exp(root);
}

// Returns the loss angle at f_n of the model with the given f_h that meets K_n and K_max.
double angleForBand(const Inputs& inputs, double high_frequency) {
  const double k_st = inputs.static_stiffness;
  const std::vector<double> break_frequencies = breakFrequencies(inputs, high_frequency);
  const double alpha = alphaForStiffness(inputs, break_frequencies);
  const std::vector<Complex> of_each = relativeStiffnesses(break_frequencies, inputs.nominal_frequency);
  return std::arg(k_st + (inputs.maximum_stiffness.value() - k_st) * relativeStiffness(alpha, of_each));
}

// Returns true if f_n lies below f_h and, if the user gives f_l, above f_l. An f_l from Eq. 22 only places the
// elements, whose break frequencies decide whether they can meet the working point.
bool bandIsOrdered(const Inputs& inputs, double high_frequency) {
  const double f_n = inputs.nominal_frequency;
  return f_n < high_frequency && (!inputs.low_frequency.has_value() || inputs.low_frequency.value() < f_n);
}

bool bandMeetsStiffness(const Inputs& inputs, double high_frequency) {
  return bandIsOrdered(inputs, high_frequency) &&
         embraces(breakFrequencies(inputs, high_frequency), breakFrequencyForMaximum(inputs.specification));
}

// Returns the lowest f_h with which the model that meets K_n and K_max also has the loss angle. Often two values of f_h
// do; the narrower band has the smoother curves.
std::optional<double> highFrequencyForAngle(const Inputs& inputs) {
  const double f_n = inputs.nominal_frequency;
  const double target = lossAngle(inputs.specification);
  const auto mismatch = [&](double log_ratio) {
    const double high_frequency = f_n * std::exp(log_ratio);
    return bandMeetsStiffness(inputs, high_frequency) ? angleForBand(inputs, high_frequency) - target
                                                      : std::numeric_limits<double>::quiet_NaN();
  };
  // The elements extend down to about f_l/2. The band is at most as wide as Eq. 22 or 10^4 f_n makes it.
  const auto root = lowestRoot(mismatch, 0.0, std::log(1e4), kBandSteps);
  return root ? std::make_optional(f_n * std::exp(*root)) : std::nullopt;
}

Solution solveForMaximum(const Inputs& inputs) {
  const double f_n = inputs.nominal_frequency;
  const double high_frequency = inputs.high_frequency.value();
  std::vector<double> break_frequencies = breakFrequencies(inputs, high_frequency);
  const std::vector<Complex> of_each = relativeStiffnesses(break_frequencies, f_n);
  // The ratio of loss to storage of all elements, the mean of f_b/f_n weighted by storage, decreases with alpha.
  const double ratio = breakFrequencyForLossAngle(inputs.specification) / f_n;
  const double alpha = increasingRoot([&](double trial) {
    const Complex relative = relativeStiffness(trial, of_each);
    return ratio - relative.imag() / relative.real();
  });
  const Complex dynamic = std::polar(inputs.dynamic_stiffness, lossAngle(inputs.specification));
  const double k_st = inputs.static_stiffness;
  const double added = (dynamic.real() - k_st) / relativeStiffness(alpha, of_each).real();
  return {high_frequency, std::move(break_frequencies), k_st + added, alpha};
}

// Returns K_max for which the model that meets K_n has the specified stiffness at f_h, which increases with K_max. The
// limits of K_max are those of one Maxwell element with the first or the last break frequency.
double maximumForHighStiffness(Inputs inputs) {
  const double k_st = inputs.static_stiffness;
  const double high_frequency = inputs.high_frequency.value();
  const std::vector<double> break_frequencies = breakFrequencies(inputs, high_frequency);
  const double target = inputs.specification.at("high_frequency_stiffness");
  const std::vector<Complex> of_each_high = relativeStiffnesses(break_frequencies, high_frequency);
  const auto mismatch = [&](double maximum) {
    inputs.maximum_stiffness = maximum;
    const double alpha = alphaForStiffness(inputs, break_frequencies);
    return std::abs(k_st + (maximum - k_st) * relativeStiffness(alpha, of_each_high)) - target;
  };
  const auto maximumOfOne = [&](double break_frequency) {
    const double ratio = break_frequency / inputs.nominal_frequency;
    const double added = (inputs.dynamic_stiffness - k_st) * (inputs.dynamic_stiffness + k_st) * ratio * ratio;
    return std::sqrt(inputs.dynamic_stiffness * inputs.dynamic_stiffness + added);
  };
  const double lowest = maximumOfOne(break_frequencies.front() * (1.0 + kEndMargin));
  const double highest = maximumOfOne(break_frequencies.back() * (1.0 - kEndMargin));
  return rootBetween(mismatch, lowest, highest, mismatch(lowest), mismatch(highest));
}

Solution solve(Inputs inputs) {
  if (inputs.specification.has("high_frequency_stiffness")) {
    inputs.maximum_stiffness = maximumForHighStiffness(inputs);
  } else if (!inputs.maximum_stiffness.has_value()) {
    return solveForMaximum(inputs);
  }
  const double high_frequency =
      inputs.high_frequency.has_value() ? inputs.high_frequency.value() : highFrequencyForAngle(inputs).value();
  std::vector<double> break_frequencies = breakFrequencies(inputs, high_frequency);
  const double alpha = alphaForStiffness(inputs, break_frequencies);
  return {high_frequency, std::move(break_frequencies), inputs.maximum_stiffness.value(), alpha};
}

std::optional<Obstacle> orderObstacle(const Inputs& inputs) {
  const double high_frequency = inputs.high_frequency.value();
  if (inputs.nominal_frequency >= high_frequency) {
    return Obstacle{"nominal_frequency", "is not below " + inputText(inputs.specification, "high_frequency")};
  }
  if (bandIsOrdered(inputs, high_frequency)) {
    return std::nullopt;
  }
  return Obstacle{"low_frequency", "is not below " + inputText(inputs.specification, "nominal_frequency")};
}

// Checks that the break frequency of an equivalent single element lies between the break frequencies of the elements.
std::optional<Obstacle> spreadObstacle(const std::string& key, const Inputs& inputs, double frequency) {
  const std::vector<double> b = breakFrequencies(inputs, inputs.high_frequency.value());
  if (embraces(b, frequency)) {
    return std::nullopt;
  }
  return Obstacle{key,
                  fmt::format("needs a mean break frequency of {:.6g} Hz, but the {} elements have {:.6g} to {:.6g} Hz",
                              frequency, b.size(), b.front(), b.back())};
}

std::optional<Obstacle> highStiffnessObstacle(const Inputs& inputs) {
  for (auto obstacle : {highFrequencyObstacle(inputs.specification), orderObstacle(inputs)}) {
    if (obstacle) {
      return obstacle;
    }
  }
  const std::vector<double> b = breakFrequencies(inputs, inputs.high_frequency.value());
  const double low = highStiffnessOfOne(inputs.specification, b.front() * (1.0 + 20.0 * kEndMargin));
  const double high = highStiffnessOfOne(inputs.specification, b.back() * (1.0 - 20.0 * kEndMargin));
  const double target = inputs.specification.at("high_frequency_stiffness");
  if (low < target && target < high) {
    return std::nullopt;
  }
  const WrittenUnit unit = inputs.specification.writtenUnit("high_frequency_stiffness");
  return Obstacle{
      "high_frequency_stiffness",
      fmt::format("cannot be reached with {} elements that meet K_n; such elements have {:.6g} to {:.6g} {}", b.size(),
                  low / unit.size, high / unit.size, unit.name)};
}

std::optional<Obstacle> highFrequencyForAngleObstacle(const Inputs& inputs) {
  if (highFrequencyForAngle(inputs)) {
    return std::nullopt;
  }
  return Obstacle{"loss_angle",
                  fmt::format("cannot be reached with {} elements and the other inputs at any high_frequency above {}",
                              inputs.elements, inputText(inputs.specification, "nominal_frequency"))};
}

}  // namespace

std::optional<Obstacle> multiMaxwellObstacle(const Specification& specification) {
  const Inputs inputs(specification);
  if (specification.has("high_frequency_stiffness")) {
    return highStiffnessObstacle(inputs);
  }
  if (inputs.loss_angle && inputs.maximum_stiffness) {
    return highFrequencyForAngleObstacle(inputs);
  }
  if (auto obstacle = orderObstacle(inputs)) {
    return obstacle;
  }
  if (!inputs.loss_angle) {
    return spreadObstacle("dynamic_stiffness", inputs, breakFrequencyForMaximum(specification));
  }
  if (auto obstacle = storageObstacle(specification)) {
    return obstacle;
  }
  return spreadObstacle("loss_angle", inputs, breakFrequencyForLossAngle(specification));
}

Band multiMaxwellBand(const Specification& given) {
  const Specification specification = tangentOf(Model::multi_maxwell, given);
  const Inputs inputs(specification);
  const double high_frequency = solve(inputs).high_frequency;
  return {lowFrequency(inputs, high_frequency), high_frequency};
}

namespace {

std::vector<element::ElementDescription> maxwellElements(const std::vector<double>& break_frequencies, double relaxing,
                                                         double alpha) {
  std::vector<element::ElementDescription> elements(break_frequencies.size());
  const auto add = [](element::ElementDescription& element, const char* last_name, double value) {
    element.values.emplace_hint(element.values.end(), last_name, std::vector<double>(1, value));
  };
  forEachShare(alpha, break_frequencies.size(), [&](std::size_t i, double share) {
    elements[i].type = "maxwell";
    add(elements[i], "break_frequency", break_frequencies[i]);
    add(elements[i], "stiffness", share * relaxing);
  });
  return elements;
}

}  // namespace

std::vector<element::ElementDescription> multiMaxwellElements(const Specification& band, double relaxing,
                                                              double alpha) {
  Specification specification = band;
  for (const char* key : {"static_stiffness", "dynamic_stiffness", "nominal_frequency"}) {
    specification.set(key, 0.0);  // any value, because it is not used
  }
  const Inputs inputs(specification);
  return maxwellElements(breakFrequencies(inputs, band.at("high_frequency")), relaxing, alpha);
}

std::vector<element::ElementDescription> estimateMultiMaxwell(const Specification& specification) {
  const Inputs inputs(specification);
  const Solution solution = solve(inputs);
  const double k_st = inputs.static_stiffness;
  std::vector<element::ElementDescription> elements =
      maxwellElements(solution.break_frequencies, solution.maximum_stiffness - k_st, solution.alpha);
  elements.insert(elements.begin(), {"spring", {{"stiffness", {k_st}}}});
  return elements;
}

}  // namespace rubber_suspension::estimation
