// Clearances and the like, by a grid and then ever closer to its best value.
#include "diagnosis/hypotheses/shapes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "diagnosis/hypotheses/screening.h"

namespace rubber_suspension::diagnosis::hypotheses {
namespace {

constexpr int kGrid = 5;         // values, even on a log axis
constexpr int kRefinements = 2;  // each halves the distance of the values

// The search of one candidate.
struct Shape {
  fit::Candidate* candidate;
  double best = 0.0;
  double least = HUGE_VAL;  // that is left there
  double step = 0.0;        // to the values that are looked at next, a factor
};

// Values to look at, which share the columns of the model and of the effects that they contain.
void lookAt(const std::vector<std::pair<Shape*, double>>& looks, const fit::HypothesisFitter& fitter,
            const FittedHypothesis& re_estimated, const std::vector<log::Record>& records,
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

}  // namespace

void settleShapes(const fit::HypothesisFitter& fitter, const FittedHypothesis& re_estimated,
                  const std::vector<log::Record>& records, int threads, std::vector<fit::Candidate>& candidates) {
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

}  // namespace rubber_suspension::diagnosis::hypotheses
