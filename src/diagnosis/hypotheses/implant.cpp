// Predicts residuals of added effects by projection.
#include "diagnosis/hypotheses/implant.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "diagnosis/hypotheses/screening.h"
#include "fit/parallel.h"
#include "numerics/bounded_least_squares.h"
#include "numerics/symmetric.h"

namespace rubber_suspension::diagnosis::hypotheses {
namespace {

constexpr std::size_t kMostShapes = 6;  // largest number of forms of an effect, evenly spaced from first to last
constexpr double kNothing = 1e-9;       // gap below which the force of a typical effect is a rounding error

struct Fitted {
  fit::Hypothesis hypothesis;
  std::vector<Eigen::Index> columns;
  std::vector<bool> is_signed;
};

// Normal equations after elimination of the model parameters and of the per-log nuisance parameters `free`.
class Projected {
 public:
  Projected(const fit::HypothesisFitter& fitter, const Screening& screening, const fit::PerLogNuisances& free)
      : departures_(fitter.model().departureSlopes(Eigen::VectorXd::Zero(screening.modelSize()))),
        candidates_(screening.candidates()),
        model_(screening.modelSize()),
        size_(screening.blocks().unknowns()),
        whole_(plainOf(screening.blocks())),
        plain_(plainOf(screening.blocks(free))),
        squares_(screening.blocks().squares) {
    const Eigen::MatrixXd gram = screening.blocks(free).sum.topLeftCorner(size_, size_);
    Eigen::MatrixXd base = gram.topLeftCorner(model_, model_);
    base.diagonal().array() *= 1.0 + 1e-9;  // keeps the matrix regular if the logs do not determine a parameter
    base.diagonal().array() += std::numeric_limits<double>::min();
    taken_ = numerics::solveSymmetric(base, Eigen::MatrixXd(gram.topRows(model_).rightCols(size_ - model_)));
    projected_ =
        gram.bottomRightCorner(size_ - model_, size_ - model_) - gram.bottomLeftCorner(size_ - model_, model_) * taken_;
  }

  // Returns the gap that the force of a basis term causes, including what an error of the rig could explain of it.
  double gapOf(Eigen::Index column) const { return std::sqrt(squares_[column]); }

  // Returns the residuals of a force after a fit of the model parameters and of the terms `by`. The force is `scale`
  // times that of the basis term with the index `column`.
  Residuals residualsOf(Eigen::Index column, double scale, const Fitted& by) const {
    const std::vector<Eigen::Index>& columns = by.columns;
    const auto count = static_cast<Eigen::Index>(columns.size());
    Eigen::MatrixXd gram(count, count);
    Eigen::VectorXd moment(count);
    Eigen::VectorXd lower(count);
    const Eigen::VectorXd upper = Eigen::VectorXd::Constant(count, std::numeric_limits<double>::infinity());
    for (Eigen::Index i = 0; i < count; ++i) {
      const Eigen::Index row = columns[static_cast<std::size_t>(i)] - model_;
      moment[i] = scale * projected_(row, column - model_);
      lower[i] = by.is_signed[static_cast<std::size_t>(i)] ? -upper[i] : 0.0;
      for (Eigen::Index j = 0; j < count; ++j) {
        gram(i, j) = projected_(row, columns[static_cast<std::size_t>(j)] - model_);
      }
    }
    Residuals residuals;
    Eigen::VectorXd added = Eigen::VectorXd::Zero(size_);  // coefficients of all terms
    if (count > 0) {
      const Eigen::VectorXd fitted = numerics::boundedLeastSquares(gram, moment, lower, upper);
      for (Eigen::Index i = 0; i < count; ++i) {
        added[columns[static_cast<std::size_t>(i)]] = fitted[i];
      }
      residuals.beyond = fit::numbersBeyond(candidates_, by.hypothesis, fitted);
    }
    Eigen::VectorXd rest = -added;
    rest[column] += scale;
    rest.head(model_) = -taken_ * rest.tail(size_ - model_);
    residuals.gap = std::sqrt(std::clamp(rest.dot(plain_ * rest), 0.0, 1.0));
    residuals.chi = (departures_ * rest.head(model_)).norm();
    // The forces of per-log nuisance parameters are added to those of the terms.
    residuals.added = std::sqrt(std::max(0.0, added.dot(whole_ * added) + rest.dot((whole_ - plain_) * rest)));
    return residuals;
  }

 private:
  Eigen::MatrixXd plainOf(const fit::BlockGrams& blocks) const {
    return (blocks.sum - blocks.prior).topLeftCorner(size_, size_);
  }

  Eigen::MatrixXd departures_;  // derivatives of data-sheet deviations with respect to the model parameters
  const std::vector<fit::Candidate>& candidates_;
  Eigen::Index model_;
  Eigen::Index size_;
  Eigen::MatrixXd whole_;      // normal matrix without priors, before elimination of nuisance parameters
  Eigen::MatrixXd plain_;      // normal matrix without priors, after elimination of nuisance parameters
  Eigen::VectorXd squares_;    // sum of squares of each term
  Eigen::MatrixXd taken_;      // coefficients of the model parameters that fit each term
  Eigen::MatrixXd projected_;  // normal matrix of the basis terms after elimination of the model parameters
};

std::vector<std::size_t> shapesOf(std::size_t terms) {
  std::vector<std::size_t> places;
  const std::size_t count = std::min(terms, kMostShapes);
  for (std::size_t i = 0; i < count; ++i) {
    places.push_back(count == 1 ? 0 : i * (terms - 1) / (count - 1));
  }
  return places;
}

Fitted fittedBy(const Screening& screening, std::size_t candidate) {
  Fitted fitted{screening.hypothesisOf({static_cast<int>(candidate)}), {}, {}};
  for (const Eigen::Index column : screening.columnsOf()[candidate]) {
    fitted.columns.push_back(column);
    fitted.is_signed.push_back(screening.terms()[static_cast<std::size_t>(column - screening.modelSize())].lower < 0.0);
  }
  return fitted;
}

}  // namespace

std::vector<Implant> implantAll(const fit::HypothesisFitter& fitter, const Screening& screening, int threads) {
  const Projected alone(fitter, screening, {});
  const std::size_t candidates = screening.candidates().size();
  std::vector<Fitted> fitted;
  std::vector<std::unique_ptr<const Projected>> beside_free(candidates);  // null without per-log nuisance parameters
  std::vector<Implant> implants;
  std::vector<Eigen::Index> column_of;
  for (std::size_t c = 0; c < candidates; ++c) {
    fitted.push_back(fittedBy(screening, c));
    if (const fit::PerLogNuisances& free = screening.candidates()[c].free_in_log; free.any()) {
      beside_free[c] = std::make_unique<const Projected>(fitter, screening, free);
    }
    for (const std::size_t place : shapesOf(screening.candidates()[c].terms.size())) {
      const Eigen::Index column = screening.columnsOf()[c][place];
      const fit::BasisTerm& term = screening.terms()[static_cast<std::size_t>(column - screening.modelSize())];
      const double gap = alone.gapOf(column);
      Implant implant;
      implant.effect = static_cast<int>(c);
      implant.term = place;
      implant.blocks = screening.blocks().blocks;
      implant.adds_nothing = !(gap * term.typical > kNothing);
      implant.scale = implant.adds_nothing ? 0.0 : 1.0 / gap;
      implants.push_back(implant);
      column_of.push_back(column);
      if (term.lower < 0.0) {
        implant.scale = -implant.scale;
        implants.push_back(implant);
        column_of.push_back(column);
      }
    }
  }
  fit::parallelFor(implants.size(), threads, [&](std::size_t i) {
    Implant& implant = implants[i];
    if (implant.adds_nothing) {
      return;
    }
    implant.model = alone.residualsOf(column_of[i], implant.scale, {});
    for (std::size_t c = 0; c < candidates; ++c) {
      const Projected& projected = beside_free[c] ? *beside_free[c] : alone;
      implant.singles.push_back(projected.residualsOf(column_of[i], implant.scale, fitted[c]));
    }
  });
  return implants;
}

}  // namespace rubber_suspension::diagnosis::hypotheses
