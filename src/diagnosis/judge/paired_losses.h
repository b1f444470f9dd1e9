// Losses of several models on the same blocks of logs, compared in pairs: who is better, and is it chance?
#pragma once

#include <Eigen/Core>
#include <vector>

namespace rubber_suspension::diagnosis {

/// What models lose on blocks that took no part in their fit. All models have the same blocks.
struct Losses {
  Eigen::MatrixXd loss;      ///< models x blocks [-]; smaller is better
  Eigen::VectorXd weight;    ///< of each block, positive
  std::vector<int> cluster;  ///< of each block: blocks of one log hang together
};

/// The mean of a difference of losses and how well it is known.
struct PairedDifference {
  double mean = 0.0;            ///< [-] of the first less the second; negative: the first is better
  double standard_error = 0.0;  ///< [-] over clusters; infinite where there are fewer than two
  int degrees_of_freedom = 0;   ///< clusters less one

  /// One-sided p-value of the hypothesis that the first is no better than the second (Student's t).
  double pValueOfNoGain() const;
};

/// Compare two models. The standard error is that of a weighted mean over clusters (sandwich of cluster totals, with
/// the factor n/(n-1) for few clusters; Cameron and Miller, J. Human Resources 50, 2015, Eq. 11): blocks of one log
/// share what that log is, so that more blocks of it make nobody surer.
PairedDifference compare(const Losses& losses, Eigen::Index one, Eigen::Index other);

/// p-value of the hypothesis that the first is no better than the second, by the signs of the differences over
/// clusters: the share of all 2^n choices of signs whose sum is at least as good (randomisation test; Fisher, The
/// Design of Experiments, 1935, section 21). A gain that is large in some logs and small in others counts, where it
/// makes a standard error large. 0.5 where there are fewer than kFewestSigns or more than kMostSigns clusters.
double pValueBySigns(const Losses& losses, Eigen::Index one, Eigen::Index other);

constexpr int kFewestSigns = 6;  ///< three times 2^-6 is the first below 0.05
constexpr int kMostSigns = 14;   ///< all choices are tried; a mean of more clusters is normal

/// p-value of the hypothesis that the first is better in one log at most: a gain that a second log repeats is not what
/// a single log has. The blocks of each log are its sample; of n logs, n - 1 times the second least p-value (partial
/// conjunction by Bonferroni's bound; Benjamini and Heller, Biometrics 64, 2008). Logs that do not excite an effect say
/// nothing against it; 1 where a log speaks louder for the second. 0.5 where there is one log only.
double pValueOfTwoLogs(const Losses& losses, Eigen::Index one, Eigen::Index other);

/// Logarithms of mean square errors as losses: half of ln(error + floor). A block counts by the factor that a model
/// gains there, whatever its size; `floor` (mean square of the noise) keeps blocks of mere noise from counting.
Eigen::MatrixXd logarithmicLoss(const Eigen::MatrixXd& mean_square_error, double floor);

}  // namespace rubber_suspension::diagnosis
