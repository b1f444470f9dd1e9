// Score of each hypothesis by its errors on the logs, and its prior.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "diagnosis/judge/evidence.h"
#include "diagnosis/judge/numbers.h"

namespace rubber_suspension::diagnosis::judge {

/// An octave of a log.
struct Band {
  Eigen::Index log;
  std::size_t octave;  ///< place in LogEvidence::octaves
  double share;        ///< of the weight of the log
};

/// The part of the evidence that the score uses, with a row for each hypothesis and a column for each log. Squares are
/// mean squares in units of the variance of the force.
struct ScoreTable {
  std::vector<std::string> effects;
  std::vector<bool> constant;  ///< of each effect
  std::vector<std::vector<int>> members;
  std::vector<std::size_t> mechanisms;  ///< number of mechanisms of all members (mechanismsOf())
  Eigen::ArrayXXd errors;               ///< squares
  Eigen::ArrayXXd left;                 ///< squares beyond the noise floor
  Eigen::ArrayXXd added;                ///< squares of the forces of the members whose law has several forms
  Eigen::ArrayXXd added_of_one;         ///< squares of the forces of the members whose law has one form
  Eigen::ArrayXXd in_bands;             ///< squares beyond the noise floor in each band, over the share of the band
  Eigen::ArrayXd departure;             ///< chi^2 of the numbers of the data sheet
  Eigen::ArrayXd beyond;                ///< numbers beyond the laws that the members contain
  std::vector<fit::PerLogNuisances> free_in_log;
  std::vector<bool> another_reading;  ///< the hypothesis reads wrong values as an effect (keeps_values)
  /// Logarithm of the size of each member over all logs; for wrong values, of the residual that they remove.
  std::vector<std::vector<double>> sizes;
  /// Logarithm of the size of what each member removes beyond the best of the effects that it contains; else infinite.
  std::vector<std::vector<double>> sizes_beyond;
  double by_values = 0.0;            ///< squared residual beyond the floor without effects, with the better values
  bool guess = false;                ///< the model as configured is inadmissible
  Eigen::ArrayXd floor;              ///< squared floor of each log, at most the least error of any hypothesis
  Eigen::ArrayXd floor_uncertainty;  ///< standard error of the logarithm of the floor of each log
  Eigen::ArrayXd weight;             ///< of each log; they add up to 1
  std::vector<Band> bands;           ///< the columns of `in_bands`
  double blocks = 0.0;               ///< number of blocks with known errors
};

/// Returns the table of evidence. Throws std::invalid_argument if it has no logs or a hypothesis has no errors by log.
ScoreTable scoreTable(const Evidence& evidence);

/// Returns the squared residual beyond noise that is expected of each hypothesis on each log: s^2 below.
Eigen::ArrayXXd expectedSquares(const ScoreTable& table, const JudgeNumbers& numbers);

/// Returns the sharpness kappa for the blocks of the table.
double sharpnessOf(const ScoreTable& table, const JudgeNumbers& numbers);

/// Returns the number of mechanisms of a law that contains so many others: at least 1. A law that does the work of two
/// is as improbable as two laws.
inline std::size_t mechanismsOf(std::size_t contained) { return std::max<std::size_t>(contained, 1); }

/// Returns the log prior of a number of mechanisms at work, whichever they are.
double priorOfCount(std::size_t mechanisms, const JudgeNumbers& numbers);

/// Returns the cost of numbers that laws have beyond the laws that they contain: for each number, per_number_beyond
/// times half the logarithm of the number of blocks.
double costOfNumbers(double beyond, double blocks, const JudgeNumbers& numbers);

/// Returns the size below which an effect is improbable: a share of the residual without effects.
double usualSize(const ScoreTable& table, const JudgeNumbers& numbers);

/// Returns the log prior of sizes, which are logarithms of RMS forces over the force's standard deviation: below
/// ln(usual) that of a normal distribution with standard deviation `spread`, above it 0.
double priorOfSizes(const std::vector<double>& sizes, double usual, double spread);

/// Returns the cost of a squared residual r^2 = `left` if s^2 = `expected`: ln s^2 + (nu + 1) ln(1 + r^2/(nu s^2)).
double lossOf(double left, double expected, const JudgeNumbers& numbers);

/// Logarithm of the weight of each hypothesis: alone, and beside a residual force of unlisted cause.
struct LogWeights {
  Eigen::ArrayXd alone;
  Eigen::ArrayXd beside;
};

/// Returns the log weights of all hypotheses. Let r^2 be the squared residual of a hypothesis on a log beyond the floor
/// sigma, and s^2 = (b sigma)^2 + delta^2 + sum of (eta A)^2 its expectation, with RMS forces A of its members,
/// b = floor_known, delta = accepted and eta = form_error. Alone the weight is that of Student's t with nu = tails,
/// -kappa/2 sum over logs of w (ln s^2 + (nu + 1) ln(1 + r^2/(nu s^2))). Beside a residual force of unknown size and
/// spectrum it is -kappa/2 sum over logs and bands of w p (ln max(r^2 q/p, s^2) + 1), where p is the share of a band in
/// the weight w of its log and q its share of the residual (Whittle's likelihood). Both include the log priors of the
/// set, of the sizes of its members, of its free numbers, and of the deviations from the data sheet.
LogWeights logWeights(const ScoreTable& table, const JudgeNumbers& numbers);

}  // namespace rubber_suspension::diagnosis::judge
