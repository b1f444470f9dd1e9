// Estimation from five inputs, and the table of stiffness and loss angle of Berg's model, each against the same sums
// written by hand with no object around them.
#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <complex>
#include <memory>

#include "benchmark/bare_loop.h"
#include "benchmark/cases.h"
#include "rubber_suspension/component/component.h"
#include "rubber_suspension/element/constants.h"
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
constexpr double kAmplitude = 2e-3;          // of the table [m]
constexpr int kElements = 5;

struct FiveInputs {
  double alpha = 0.0;
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
  result.alpha = 0.5 * (bracket.first + bracket.second);
  weigh(result.alpha);
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

Case estimationCase() {
  constexpr int kRuns = 100;  // so that one run is long against the clock's resolution
  struct Bench {
    estimation::Specification specification;
    FiveInputs bare;
    std::vector<element::ElementDescription> library;
  };
  const auto bench = std::make_shared<Bench>();
  bench->specification.set("static_stiffness", kStaticStiffness);
  bench->specification.set("dynamic_stiffness", kDynamicStiffness);
  bench->specification.set("nominal_frequency", kNominalFrequency);
  bench->specification.set("maximum_stiffness", kMaximumStiffness);
  bench->specification.set("high_frequency", kHighFrequency);
  Case result;
  result.name = "estimation from five inputs, checks included";
  result.baseline = "TOMS 748 alone";
  result.unit = "estimation";
  result.count = result.baseline_count = kRuns;
  result.bare = [bench] {
    for (int i = 0; i < kRuns; ++i) {
      solveByHand(bench->bare);
    }
  };
  result.library = [bench] {
    for (int i = 0; i < kRuns; ++i) {
      bench->library = estimation::estimate(estimation::Model::multi_maxwell, bench->specification);
    }
  };
  result.error = [bench] { return estimationError(bench->bare, bench->library); };
  result.error_meaning = "of K*";
  result.tolerance = 1e-12;  // both roots are good to 50 bits
  return result;
}

// Peak force and loss of the settled loop of friction in closed form (Berg, VSD 30 (1998) 197-212).
double settledFriction(const BareParameters& berg, double amplitude) {
  const double z2 = berg.friction_displacement;
  return berg.maximum_force / (2.0 * z2) *
         (std::sqrt(z2 * z2 + amplitude * amplitude + 6.0 * z2 * amplitude) - z2 - amplitude);
}

double frictionLoss(const BareParameters& berg, double amplitude) {
  const double reach = berg.friction_displacement * (1.0 + settledFriction(berg, amplitude) / berg.maximum_force);
  return 2.0 * berg.maximum_force *
         (2.0 * amplitude - reach * reach / berg.friction_displacement * std::log((reach + 2.0 * amplitude) / reach));
}

// Half a loop is enough by symmetry: the peak of its samples, and the loss in closed form.
response::Characteristics characteristicsByHand(const BareParameters& berg, double frequency, double amplitude) {
  constexpr int kHalf = 360;  // as many samples per cycle as the library takes
  const std::complex<double> ratio(0.0, frequency / berg.break_frequency[0]);
  const std::complex<double> linear = berg.spring + berg.stiffness[0] * ratio / (1.0 + ratio);
  const double settled = settledFriction(berg, amplitude);
  BareFriction friction{-amplitude, -amplitude, -settled, -settled, 1.0};
  double peak = 0.0;
  for (int i = 0; i <= kHalf; ++i) {
    const double phase = element::kPi * i / kHalf;
    const double z = -amplitude * std::cos(phase);
    const double force = linear.real() * z + linear.imag() * amplitude * std::sin(phase) +
                         friction.advance(z, berg.maximum_force, berg.friction_displacement);
    peak = std::max(peak, force);
  }
  response::Characteristics result;
  result.stiffness = peak / amplitude;
  result.loss = element::kPi * amplitude * amplitude * linear.imag() + frictionLoss(berg, amplitude);
  result.loss_angle = std::asin(result.loss / (element::kPi * peak * amplitude));
  return result;
}

double tableError(const std::vector<response::Characteristics>& bare,
                  const std::vector<response::SweepPoint>& library) {
  double error = 0.0;
  for (std::size_t i = 0; i < bare.size(); ++i) {
    const response::Characteristics& actual = library[i].characteristics;
    error = std::max({error, std::abs(actual.stiffness / bare[i].stiffness - 1.0),
                      std::abs(actual.loss_angle / bare[i].loss_angle - 1.0)});
  }
  return error;
}

Case tableCase(const BenchmarkSize& size) {
  struct Bench {
    BareParameters berg = bareParameters(1);
    component::Component component{elementsOf(berg)};
    std::vector<double> frequencies;
    std::vector<response::Characteristics> bare;
    std::vector<response::SweepPoint> library;
  };
  const auto bench = std::make_shared<Bench>();
  bench->frequencies = response::logSpaced(0.1, 50.0, size.frequencies);
  Case result;
  result.name = fmt::format("K and delta of Berg's model over {} frequencies, settled loops", size.frequencies);
  result.baseline = "half loops by hand, loss in closed form";
  result.unit = "table";
  result.bare = [bench] {
    bench->bare.clear();
    for (const double frequency : bench->frequencies) {
      bench->bare.push_back(characteristicsByHand(bench->berg, frequency, kAmplitude));
    }
  };
  result.library = [bench] {
    bench->library = response::sweepFrequency(bench->component, bench->frequencies, kAmplitude);
  };
  result.error = [bench] { return tableError(bench->bare, bench->library); };
  result.error_meaning = "of K or delta";
  // A peak between two of 720 samples is low by up to (pi/720)^2/2 = 1e-5 of the force's second derivative in phase,
  // which is that of the force itself within a small factor.
  result.tolerance = 5e-5;
  return result;
}

}  // namespace

std::vector<Case> estimationCases(const BenchmarkSize& size) { return {estimationCase(), tableCase(size)}; }

}  // namespace rubber_suspension::benchmark
