// The Model Confidence Set and weights of models.
#include "diagnosis/judge/model_confidence_set.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>

namespace rubber_suspension::diagnosis {
namespace {

// Mean losses by cluster (models x clusters) and what share of the weight each cluster has.
struct ClusterMeans {
  Eigen::MatrixXd mean;
  Eigen::VectorXd share;
};

ClusterMeans byCluster(const Losses& losses) {
  std::map<int, Eigen::Index> place;
  for (const int cluster : losses.cluster) {
    place.emplace(cluster, 0);
  }
  Eigen::Index next = 0;
  for (auto& [cluster, index] : place) {
    index = next++;
  }
  ClusterMeans result{Eigen::MatrixXd::Zero(losses.loss.rows(), next), Eigen::VectorXd::Zero(next)};
  for (Eigen::Index b = 0; b < losses.weight.size(); ++b) {
    const Eigen::Index c = place.at(losses.cluster[static_cast<std::size_t>(b)]);
    result.mean.col(c) += losses.weight[b] * losses.loss.col(b);
    result.share[c] += losses.weight[b];
  }
  for (Eigen::Index c = 0; c < next; ++c) {
    result.mean.col(c) /= result.share[c];
  }
  result.share /= result.share.sum();
  return result;
}

// Shares of the clusters, each times a random weight of mean 1, adding up to 1 again.
Eigen::VectorXd drawShares(const Eigen::VectorXd& share, std::mt19937_64& generator) {
  std::exponential_distribution<double> exponential(1.0);
  Eigen::VectorXd drawn = share;
  for (double& value : drawn) {
    value *= exponential(generator);
  }
  return drawn / drawn.sum();
}

// Mean losses of the models for draws of the clusters: models x draws.
Eigen::MatrixXd drawnMeans(const ClusterMeans& means, int draws, unsigned seed) {
  std::mt19937_64 generator(seed);
  Eigen::MatrixXd result(means.mean.rows(), draws);
  for (int d = 0; d < draws; ++d) {
    result.col(d) = means.mean * drawShares(means.share, generator);
  }
  return result;
}

std::vector<int> orderOf(const Eigen::VectorXd& mean) {
  std::vector<int> order(static_cast<std::size_t>(mean.size()));
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return mean[a] < mean[b]; });
  return order;
}

// The model that is furthest above the mean of those left, in standard errors, and the p-value of their equality.
struct Elimination {
  std::size_t worst;  // place among those left
  double p_value;
};

Elimination eliminate(const Eigen::VectorXd& mean, const Eigen::MatrixXd& drawn, const std::vector<int>& left) {
  const auto count = static_cast<Eigen::Index>(left.size());
  Eigen::VectorXd observed(count);
  Eigen::MatrixXd simulated(count, drawn.cols());
  for (Eigen::Index i = 0; i < count; ++i) {
    observed[i] = mean[left[static_cast<std::size_t>(i)]];
    simulated.row(i) = drawn.row(left[static_cast<std::size_t>(i)]);
  }
  observed.array() -= observed.mean();
  simulated.rowwise() -= simulated.colwise().mean().eval();
  const Eigen::MatrixXd spread = simulated.colwise() - observed;
  const Eigen::ArrayXd error = spread.array().square().rowwise().mean().sqrt().max(1e-300);
  Eigen::Index worst = 0;
  const double statistic = (observed.array() / error).maxCoeff(&worst);
  const Eigen::ArrayXd largest = (spread.array().colwise() / error).colwise().maxCoeff().transpose();
  return {static_cast<std::size_t>(worst), (largest >= statistic).cast<double>().mean()};
}

}  // namespace

ModelConfidenceSet modelConfidenceSet(const Losses& losses, double confidence, int draws, unsigned seed) {
  const ClusterMeans means = byCluster(losses);
  const Eigen::VectorXd mean = means.mean * means.share;
  const Eigen::MatrixXd drawn = drawnMeans(means, draws, seed);
  ModelConfidenceSet result;
  result.p_value.assign(static_cast<std::size_t>(mean.size()), 1.0);
  std::vector<int> left = orderOf(mean);
  double highest = 0.0;
  while (left.size() > 1) {
    const Elimination next = eliminate(mean, drawn, left);
    highest = std::max(highest, next.p_value);  // a model is out no sooner than those before it
    result.p_value[static_cast<std::size_t>(left[next.worst])] = highest;
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(next.worst));
  }
  for (const int model : orderOf(mean)) {
    if (result.p_value[static_cast<std::size_t>(model)] >= 1.0 - confidence) {
      result.members.push_back(model);
    }
  }
  return result;
}

std::vector<double> pseudoBmaWeights(const Losses& losses, double power, int draws, unsigned seed) {
  const ClusterMeans means = byCluster(losses);
  const double scale = power * static_cast<double>(means.share.size());
  const Eigen::MatrixXd drawn = drawnMeans(means, draws, seed);
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(drawn.rows());
  for (Eigen::Index d = 0; d < drawn.cols(); ++d) {
    const Eigen::ArrayXd score = -scale * (drawn.col(d).array() - drawn.col(d).minCoeff());
    const Eigen::VectorXd weight = score.exp().matrix();
    sum += weight / weight.sum();
  }
  sum /= sum.sum();
  return {sum.data(), sum.data() + sum.size()};
}

}  // namespace rubber_suspension::diagnosis
