// Finds parameters such as clearances on a grid that is refined about the best value.
#include "diagnosis/hypotheses/shapes.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

#include "diagnosis/hypotheses/screening.h"
#include "element/each.h"

namespace rubber_suspension::diagnosis::hypotheses {
namespace {

constexpr int kGrid = 5;         // number of values, evenly spaced on a logarithmic axis
constexpr int kRefinements = 2;  // number of refinements, each of which halves the distance between values

struct Shape {
  fit::Candidate* candidate;
  double best = 0.0;
  double least = HUGE_VAL;  // residual at `best`
  double step = 0.0;        // ratio of the next values to `best`
};

// Tries several values together, because they share the derivatives for the model and for contained effects.
void lookAt(const std::vector<std::pair<Shape*, double>>& looks, const fit::HypothesisFitter& fitter,
            const FittedHypothesis& re_estimated, const std::vector<gap::PreparedRecord>& records,
            const std::vector<fit::Candidate>& contained, int threads) {
  std::vector<fit::Candidate> tried;
  for (const auto& [shape, value] : looks) {
    tried.push_back(*shape->candidate);
    tried.back().terms = shape->candidate->terms_at(value);
  }
  tried.insert(tried.end(), contained.begin(), contained.end());
  fit::findUnitEffects(tried, records, threads);
  const Screening screening(fitter, tried, re_estimated, threads);
  for (std::size_t i = 0; i < looks.size(); ++i) {
    Shape& shape = *looks[i].first;
    const double left = screening.leftBy({static_cast<int>(i)});
    if (!(left >= shape.least)) {
      shape.least = left;
      shape.best = looks[i].second;
    }
  }
}

// Returns the first, the middle and the last term.
std::vector<fit::BasisTerm> threeOf(const std::vector<fit::BasisTerm>& terms) {
  return element::each(std::set<std::size_t>{0, terms.size() / 2, terms.size() - 1},
                       [&](std::size_t place) { return terms[place]; });
}

// Returns a fitted hypothesis without the terms that belong to the law of one effect alone.
FittedHypothesis without(const FittedHypothesis& fitted, int member) {
  FittedHypothesis rest{fitted.hypothesis, fitted.fit};
  rest.hypothesis.terms.clear();
  std::vector<Eigen::Index> kept;
  for (std::size_t t = 0; t < fitted.hypothesis.terms.size(); ++t) {
    if (fitted.hypothesis.places[t].candidate != member) {
      rest.hypothesis.terms.push_back(fitted.hypothesis.terms[t]);
      kept.push_back(static_cast<Eigen::Index>(t));
    }
  }
  rest.fit.parameters.scales = fitted.fit.parameters.scales(kept).eval();
  return rest;
}

// Returns the error of a hypothesis with each of these laws added.
std::vector<double> leftByLaws(const fit::HypothesisFitter& fitter, const FittedHypothesis& rest,
                               const std::vector<fit::Candidate>& laws, int threads) {
  auto [all, fit] = rest;
  const Eigen::Index shared = fitter.model().size() + fit.parameters.scales.size();
  for (const fit::Candidate& law : laws) {
    all.terms.insert(all.terms.end(), law.terms.begin(), law.terms.end());
  }
  fit.parameters.scales.conservativeResizeLike(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(all.terms.size())));
  const fit::BlockGrams blocks = fitter.linearise(all, fit.parameters, {}, threads);
  const numerics::Limits bounds = fitter.stepBounds(all, fit.parameters, blocks.unknowns());
  std::vector<double> left;
  Eigen::Index next = shared;
  for (const fit::Candidate& law : laws) {
    std::vector<Eigen::Index> columns(static_cast<std::size_t>(shared) + law.terms.size());
    std::iota(columns.begin(), columns.begin() + shared, 0);
    std::iota(columns.begin() + shared, columns.end(), next);
    next += static_cast<Eigen::Index>(law.terms.size());
    const Eigen::MatrixXd gram = fit::ofUnknowns(blocks.sum, columns);
    const Eigen::VectorXd step = fit::solve(gram, {bounds.lower(columns), bounds.upper(columns)});
    left.push_back(std::sqrt(std::max(0.0, fit::squaresLeft(gram, step))));
  }
  return left;
}

}  // namespace

void settleShapes(const fit::HypothesisFitter& fitter, const FittedHypothesis& re_estimated,
                  const std::vector<gap::PreparedRecord>& records, int threads,
                  std::vector<fit::Candidate>& candidates) {
  std::vector<Shape> shapes;
  for (fit::Candidate& candidate : candidates) {
    if (candidate.applies() && candidate.terms_at) {
      shapes.push_back({&candidate});
    }
  }
  std::vector<fit::Candidate> contained;
  for (const fit::Candidate& candidate : candidates) {
    const bool any = std::any_of(shapes.begin(), shapes.end(),
                                 [&](const Shape& shape) { return fit::contains(*shape.candidate, candidate); });
    if (any) {
      contained.push_back(candidate);
    }
  }
  fit::findUnitEffects(contained, records, threads);
  std::vector<std::pair<Shape*, double>> looks;
  for (Shape& shape : shapes) {
    const double ratio = shape.candidate->largest_shape / shape.candidate->least_shape;
    shape.step = std::pow(ratio, 0.5 / kGrid);
    for (int i = 0; i < kGrid; ++i) {
      looks.emplace_back(&shape, shape.candidate->least_shape * std::pow(ratio, (i + 0.5) / kGrid));
    }
  }
  for (int refinement = 0; !looks.empty(); ++refinement) {
    lookAt(looks, fitter, re_estimated, records, contained, threads);
    looks.clear();
    for (Shape& shape : shapes) {
      if (refinement < kRefinements) {
        looks.emplace_back(&shape, shape.best * shape.step);
        looks.emplace_back(&shape, shape.best / shape.step);
        shape.step = std::sqrt(shape.step);
      }
    }
  }
  for (Shape& shape : shapes) {
    shape.candidate->terms = shape.candidate->terms_at(shape.best);
  }
}

CurveLook bestCurve(const fit::HypothesisFitter& fitter, const FittedHypothesis& about, const fit::Candidate& candidate,
                    int member, const std::vector<gap::PreparedRecord>& records, int threads) {
  const auto leftAlong = [&](const std::vector<fit::Curve>& curves) {
    std::vector<fit::Candidate> laws(1 + curves.size());
    laws.front().terms = threeOf(candidate.terms);
    for (std::size_t i = 0; i < curves.size(); ++i) {
      laws[1 + i].terms = threeOf(candidate.along(curves[i]));
    }
    fit::findUnitEffects(laws, records, threads);
    return leftByLaws(fitter, without(about, member), laws, threads);
  };
  std::vector<fit::Curve> curves = {{1.0, 0.0}, {2.5, 0.0}, {6.0, 0.0}, {3.0, 1.0}, {3.0, -1.0}};
  CurveLook best;
  best.left = HUGE_VAL;
  double step = 1.6;  // factor on the growth for the next curves: half the spacing on a logarithmic axis
  for (int refinement = 0; refinement <= kRefinements; ++refinement) {
    const std::vector<double> left = leftAlong(curves);
    const auto least = std::min_element(left.begin() + 1, left.end());
    best.left_straight = left.front();
    if (*least < best.left) {
      best.left = *least;
      best.curve = curves[static_cast<std::size_t>(least - left.begin() - 1)];
    }
    if (best.left >= best.left_straight) {
      break;
    }
    curves = {{best.curve.growth * step, best.curve.side}, {best.curve.growth / step, best.curve.side}};
    step = std::sqrt(step);
  }
  return best;
}

}  // namespace rubber_suspension::diagnosis::hypotheses
