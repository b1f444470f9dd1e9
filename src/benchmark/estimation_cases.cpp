// Estimation from five inputs against the same sums written by hand with no object around them.
#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <complex>
#include <memory>

#include "benchmark/cases.h"
#include "rubber_suspension/component/component.h"
#include "rubber_suspension/estimation/specification.h"
#include "rubber_suspension/response/sweep.h"

namespace rubber_suspension::benchmark {
namespace {

// The example of O. Polach, "Modelling of rubber components using estimated parameters" (IAVSD 2015).
constexpr double kStaticStiffness = 3.0e6;   // [N/m]
constexpr double kDynamicStiffness = 4.2e6;  // [N/m]
constexpr double kNominalFrequency = 4.0;    // [Hz]
constexpr double kMaximumStiffness = 4.9e6;  // [N/m]
constexpr double kHighFrequency = 25.0;      // [Hz]
constexpr int kElements = 5;

struct FiveInputs {
  double break_frequency[kElements] = {};
  double stiffness[kElements] = {};
};

// Polach Eqs. 17 to 22, with f_l = n_M f_h/10^(n_M - 1).
void solveByHand(FiveInputs& result) {
  const double low = kElements * kHighFrequency / std::pow(10.0, kElements - 1);
  const double q = std::pow(kHighFrequency / low, 1.0 / kElements);
  std::complex<double> relative[kElements];
  double edge = low;
  for (int i = 0; i < kElements; ++i, edge *= q) {
    result.break_frequency[i] = 0.5 * edge * (1.0 + q);
    const std::complex<double> ratio(0.0, kNominalFrequency / result.break_frequency[i]);
    relative[i] = ratio / (1.0 + ratio);
  }
  const auto weigh = [&](double alpha) {
    double share = 1.0;
    double sum = 0.0;
    for (int i = kElements - 1; i >= 0; --i, share *= alpha) {
      result.stiffness[i] = share * (kMaximumStiffness - kStaticStiffness);
      sum += share;
    }
    std::complex<double> total = kStaticStiffness;
    for (int i = 0; i < kElements; ++i) {
      result.stiffness[i] /= sum;
      total += result.stiffness[i] * relative[i];
    }
    return std::abs(total) - kDynamicStiffness;
  };
  boost::uintmax_t iterations = 100;
  const auto bracket =
      boost::math::tools::toms748_solve(weigh, 0.1, 10.0, boost::math::tools::eps_tolerance<double>(50), iterations);
  weigh(0.5 * (bracket.first + bracket.second));
}

// K* of the estimated elements against that of the solution by hand, over frequency.
double estimationError(const FiveInputs& bare, const std::vector<element::ElementDescription>& elements) {
  const component::Component component(elements);
  double error = 0.0;
  for (const double frequency : response::logSpaced(0.01, 100.0, 50)) {
    std::complex<double> expected = kStaticStiffness;
    for (int i = 0; i < kElements; ++i) {
      const std::complex<double> ratio(0.0, frequency / bare.break_frequency[i]);
      expected += bare.stiffness[i] * ratio / (1.0 + ratio);
    }
    error = std::max(error, std::abs(component.complexStiffness(frequency).value() - expected) / std::abs(expected));
  }
  return error;
}

struct Bench {
  static constexpr int kRuns = 100;  // so that one run is long against the clock's resolution
  estimation::Specification specification;
  FiveInputs bare;
  std::vector<element::ElementDescription> library;

  void byHand() {
    for (int i = 0; i < kRuns; ++i) {
      solveByHand(bare);
    }
  }

  void estimate() {
    for (int i = 0; i < kRuns; ++i) {
      library = estimation::estimate(estimation::Model::multi_maxwell, specification);
    }
  }
};

}  // namespace

std::vector<Case> estimationCases(const BenchmarkSize& /*size*/) {
  const auto bench = std::make_shared<Bench>();
  bench->specification.set("static_stiffness", kStaticStiffness);
  bench->specification.set("dynamic_stiffness", kDynamicStiffness);
  bench->specification.set("nominal_frequency", kNominalFrequency);
  bench->specification.set("maximum_stiffness", kMaximumStiffness);
  bench->specification.set("high_frequency", kHighFrequency);
  Case result = caseOf(bench, "estimation from five inputs, checks included", &Bench::estimate, "TOMS 748 alone",
                       &Bench::byHand, "estimation", Bench::kRuns);
  result.error = [bench] { return estimationError(bench->bare, bench->library); };
  result.error_meaning = "of K*";
  result.tolerance = 1e-12;  // both roots are good to 50 bits
  return {result};
}

}  // namespace rubber_suspension::benchmark
