// Draws random samples of further logs.
#include "diagnosis/results/predictive.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include "rubber_suspension/gap/gap.h"

namespace rubber_suspension::diagnosis::results {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;

class FurtherLogs {
 public:
  FurtherLogs(const judge::ScoreTable& table, const Closing& closing, unsigned seed)
      : table_(table),
        closing_(closing),
        generator_(seed),
        pick_(table.weight.begin(), table.weight.end()),
        expected_(judge::expectedSquares(table, judge::fittedNumbers()).row(closing.hypothesis)),
        logs_(1.0 / table.weight.square().sum()) {}

  // Returns nullopt if the draw has no gap, or if a hypothesis with effects closes none of the gap.
  std::optional<double> draw() {
    const ArrayXd floor = drawnFloors();
    const ArrayXd before = beyond(judge::Evidence::kReEstimated, floor);
    const double variance = drawnVariance(beyond(closing_.hypothesis, floor));
    double gap = 0.0;
    double left = 0.0;
    double noise = 0.0;
    for (Index i = 0; i < floor.size(); ++i) {
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
    ArrayXd floor = table_.floor;
    for (Index l = 0; l < floor.size(); ++l) {
      floor[l] *= std::exp(2.0 * table_.floor_uncertainty[l] * normal_(generator_));
    }
    return floor;
  }

  // Returns the squared error of a hypothesis above these noise floors in each log.
  ArrayXd beyond(int hypothesis, const ArrayXd& floor) const {
    return (table_.errors.row(hypothesis).transpose() - floor).max(0.0);
  }

  double drawnVariance(const ArrayXd& left) {
    const bool alone = std::bernoulli_distribution(closing_.alone)(generator_);
    const double before = alone ? judge::fittedNumbers().tails : 0.0;
    const double squares = before + logs_ * (table_.weight * left / expected_).sum();
    return squares / std::chi_squared_distribution<double>(before + logs_)(generator_);
  }

  const judge::ScoreTable& table_;
  const Closing& closing_;
  std::mt19937 generator_;
  std::normal_distribution<double> normal_{0.0, 1.0};
  std::discrete_distribution<int> pick_;
  ArrayXd expected_;
  double logs_;  // effective number of logs, given their weights
};

}  // namespace

Closing closingOf(const judge::Answer& answer) { return {answer.model, 1.0 - answer.beside, !answer.effects.empty()}; }

std::array<double, 2> closedOnFurtherLogs(const judge::ScoreTable& table, const Closing& closing, int draws,
                                          unsigned seed) {
  FurtherLogs further(table, closing, seed);
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
