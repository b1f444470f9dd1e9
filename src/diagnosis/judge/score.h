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
  double share;        ///< what it counts of the log
};

/// The part of the evidence that the score takes, a row for each hypothesis, a column for each log. Squares are mean
/// squares in units of the variance of the force.
struct ScoreTable {
  std::vector<std::string> effects;
  std::vector<bool> constant;  ///< of each effect
  std::vector<std::vector<int>> members;
  std::vector<std::size_t> mechanisms;  ///< of the members together
  Eigen::ArrayXXd errors;               ///< squares
  Eigen::ArrayXXd left;                 ///< squares beyond the noise floor
  Eigen::ArrayXXd added;                ///< squares of the forces of the members whose law has several forms
  Eigen::ArrayXXd added_of_one;         ///< of those whose law has one form
  Eigen::ArrayXXd in_bands;  ///< squares beyond the noise floor by band of a log, each over what the band counts
  Eigen::ArrayXd departure;  ///< chi^2 of the numbers of the data sheet
  Eigen::ArrayXd beyond;     ///< numbers beyond the laws that the members contain
  std::vector<fit::PerLogNuisances> free_in_log;
  std::vector<bool> another_reading;  ///< of wrong values, by an effect beside those as configured
  /// Logarithm of the size of each member over all logs; of wrong values, of what they remove.
  std::vector<std::vector<double>> sizes;
  /// Sizes of what each member whose law contains others removes beyond the best of these.
  std::vector<std::vector<double>> sizes_beyond;
  double by_values = 0.0;            ///< square that is left beyond the floor without effects, by the better values
  bool guess = false;                ///< the model as configured is no answer
  Eigen::ArrayXd floor;              ///< of each log, squared; no more than a hypothesis leaves of it
  Eigen::ArrayXd floor_uncertainty;  ///< of each log, the standard error of the logarithm of its floor
  Eigen::ArrayXd weight;             ///< of each log; they add up to 1
  std::vector<Band> bands;           ///< the columns of `in_bands`
  double blocks = 0.0;               ///< of the logs that errors are known of
};

/// Throws std::invalid_argument where the evidence has no logs or a hypothesis no errors by log.
ScoreTable scoreTable(const Evidence& evidence);

/// The square that each hypothesis is expected to leave of each log beyond its noise, s^2 below.
Eigen::ArrayXXd expectedSquares(const ScoreTable& table, const JudgeNumbers& numbers);

/// The sharpness kappa for this many blocks.
double sharpnessOf(const ScoreTable& table, const JudgeNumbers& numbers);

/// One, or as many as the laws are that a law contains: what does the work of two is as seldom as two.
inline std::size_t mechanismsOf(std::size_t contained) { return std::max<std::size_t>(contained, 1); }

/// Prior of so many mechanisms at work, whichever they are.
double priorOfCount(std::size_t mechanisms, const JudgeNumbers& numbers);

/// The cost of numbers that laws have beyond those that they contain: of each a multiple of half the logarithm of the
/// blocks.
double costOfNumbers(double beyond, double blocks, const JudgeNumbers& numbers);

/// The size below which an effect is improbable: a share of what values leave.
double usualSize(const ScoreTable& table, const JudgeNumbers& numbers);

/// Prior of sizes: logarithms of RMS forces over the force's deviation, of which what is below the usual one is
/// improbable: a normal distribution of so wide a spread there.
double priorOfSizes(const std::vector<double>& sizes, double usual, double spread);

/// The cost of squares left where these are expected: ln s^2 + (nu + 1) ln(1 + r^2/(nu s^2)).
double lossOf(double left, double expected, const JudgeNumbers& numbers);

/// Logarithm of the weight of each hypothesis: alone, and beside a rest that no listed effect causes.
struct LogWeights {
  Eigen::ArrayXd alone;
  Eigen::ArrayXd beside;
};

/// With s^2 = (b sigma)^2 + delta^2 + sum of (eta A)^2, what a hypothesis is expected to leave of a log, and r^2, what
/// it leaves beyond the floor sigma, its weight alone is that of Student's t,
/// -kappa/2 sum over logs of w (ln s^2 + (nu + 1) ln(1 + r^2/(nu s^2))), and beside a rest of free size and spectrum
/// -kappa/2 sum over logs and bands of w p (ln max(r^2 q/p, s^2) + 1), p being what a band counts of
/// its log and q its share of what is left there (Whittle's likelihood of a rest whose spectrum is not known); each
/// with the prior of the set, of the shares that its members have in what is left without them, of the numbers that it
/// frees and of how far its values are from the data sheet.
LogWeights logWeights(const ScoreTable& table, const JudgeNumbers& numbers);

}  // namespace rubber_suspension::diagnosis::judge
