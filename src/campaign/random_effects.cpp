// A hierarchical model of one number over the components of a type.
#include "campaign/random_effects.h"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/tools/minima.hpp>
#include <cmath>

#include "measurement/statistics.h"

namespace rubber_suspension::campaign {
namespace {

using measurement::kMadToDeviation;

constexpr double kTail = 0.025;          // of a 95 % interval
constexpr double kFalseAlarm = 0.05;     // fleets in which chance alone makes a component stand out
constexpr double kMadEfficiency = 0.37;  // of a scale by the MAD against the standard deviation, normal distribution

struct Weighted {
  double mean = 0.0;
  double weights = 0.0;  // sum of 1/variance
  double q = 0.0;        // sum of squared distances over their variances
  double logarithms = 0.0;
};

Weighted weigh(const std::vector<Observation>& observations, double scatter) {
  const auto variance = [&](const Observation& one) {
    return scatter * scatter + one.standard_error * one.standard_error;
  };
  Weighted result;
  for (const Observation& one : observations) {
    result.weights += 1.0 / variance(one);
    result.mean += one.value / variance(one);
    result.logarithms += std::log(variance(one));
  }
  result.mean /= result.weights;
  for (const Observation& one : observations) {
    result.q += (one.value - result.mean) * (one.value - result.mean) / variance(one);
  }
  return result;
}

double restrictedDeviance(const std::vector<Observation>& observations, double scatter) {
  const Weighted weighted = weigh(observations, scatter);
  return weighted.logarithms + std::log(weighted.weights) + weighted.q;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) {
    return *middle;
  }
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

// A scatter that no fleet of these values exceeds.
double widest(const std::vector<Observation>& observations) {
  const auto [least, most] =
      std::minmax_element(observations.begin(), observations.end(),
                          [](const Observation& a, const Observation& b) { return a.value < b.value; });
  double error = 0.0;
  for (const Observation& one : observations) {
    error = std::max(error, one.standard_error);
  }
  return 10.0 * (most->value - least->value + error);
}

// The scatter at which Q, which falls with it, has this value; 0 where it is less already.
double scatterOfQ(const std::vector<Observation>& observations, double q, double least, double most) {
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (least + most);
    (weigh(observations, middle).q > q ? least : most) = middle;
  }
  return 0.5 * (least + most);
}

double mostLikelyScatter(const std::vector<Observation>& observations, double least, double most) {
  constexpr int kBits = 40;  // of the scatter; more than rounding of the likelihood leaves
  const auto deviance = [&](double scatter) { return restrictedDeviance(observations, scatter); };
  const double inside = boost::math::tools::brent_find_minima(deviance, least, most, kBits).first;
  return deviance(least) <= deviance(inside) ? 0.0 : inside;
}

// Interval and chance of the mean: Student's distribution for its own error, with that of all components on top, which
// more components do not make smaller.
void setMean(RandomEffects& result, double error, double common_error, double degrees) {
  const boost::math::students_t student(degrees);
  const double total = std::hypot(error, common_error);
  const double half = quantile(complement(student, kTail)) * total;
  result.mean_interval = {result.mean - half, result.mean + half};
  const double distance = std::abs(result.mean);
  result.mean_chance = total > 0.0 ? 2.0 * cdf(complement(student, distance / total)) : (distance > 0.0 ? 0.0 : 1.0);
}

void addRobust(const std::vector<Observation>& observations, RandomEffects& result) {
  std::vector<double> values;
  std::vector<double> variances;
  for (const Observation& one : observations) {
    values.push_back(one.value);
    variances.push_back(one.standard_error * one.standard_error);
  }
  result.median = median(values);
  std::vector<double> distances;
  for (const double value : values) {
    distances.push_back(std::abs(value - result.median));
  }
  const double total = kMadToDeviation * median(distances);
  result.robust_scatter = std::sqrt(std::max(0.0, total * total - median(variances)));
  for (const Observation& one : observations) {
    const double deviation = std::hypot(result.robust_scatter, one.standard_error);
    const double distance = one.value - result.median;
    result.robust_z.push_back(deviation > 0.0 ? distance / deviation : 0.0);
  }
  // As many components are tried, and the scale itself is an estimate, worth 37 % of the components.
  const auto count = static_cast<double>(observations.size());
  const boost::math::students_t student(std::max(1.0, kMadEfficiency * (count - 1.0)));
  result.z_limit = quantile(complement(student, kFalseAlarm / (2.0 * count)));
}

}  // namespace

std::optional<RandomEffects> fitRandomEffects(const std::vector<Observation>& observations, double common_error) {
  if (observations.size() < kFewestComponents) {
    return std::nullopt;
  }
  RandomEffects result;
  const double degrees = static_cast<double>(observations.size()) - 1.0;
  addRobust(observations, result);
  const double most = widest(observations);
  if (!(most > 0.0)) {  // all are equal, and exactly known
    result.mean = observations.front().value;
    setMean(result, 0.0, common_error, degrees);
    return result;
  }
  const double least = 1e-9 * most;  // in place of 0, at which an exact estimate would have all the weight
  result.scatter = mostLikelyScatter(observations, least, most);
  const boost::math::chi_squared chi_squared(degrees);
  const double highest_q = weigh(observations, least).q;
  const auto limit = [&](double q) { return highest_q <= q ? 0.0 : scatterOfQ(observations, q, least, most); };
  result.scatter_interval = {limit(quantile(complement(chi_squared, kTail))), limit(quantile(chi_squared, kTail))};
  const Weighted weighted = weigh(observations, std::max(result.scatter, least));
  // Hartung and Knapp's factor, never below 1: a fleet that agrees better than its errors say is luck.
  const double factor = std::max(1.0, weighted.q / degrees);
  result.mean = weighted.mean;
  setMean(result, std::sqrt(factor / weighted.weights), common_error, degrees);
  return result;
}

}  // namespace rubber_suspension::campaign
