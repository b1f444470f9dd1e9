// Residuals of logs and their normal equations.
#include "fit/fitter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "gap/simulate.h"
#include "numerics/symmetric.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::fit {
namespace {

// Returns true if the force of a component, apart from the mean force, depends on the centre of the motion.
bool dependsOnPlace(const std::vector<element::ElementDescription>& elements, const log::Record& record) {
  constexpr Eigen::Index kSamples = 400;
  constexpr double kAside = 0.2;  // share of the amplitude
  constexpr double kMore = 1e-6;  // share of the force; a smaller one is rounding
  log::Record probe;
  probe.dt = record.dt;
  const double largest = record.displacement.cwiseAbs().maxCoeff();
  probe.displacement = largest * Eigen::ArrayXd::LinSpaced(kSamples, 0.0, 4.0 * element::kPi).sin();
  const Eigen::VectorXd here = gap::simulate(elements, {probe}).front();
  probe.displacement.array() += kAside * largest;
  const Eigen::VectorXd aside = gap::simulate(elements, {probe}).front() - here;
  return !((aside.array() - aside.mean()).matrix().norm() <= kMore * here.norm());
}

}  // namespace

Fitter::Fitter(std::shared_ptr<const std::vector<gap::PreparedRecord>> shared, const ModelParameters& model,
               double one_deviation)
    : HypothesisFitter(model, one_deviation), forces_(std::move(shared), model) {
  const auto count = static_cast<double>(records().size());
  std::vector<double> weights;
  for (const gap::PreparedRecord& record : records()) {
    weights.push_back(std::sqrt(record.weight / (record.counted() * count)) / record.force_deviation);
  }
  blocks_ = std::make_unique<const LogBlocks>(records(), std::move(weights));
}

double Fitter::gapOf(const Hypothesis& hypothesis, const gap::Forces& forces) const {
  const PerLogNuisances& free = hypothesis.free_in_log;
  double sum = 0.0;
  for (std::size_t r = 0; r < records().size(); ++r) {
    const Eigen::VectorXd residual = records()[r].withoutRig(records()[r].force - forces[r]);
    const double taken = free.any() ? ownOf(free, r, forces[r], residual).taken : 0.0;
    sum += std::pow(blocks_->weights()[r], 2) * (residual.squaredNorm() - taken);
  }
  return std::isfinite(sum) ? std::sqrt(sum) : std::numeric_limits<double>::infinity();
}

Fitter::Own Fitter::ownOf(const PerLogNuisances& free, std::size_t r, const Eigen::VectorXd& simulated,
                          const Eigen::VectorXd& residual) const {
  const gap::PreparedRecord& record = records()[r];
  auto [columns, penalty] = free.unknowns(record, r, simulated);
  for (Eigen::Index j = 0; j < columns.cols(); ++j) {
    columns.col(j) = record.withoutRig(columns.col(j));
  }
  Eigen::MatrixXd gram = columns.transpose() * columns;
  gram.diagonal().array() += 1e-12 * gram.diagonal().maxCoeff();
  gram.diagonal() += penalty;
  const Eigen::VectorXd moment = columns.transpose() * residual;
  if (!(gram.diagonal().minCoeff() > 0.0)) {
    return {Eigen::VectorXd::Zero(moment.size()), 0.0};
  }
  const Eigen::VectorXd values = numerics::solveSymmetric(gram, moment);
  return {values, moment.dot(values)};
}

void Fitter::freeFactors(const ParameterVector& parameters, Hypothesis& hypothesis) const {
  if (const auto elements = elementsOf(model(), hypothesis, parameters)) {
    hypothesis.free_in_log.by_factor = columnOf(frictionOf(*elements, records()));
  }
}

std::vector<double> Fitter::factors(Hypothesis hypothesis, const ParameterVector& parameters) const {
  const PerLogNuisances& free = hypothesis.free_in_log;
  const auto forces = free.by_factor ? forces_.at(hypothesis, parameters) : std::nullopt;
  if (forces) {
    freeFactors(parameters, hypothesis);
  }
  std::vector<double> factors;
  for (std::size_t r = 0; forces && r < records().size(); ++r) {
    const Eigen::VectorXd residual = records()[r].withoutRig(records()[r].force - (*forces)[r]);
    factors.push_back(1.0 + ownOf(free, r, (*forces)[r], residual).values[free.placeOfFactor()]);
  }
  return factors;
}

void Fitter::freeZeros(const ParameterVector& parameters, Hypothesis& hypothesis) const {
  bool depends = model_depends_on_place_;
  for (std::size_t t = 0; t < hypothesis.terms.size(); ++t) {
    depends =
        depends || (hypothesis.terms[t].depends_on_place && parameters.scales[static_cast<Eigen::Index>(t)] != 0.0);
  }
  const bool known = records().front().rig.one_deviation > 0.0;
  const auto elements = depends && known ? elementsOf(model(), hypothesis, parameters) : std::nullopt;
  if (elements) {
    hypothesis.free_in_log.by_zero = columnOf(byZero(*elements, records()));
  }
}

void Fitter::prepare(std::vector<Candidate>& candidates, int threads) {
  const auto base = *model().elements(Eigen::VectorXd::Zero(model().size()));
  model_depends_on_place_ = dependsOnPlace(base, records().front());
  for (Candidate& candidate : candidates) {
    for (BasisTerm& term : candidate.terms) {
      auto with = base;
      with.push_back(term.at(term.typical));
      term.depends_on_place = model_depends_on_place_ || dependsOnPlace(with, records().front());
    }
  }
  findUnitEffects(candidates, records(), threads);
  std::vector<ForceColumn> columns;
  for (const Candidate& candidate : candidates) {
    for (const BasisTerm& term : candidate.terms) {
      if (term.unit_effect && !term.softening) {
        columns.push_back(term.unit_effect);
      }
    }
  }
  blocks_ = std::make_unique<const LogBlocks>(records(), blocks_->weights(), std::move(columns), threads);
}

}  // namespace rubber_suspension::fit
