// Paired differences of losses, clustered by log.
#include "diagnosis/judge/paired_losses.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace rubber_suspension::diagnosis {
namespace {

// The blocks of one log as a sample of their own.
Losses blocksOf(int log, const Losses& losses) {
  std::vector<Eigen::Index> blocks;
  for (std::size_t b = 0; b < losses.cluster.size(); ++b) {
    if (losses.cluster[b] == log) {
      blocks.push_back(static_cast<Eigen::Index>(b));
    }
  }
  Losses result;
  result.loss.resize(losses.loss.rows(), static_cast<Eigen::Index>(blocks.size()));
  result.weight.resize(static_cast<Eigen::Index>(blocks.size()));
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    result.loss.col(static_cast<Eigen::Index>(i)) = losses.loss.col(blocks[i]);
    result.weight[static_cast<Eigen::Index>(i)] = losses.weight[blocks[i]];
    result.cluster.push_back(static_cast<int>(i));
  }
  return result;
}

}  // namespace

double PairedDifference::pValueOfNoGain() const {
  if (degrees_of_freedom < 1 || !std::isfinite(standard_error)) {
    return 0.5;
  }
  if (standard_error == 0.0) {
    return mean < 0.0 ? 0.0 : 1.0;
  }
  return boost::math::cdf(boost::math::students_t(degrees_of_freedom), mean / standard_error);
}

PairedDifference compare(const Losses& losses, Eigen::Index one, Eigen::Index other) {
  const Eigen::VectorXd difference = (losses.loss.row(one) - losses.loss.row(other)).transpose();
  const double total = losses.weight.sum();
  PairedDifference result;
  result.mean = losses.weight.dot(difference) / total;
  std::map<int, double> scores;  // by cluster: weighted sum of what departs from the mean
  for (Eigen::Index b = 0; b < difference.size(); ++b) {
    scores[losses.cluster[static_cast<std::size_t>(b)]] += losses.weight[b] * (difference[b] - result.mean);
  }
  const auto clusters = static_cast<double>(scores.size());
  result.degrees_of_freedom = static_cast<int>(scores.size()) - 1;
  if (result.degrees_of_freedom < 1) {
    result.standard_error = std::numeric_limits<double>::infinity();
    return result;
  }
  double squares = 0.0;
  for (const auto& [cluster, score] : scores) {
    squares += score * score;
  }
  result.standard_error = std::sqrt(clusters / (clusters - 1.0) * squares) / total;
  return result;
}

double pValueBySigns(const Losses& losses, Eigen::Index one, Eigen::Index other) {
  std::map<int, double> sums;  // by cluster
  for (Eigen::Index b = 0; b < losses.weight.size(); ++b) {
    sums[losses.cluster[static_cast<std::size_t>(b)]] +=
        losses.weight[b] * (losses.loss(one, b) - losses.loss(other, b));
  }
  const auto clusters = static_cast<int>(sums.size());
  if (clusters < kFewestSigns || clusters > kMostSigns) {
    return 0.5;
  }
  double observed = 0.0;
  for (const auto& [cluster, sum] : sums) {
    observed += sum;
  }
  const unsigned choices = 1U << static_cast<unsigned>(clusters);
  unsigned as_good = 0;
  for (unsigned choice = 0; choice < choices; ++choice) {
    double total = 0.0;
    unsigned place = 0;
    for (const auto& [cluster, sum] : sums) {
      total += (choice >> place++ & 1U) != 0 ? -sum : sum;
    }
    as_good += total <= observed + 1e-12 * std::abs(observed) ? 1 : 0;
  }
  return static_cast<double>(as_good) / static_cast<double>(choices);
}

double pValueOfTwoLogs(const Losses& losses, Eigen::Index one, Eigen::Index other) {
  const std::set<int> logs(losses.cluster.begin(), losses.cluster.end());
  std::vector<double> of_logs;
  for (const int log : logs) {
    of_logs.push_back(compare(blocksOf(log, losses), one, other).pValueOfNoGain());
  }
  if (of_logs.size() < 2) {
    return 0.5;
  }
  std::sort(of_logs.begin(), of_logs.end());
  const auto count = static_cast<double>(of_logs.size());
  const double gain = std::min(1.0, (count - 1.0) * of_logs[1]);
  const double loss = std::min(1.0, count * (1.0 - of_logs.back()));
  return loss < gain ? 1.0 : gain;
}

Eigen::MatrixXd logarithmicLoss(const Eigen::MatrixXd& mean_square_error, double floor) {
  return 0.5 * (mean_square_error.array() + floor).log().matrix();
}

}  // namespace rubber_suspension::diagnosis
