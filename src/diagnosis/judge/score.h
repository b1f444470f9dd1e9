// Computes the score of each hypothesis from its errors on the logs, and its prior.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "diagnosis/judge/evidence.h"
#include "diagnosis/judge/numbers.h"

namespace rubber_suspension::diagnosis::judge {

/// An octave of frequency of one log.
struct Band {
  Eigen::Index log;
  std::size_t octave;  ///< index of LogEvidence::octaves
  double share;        ///< fraction of the weight of the log
};

/// The part of the evidence that the score uses. Arrays have a row for each hypothesis and a column for each log.
/// Squares are mean squares divided by the variance of the force.
struct ScoreTable {
  std::vector<std::string> effects;
  std::vector<bool> constant;  ///< for each effect: it adds a constant force
  std::vector<std::vector<int>> members;
  std::vector<std::size_t> mechanisms;  ///< for each hypothesis: mechanisms of all its effects (mechanismsOf())
  Eigen::ArrayXXd errors;               ///< squared errors
  Eigen::ArrayXXd left;                 ///< squared errors minus the squared noise floor
  Eigen::ArrayXXd added;                ///< squared forces of the effects whose law has several forms
  Eigen::ArrayXXd added_of_one;         ///< squared forces of the effects whose law has one possible form
  Eigen::ArrayXXd in_bands;             ///< part of `left` in each band, divided by the share of the band
  Eigen::ArrayXd departure;             ///< for each hypothesis: chi^2 of the deviations from the data sheet
  Eigen::ArrayXd beyond;                ///< for each hypothesis: parameters beyond those of contained laws
  std::vector<fit::PerLogNuisances> free_in_log;
  std::vector<bool> another_reading;  ///< the hypothesis interprets wrong values as an effect (keeps_values)
  /// Logarithm of the size of each effect over all logs; for wrong values, that of the error which they cause.
  std::vector<std::vector<double>> sizes;
  /// Logarithm of the size that each effect removes beyond the best effect that its law contains; infinite without one.
  std::vector<std::vector<double>> sizes_beyond;
  double by_values = 0.0;  ///< `left` over all logs for the better of configured and re-estimated values
  bool guess = false;      ///< the model as configured is inadmissible
  Eigen::ArrayXd floor;    ///< squared noise floor of each log, at most the least squared error of any hypothesis
  Eigen::ArrayXd floor_uncertainty;  ///< standard error of the logarithm of the floor of each log
  Eigen::ArrayXd weight;             ///< weight of each log; the weights add up to 1
  std::vector<Band> bands;           ///< describes the columns of `in_bands`
  double blocks = 0.0;               ///< number of blocks in which errors are known
};

/// Returns the table that the score needs. Throws std::invalid_argument if the evidence contains no logs, or if a
/// hypothesis lacks the errors on the logs or the sizes of its effects.
ScoreTable scoreTable(const Evidence& evidence);

/// Returns the squared residual beyond noise that is expected of each hypothesis on each log (s^2 of logWeights()).
Eigen::ArrayXXd expectedSquares(const ScoreTable& table, const JudgeNumbers& numbers);

/// Returns the sharpness, kappa of logWeights(), for the number of blocks of the table.
double sharpnessOf(const ScoreTable& table, const JudgeNumbers& numbers);

/// Returns the number of mechanisms that a law counts for if it contains `contained` other laws: at least 1. A law that
/// does the work of two laws is as improbable as both together.
inline std::size_t mechanismsOf(std::size_t contained) { return std::max<std::size_t>(contained, 1); }

/// Returns the log prior that this number of mechanisms is at work, whichever they are.
double priorOfCount(std::size_t mechanisms, const JudgeNumbers& numbers);

/// Returns the cost of parameters that laws have in addition to the laws that they contain. Each parameter costs
/// per_number_beyond times half the logarithm of the number of blocks.
double costOfNumbers(double beyond, double blocks, const JudgeNumbers& numbers);

/// Returns the size below which an effect is improbable, a fraction of the residual without effects.
double usualSize(const ScoreTable& table, const JudgeNumbers& numbers);

/// Returns the log prior of sizes. A size is the logarithm of an RMS force divided by the standard deviation of the
/// force. Below ln(usual) its prior is that of a normal distribution with standard deviation `spread`; above, it is 0.
double priorOfSizes(const std::vector<double>& sizes, double usual, double spread);

/// Returns the cost ln s^2 + (nu + 1) ln(1 + r^2/(nu s^2)) with r^2 = `left`, s^2 = `expected` and nu = `tails`.
double lossOf(double left, double expected, const JudgeNumbers& numbers);

/// Logarithms of the weights of each hypothesis without an unlisted cause (`alone`) and with one (`beside`).
struct LogWeights {
  Eigen::ArrayXd alone;
  Eigen::ArrayXd beside;
};

/// Returns the log weights of all hypotheses. Let r^2 be the squared residual of a hypothesis beyond the noise floor
/// sigma of a log. Its expected value is s^2 = (b sigma)^2 + delta^2 + sum of (eta A)^2, with the RMS force A of each
/// effect and the numbers b = floor_known, delta = accepted and eta = form_error. Without an unlisted cause, the log
/// weight is that of Student's t with nu = tails: -kappa/2 times the sum over logs of w (ln s^2 + (nu + 1) ln(1 +
/// r^2/(nu s^2))), where w is the weight of the log. With an unlisted cause of unknown size and spectrum it is -kappa/2
/// times the sum over logs and bands of w p (ln max(r^2 q/p, s^2) + 1), where p is the share of the band in w and q in
/// the squared residual (Whittle's likelihood). Both include the log priors of the set, sizes, free parameters and
/// deviations from the data sheet.
LogWeights logWeights(const ScoreTable& table, const JudgeNumbers& numbers);

}  // namespace rubber_suspension::diagnosis::judge
