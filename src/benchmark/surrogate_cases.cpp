// A surrogate as a diagnosis writes it, against ten Maxwell elements.
#include <fmt/format.h>

#include "benchmark/bare_loop.h"
#include "benchmark/cases.h"
#include "benchmark/force_case.h"
#include "rubber_suspension/component/component.h"
#include "rubber_suspension/element/residual.h"

namespace rubber_suspension::benchmark {
namespace {

element::ResidualBasis::Layout surrogateLayout(bool resonant) {
  element::ResidualBasis::Layout layout;
  layout.stroke = layout.highest = 2e-3;
  layout.lowest = -2e-3;
  layout.stops = {0.02, 0.04, 0.08, 0.17, 0.34, 0.7};
  layout.times = {8e-3, 0.04, 0.2, 0.8};
  layout.resonant = resonant;
  layout.frequencies = {4.0, 5.2, 6.8, 8.9, 11.7, 15.3, 20.0, 26.0};
  layout.points = 32;
  return layout;
}

std::vector<element::ElementDescription> tenMaxwells() {
  std::vector<element::ElementDescription> elements = elementsOf(bareParameters(10));
  return {elements.begin() + 1, elements.end() - 1};  // without spring and friction
}

struct SurrogateBench {
  element::ResidualBasis basis;
  Eigen::VectorXd weights;
  component::Component surrogate;
  component::Component maxwells;
  std::vector<double> displacement;
  std::vector<double> steps;
  std::vector<double> bare;
  std::vector<double> library;

  SurrogateBench(std::size_t samples, bool even, bool resonant)
      : basis(surrogateLayout(resonant)),
        weights(100.0 * Eigen::ArrayXd::LinSpaced(basis.size(), 1.0, 2.0 * static_cast<double>(basis.size())).cos()),
        surrogate({element::residualDescription(basis, weights, -1e6, 1e6)}),
        maxwells(tenMaxwells()),
        displacement(benchmarkDisplacement(samples)),
        steps(stepsOf(even ? evenStamps(samples) : unevenStamps(samples))),
        bare(samples),
        library(samples) {}

  void stepThrough(const component::Component& component, std::vector<double>& force) const {
    component::ComponentState state = component.makeState();
    force[0] = component.initialise(state, displacement[0]).total;
    for (std::size_t i = 1; i < displacement.size(); ++i) {
      force[i] = component.step(state, steps[i], displacement[i]).total;
    }
  }

  // Against the sum over all functions, one by one.
  double error() {
    stepThrough(surrogate, library);
    std::vector<double> memory(element::ResidualBasis::kMemorySize);
    Eigen::VectorXd values(basis.size());
    basis.initialise(displacement[0], memory.data());
    bare[0] = library[0];
    for (std::size_t i = 1; i < displacement.size(); ++i) {
      basis.advance({steps[i], displacement[i], displacement[i] - displacement[i - 1]}, memory.data());
      basis.evaluate(memory.data(), values);
      bare[i] = weights.dot(values);
    }
    return relativeDifference(bare, library);
  }
};

Case surrogateCase(std::size_t samples, bool even, bool resonant) {
  const auto bench = std::make_shared<SurrogateBench>(samples, even, resonant);
  Case result = forceCase(
      bench,
      fmt::format("`Component::step`, {}, a surrogate{}", even ? "constant dt" : "every dt another",
                  resonant ? " with resonators" : ""),
      [](SurrogateBench& sides) { sides.stepThrough(sides.surrogate, sides.library); },
      "`Component::step`, ten Maxwell elements alone",
      [](SurrogateBench& sides) { sides.stepThrough(sides.maxwells, sides.bare); });
  result.error = [bench] { return bench->error(); };
  result.error_meaning = "of the largest force, against its functions one by one";
  return result;
}

}  // namespace

std::vector<Case> surrogateCases(const BenchmarkSize& size) {
  return {surrogateCase(size.samples, true, false), surrogateCase(size.samples, true, true),
          surrogateCase(size.samples, false, false), surrogateCase(size.samples, false, true)};
}

}  // namespace rubber_suspension::benchmark
