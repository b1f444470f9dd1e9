// Clearances and the like, by a grid and then ever closer to its best value.
#include "diagnosis/hypotheses/shapes.h"

#include <cmath>
#include <utility>

#include "diagnosis/hypotheses/screening.h"

namespace rubber_suspension::diagnosis {
namespace {

constexpr int kGrid = 5;         // values, even on a log axis
constexpr int kRefinements = 2;  // each halves the distance of the values

class Shape {
 public:
  Shape(const fit::HypothesisFitter& fitter, const FittedHypothesis& re_estimated,
        const std::vector<log::Record>& records, int threads, const fit::Candidate& candidate)
      : fitter_(fitter), re_estimated_(re_estimated), records_(records), threads_(threads), candidate_(candidate) {}

  std::vector<fit::BasisTerm> best() {
    const double ratio = candidate_.largest_shape / candidate_.least_shape;
    for (int i = 0; i < kGrid; ++i) {
      look(candidate_.least_shape * std::pow(ratio, (i + 0.5) / kGrid));
    }
    double step = std::pow(ratio, 0.5 / kGrid);
    for (int i = 0; i < kRefinements; ++i, step = std::sqrt(step)) {
      const double middle = best_;
      look(middle * step);
      look(middle / step);
    }
    return candidate_.terms_at(best_);
  }

 private:
  void look(double value) {
    std::vector<fit::Candidate> one = {candidate_};
    one.front().terms = candidate_.terms_at(value);
    fit::findUnitEffects(one, records_, threads_);
    const double left = Screening(fitter_, one, re_estimated_, threads_).leftBy({0});
    if (!(left >= least_)) {
      least_ = left;
      best_ = value;
    }
  }

  const fit::HypothesisFitter& fitter_;
  const FittedHypothesis& re_estimated_;
  const std::vector<log::Record>& records_;
  int threads_;
  const fit::Candidate& candidate_;
  double least_ = HUGE_VAL;
  double best_ = 0.0;
};

}  // namespace

void settleShapes(const fit::HypothesisFitter& fitter, const FittedHypothesis& re_estimated,
                  const std::vector<log::Record>& records, int threads, std::vector<fit::Candidate>& candidates) {
  for (fit::Candidate& candidate : candidates) {
    if (candidate.applies() && candidate.terms_at) {
      candidate.terms = Shape(fitter, re_estimated, records, threads, candidate).best();
    }
  }
}

}  // namespace rubber_suspension::diagnosis
