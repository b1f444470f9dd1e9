// Draws of further logs.
#include "diagnosis/results/predictive.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include "diagnosis/judge/score.h"
#include "rubber_suspension/gap/gap.h"

namespace rubber_suspension::diagnosis::results {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;

class FurtherLogs {
 public:
  FurtherLogs(const judge::Evidence& evidence, const Closing& closing, unsigned seed)
      : evidence_(evidence), closing_(closing), generator_(seed) {
    const judge::ScoreTable table = judge::scoreTable(evidence);
    const judge::JudgeNumbers& numbers = judge::fittedNumbers();
    weight_ = table.weight;
    floor_ = table.floor;
    expected_ = judge::expectedSquares(table, numbers).row(closing.hypothesis);
    tails_ = numbers.tails;
    logs_ = 1.0 / weight_.square().sum();
    pick_ = std::discrete_distribution<int>(weight_.data(), weight_.data() + weight_.size());
  }

  // Nothing where this draw leaves no gap to close, or an effect that is at work does not close any of it.
  std::optional<double> draw() {
    const ArrayXd floor = drawnFloors();
    const ArrayXd before = beyond(judge::Evidence::kReEstimated, floor);
    const double variance = drawnVariance(beyond(closing_.hypothesis, floor));
    double gap = 0.0;
    double left = 0.0;
    double noise = 0.0;
    for (Index i = 0; i < weight_.size(); ++i) {
      const int log = pick_(generator_);
      const double rest = variance * expected_[log] * std::pow(normal_(generator_), 2);
      gap += before[log] + floor[log];
      left += rest + floor[log];
      noise += floor[log];
    }
    if (gap <= noise || (closing_.at_work && left >= gap)) {
      return std::nullopt;
    }
    return gap::closedFraction(std::sqrt(gap), std::sqrt(left), std::sqrt(noise));
  }

 private:
  ArrayXd drawnFloors() {
    ArrayXd floor = floor_;
    for (Index l = 0; l < floor.size(); ++l) {
      const double uncertainty = evidence_.logs[static_cast<std::size_t>(l)].floor_uncertainty;
      floor[l] *= std::exp(2.0 * uncertainty * normal_(generator_));
    }
    return floor;
  }

  // The error that a hypothesis leaves beyond these floors.
  ArrayXd beyond(int hypothesis, const ArrayXd& floor) const {
    const std::vector<double>& errors = evidence_.at(hypothesis).log_errors;
    return (Eigen::Map<const ArrayXd>(errors.data(), floor.size()) - floor).max(0.0);
  }

  double drawnVariance(const ArrayXd& left) {
    const bool alone = std::bernoulli_distribution(closing_.alone)(generator_);
    const double before = alone ? tails_ : 0.0;
    const double squares = before + logs_ * (weight_ * left / expected_).sum();
    return squares / std::chi_squared_distribution<double>(before + logs_)(generator_);
  }

  const judge::Evidence& evidence_;
  const Closing& closing_;
  std::mt19937 generator_;
  std::normal_distribution<double> normal_{0.0, 1.0};
  std::discrete_distribution<int> pick_;
  ArrayXd weight_;
  ArrayXd floor_;
  ArrayXd expected_;
  double tails_ = 0.0;
  double logs_ = 0.0;  // that tell as much together
};

}  // namespace

Closing closingOf(const judge::Answer& answer) { return {answer.model, 1.0 - answer.beside, !answer.effects.empty()}; }

std::array<double, 2> closedOnFurtherLogs(const judge::Evidence& evidence, const Closing& closing, int draws,
                                          unsigned seed) {
  FurtherLogs further(evidence, closing, seed);
  std::vector<double> fractions;
  for (int i = 0; i < draws; ++i) {
    if (const auto fraction = further.draw()) {
      fractions.push_back(*fraction);
    }
  }
  if (fractions.empty()) {
    return {0.0, 1.0};
  }
  std::sort(fractions.begin(), fractions.end());
  const auto at = [&](double share) {
    return fractions[static_cast<std::size_t>(std::lround(share * static_cast<double>(fractions.size() - 1)))];
  };
  return {at(0.025), at(0.975)};
}

}  // namespace rubber_suspension::diagnosis::results
