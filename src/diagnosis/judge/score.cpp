// Computes the weights of hypotheses.
#include "diagnosis/judge/score.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>

namespace rubber_suspension::diagnosis::judge {
namespace {

using Eigen::ArrayXd;
using Eigen::ArrayXXd;
using Eigen::Index;

constexpr double kLeastSquare = 1e-8;  // smallest mean square, so that logarithms are finite
constexpr double kImpossible = -std::numeric_limits<double>::infinity();  // log weight of inadmissible hypotheses
constexpr double kTypicalBlocks = 50.0;  // number of blocks for which the sharpness is stated

void requireLogs(const Evidence& evidence) {
  const auto lacks = [&](const HypothesisEvidence& hypothesis) {
    return hypothesis.log_errors.size() != evidence.logs.size() || hypothesis.sizes.size() != hypothesis.members.size();
  };
  if (evidence.logs.empty() || std::any_of(evidence.hypotheses.begin(), evidence.hypotheses.end(), lacks)) {
    throw std::invalid_argument("the evidence has no table of logs; accepted: a file that `diagnose --evidence` wrote");
  }
}

ArrayXd arrayOf(const std::vector<double>& values) {
  return Eigen::Map<const ArrayXd>(values.data(), static_cast<Index>(values.size()));
}

void fillLogs(const Evidence& evidence, ScoreTable& table) {
  const auto logs = static_cast<Index>(evidence.logs.size());
  table.floor.resize(logs);
  table.floor_uncertainty.resize(logs);
  table.weight.resize(logs);
  for (Index l = 0; l < logs; ++l) {
    const LogEvidence& log = evidence.logs[static_cast<std::size_t>(l)];
    table.floor[l] = log.floor * log.floor;
    table.floor_uncertainty[l] = log.floor_uncertainty;
    table.weight[l] = log.weight;
    table.blocks += static_cast<double>(log.blocks);
  }
  table.weight /= table.weight.sum();
  // Held-out errors include the noise of the log, so the noise floor is at most the least error of any hypothesis.
  for (const HypothesisEvidence& hypothesis : evidence.hypotheses) {
    table.floor = table.floor.min(arrayOf(hypothesis.log_errors));
  }
}

void fillBands(const Evidence& evidence, ScoreTable& table) {
  for (std::size_t l = 0; l < evidence.logs.size(); ++l) {
    const std::vector<double>& octaves = evidence.logs[l].octaves;
    for (std::size_t octave = 0; octave < octaves.size(); ++octave) {
      table.bands.push_back({static_cast<Index>(l), octave, octaves[octave]});
    }
  }
}

// Distributes a residual over the bands by its shares, or by the weights of the bands if it has no shares.
void fillInBands(const HypothesisEvidence& hypothesis, Index row, ScoreTable& table) {
  for (std::size_t b = 0; b < table.bands.size(); ++b) {
    const Band& band = table.bands[b];
    const auto log = static_cast<std::size_t>(band.log);
    const bool known = log < hypothesis.shares.size() && band.octave < hypothesis.shares[log].size();
    const double share = known ? hypothesis.shares[log][band.octave] : band.share;
    table.in_bands(row, static_cast<Index>(b)) = table.left(row, band.log) * share / band.share;
  }
}

bool holdsExcluded(const Evidence& evidence, const HypothesisEvidence& hypothesis) {
  return !evidence.excluded.empty() &&
         std::any_of(hypothesis.members.begin(), hypothesis.members.end(),
                     [&](int member) { return evidence.excluded[static_cast<std::size_t>(member)]; });
}

void fillErrors(const Evidence& evidence, const HypothesisEvidence& hypothesis, Index row, ScoreTable& table) {
  table.errors.row(row) = arrayOf(hypothesis.log_errors);
  table.left.row(row) = (arrayOf(hypothesis.log_errors) - table.floor).max(0.0);
  table.departure[row] = hypothesis.chi_squared;
  const bool lacking = !hypothesis.members.empty() && hypothesis.terms == 0;  // the logs lack what the effects need
  if (lacking || hypothesis.idle || holdsExcluded(evidence, hypothesis)) {
    table.left.row(row) = std::numeric_limits<double>::infinity();
  }
}

void fillMembers(const Evidence& evidence, const HypothesisEvidence& hypothesis, Index row, ScoreTable& table) {
  table.beyond[row] = static_cast<double>(hypothesis.beyond);
  table.free_in_log.push_back(hypothesis.free_in_log);
  table.sizes.emplace_back();
  for (std::size_t m = 0; m < hypothesis.members.size(); ++m) {
    const ArrayXd squares = arrayOf(hypothesis.sizes[m]);
    const auto member = static_cast<std::size_t>(hypothesis.members[m]);
    const bool exact = evidence.constant[member] || hypothesis.keeps_values;  // a gain is equivalent to other values
    if (!exact) {
      (evidence.one_form[member] ? table.added_of_one : table.added).row(row) += squares.transpose();
    }
    table.sizes.back().push_back(0.5 * std::log(std::max((squares * table.weight).sum(), kLeastSquare)));
  }
}

// Returns the logarithm of the size of the residual that the hypothesis `by` removes in addition to `beyond`.
double sizeRemoved(const ScoreTable& table, Index by, Index beyond) {
  const ArrayXd removed = (table.left.row(beyond) - table.left.row(by)).transpose();
  return 0.5 * std::log(std::max((removed * table.weight).sum(), kLeastSquare));
}

// Stores the size of the error that wrong values cause: the residual of configured values that this hypothesis removes.
void fillSizeOfWrongValues(Index row, ScoreTable& table) {
  table.sizes[static_cast<std::size_t>(row)] = {sizeRemoved(table, row, Evidence::kAsConfigured)};
}

// Returns the rows of the fitted hypotheses in which a member is replaced by an effect that its law contains.
std::vector<Index> withContained(const Evidence& evidence, std::size_t hypothesis, int member,
                                 const ScoreTable& table) {
  std::vector<Index> rows;
  for (const int contained : evidence.contains[static_cast<std::size_t>(member)]) {
    std::vector<int> members = table.members[hypothesis];
    std::replace(members.begin(), members.end(), member, contained);
    std::sort(members.begin(), members.end());
    members.erase(std::unique(members.begin(), members.end()), members.end());
    const auto found = std::find(table.members.begin(), table.members.end(), members);
    if (found != table.members.end()) {
      rows.push_back(found - table.members.begin());
    }
  }
  return rows;
}

// Stores the sizes that laws remove in addition to the laws that they contain. Such an addition has a prior like the
// size of an effect, because a law without it equals a contained law, but a wider one: what a small clearance changes
// in a friction force is far less than the whole force.
void fillSizesBeyond(const Evidence& evidence, std::size_t hypothesis, ScoreTable& table) {
  std::vector<double>& sizes = table.sizes_beyond.emplace_back();
  for (const int member : table.members[hypothesis]) {
    double least = std::numeric_limits<double>::infinity();
    for (const Index row : withContained(evidence, hypothesis, member, table)) {
      least = std::min(least, sizeRemoved(table, static_cast<Index>(hypothesis), row));
    }
    sizes.push_back(least);  // infinite if no contained law was fitted
  }
}

// Returns the squared residual for configured or re-estimated values, whichever is smaller. If the configured values
// are a guess, returns that of the re-estimated ones.
double leftByValues(const ScoreTable& table) {
  const ArrayXd left = (table.left.topRows<Evidence::kFirstSingle>().matrix() * table.weight.matrix()).array();
  return table.guess ? left[Evidence::kReEstimated] : left.minCoeff();
}

// Returns the log prior of a set: the priors of the number and the kinds of its effects, minus the costs of parameters
// beyond contained laws and of parameters that are free in each log.
double priorOfSet(const ScoreTable& table, const JudgeNumbers& numbers, std::size_t hypothesis) {
  const std::vector<int>& members = table.members[hypothesis];
  const auto row = static_cast<Index>(hypothesis);
  double prior = priorOfCount(table.mechanisms[hypothesis], numbers);
  for (const int member : members) {
    prior += numbers.rateOf(table.effects[static_cast<std::size_t>(member)]);
  }
  const fit::PerLogNuisances& free = table.free_in_log[hypothesis];
  const auto inAllLogs = [&](bool is_free) { return is_free ? static_cast<double>(table.weight.size()) : 0.0; };
  return prior - costOfNumbers(table.beyond[row], table.blocks, numbers) - numbers.per_trend * inAllLogs(free.trend) -
         numbers.per_offset * inAllLogs(free.offset) - numbers.per_gain * inAllLogs(free.gain || free.by_factor);
}

// Returns the log prior of the values by Student's t: values far from the data sheet are improbable.
double priorOfValues(const ScoreTable& table, const JudgeNumbers& numbers, std::size_t hypothesis) {
  const double chi_squared = table.departure[static_cast<Index>(hypothesis)] / std::pow(numbers.sheet_scale, 2);
  return -0.5 * (numbers.sheet_tails + 1.0) * std::log1p(chi_squared / numbers.sheet_tails);
}

// Returns the log prior of one gain of all logs, which is equivalent to values that are wrong by one factor.
double priorOfReading(const ScoreTable& table, const JudgeNumbers& numbers, std::size_t hypothesis) {
  const auto effect = static_cast<std::size_t>(table.members[hypothesis].front());
  return numbers.no_effect + numbers.common_gain + numbers.rateOf(table.effects[effect]) +
         priorOfSizes(table.sizes[hypothesis], numbers.accepted, numbers.values_spread);
}

double priorOf(const ScoreTable& table, const JudgeNumbers& numbers, std::size_t hypothesis) {
  if (table.another_reading[hypothesis]) {
    return priorOfReading(table, numbers, hypothesis);
  }
  switch (hypothesis) {
    case Evidence::kAsConfigured:
      return numbers.no_effect;
    case Evidence::kReEstimated:
      // Right and wrong values have the same prior. Wrong values are expected to cause a gap larger than an engineer
      // accepts, unless the configured values are a guess.
      return numbers.no_effect +
             (table.guess ? 0.0 : priorOfSizes(table.sizes[hypothesis], numbers.accepted, numbers.values_spread));
    default:
      const double usual = usualSize(table, numbers);
      return priorOfSet(table, numbers, hypothesis) +
             priorOfSizes(table.sizes[hypothesis], usual, numbers.share_spread) +
             priorOfSizes(table.sizes_beyond[hypothesis], usual, numbers.beyond_spread);
  }
}

// Returns the sum over logs and bands of w p (ln max(r^2 q/p, s^2) + 1), as logWeights() defines it.
ArrayXd lossBeside(const ScoreTable& table, const ArrayXXd& s2) {
  ArrayXd loss = ArrayXd::Zero(s2.rows());
  for (std::size_t b = 0; b < table.bands.size(); ++b) {
    const Band& band = table.bands[b];
    loss += table.weight[band.log] * band.share *
            (table.in_bands.col(static_cast<Index>(b)).max(s2.col(band.log)).log() + 1.0);
  }
  return loss;
}

// Makes hypotheses impossible whose weight is not finite, because their model cannot follow a log.
void refuseInfinite(ArrayXd& weights) { weights = weights.isFinite().select(weights, kImpossible); }

// Makes the hypotheses that keep the configured values impossible, without and with a gain common to all logs, because
// these values are a guess.
void refuseConfigured(const ScoreTable& table, LogWeights& weights) {
  weights.alone[Evidence::kAsConfigured] = kImpossible;
  for (std::size_t h = 0; h < table.members.size(); ++h) {
    if (table.another_reading[h]) {
      weights.alone[static_cast<Index>(h)] = kImpossible;
    }
  }
}

}  // namespace

ScoreTable scoreTable(const Evidence& evidence) {
  requireLogs(evidence);
  ScoreTable table;
  table.effects = evidence.effects;
  table.guess = evidence.guess;
  table.constant = evidence.constant;
  fillLogs(evidence, table);
  fillBands(evidence, table);
  const auto rows = static_cast<Index>(evidence.hypotheses.size());
  table.errors = table.left = table.added = table.added_of_one = ArrayXXd::Zero(rows, table.weight.size());
  table.in_bands = ArrayXXd::Zero(rows, static_cast<Index>(table.bands.size()));
  table.departure = table.beyond = ArrayXd::Zero(rows);
  for (Index row = 0; row < rows; ++row) {
    const HypothesisEvidence& hypothesis = evidence.hypotheses[static_cast<std::size_t>(row)];
    table.members.push_back(hypothesis.members);
    table.mechanisms.push_back(std::accumulate(
        hypothesis.members.begin(), hypothesis.members.end(), std::size_t{0}, [&](std::size_t sum, int member) {
          return sum + mechanismsOf(evidence.contains[static_cast<std::size_t>(member)].size());
        }));
    table.another_reading.push_back(hypothesis.keeps_values);
    fillErrors(evidence, hypothesis, row, table);
    fillInBands(hypothesis, row, table);
    fillMembers(evidence, hypothesis, row, table);
  }
  fillSizeOfWrongValues(Evidence::kReEstimated, table);
  table.by_values = leftByValues(table);
  for (Index row = 0; row < rows; ++row) {
    if (table.another_reading[static_cast<std::size_t>(row)]) {
      fillSizeOfWrongValues(row, table);
    }
    fillSizesBeyond(evidence, static_cast<std::size_t>(row), table);
  }
  return table;
}

ArrayXXd expectedSquares(const ScoreTable& table, const JudgeNumbers& numbers) {
  const double form = numbers.form_error * numbers.form_error;
  const double form_of_one = numbers.form_error_of_one * numbers.form_error_of_one;
  ArrayXXd squares = form * table.added + form_of_one * table.added_of_one;
  const ArrayXd others = numbers.floor_known * numbers.floor_known * table.floor + numbers.accepted * numbers.accepted;
  squares.rowwise() += others.transpose();
  return squares;
}

double priorOfCount(std::size_t mechanisms, const JudgeNumbers& numbers) {
  const std::array<double, 2> further = {numbers.second, numbers.third};
  double prior = static_cast<double>(mechanisms) * numbers.effect;
  for (std::size_t n = 1; n < mechanisms && n <= further.size(); ++n) {
    prior += further[n - 1];
  }
  return prior;
}

double priorOfSizes(const std::vector<double>& sizes, double usual, double spread) {
  double prior = 0.0;
  for (const double size : sizes) {
    const double below = std::min(size - std::log(usual), 0.0) / spread;
    prior -= 0.5 * below * below;
  }
  return prior;
}

double usualSize(const ScoreTable& table, const JudgeNumbers& numbers) {
  return numbers.share * std::sqrt(table.by_values + numbers.accepted * numbers.accepted);
}

double costOfNumbers(double beyond, double blocks, const JudgeNumbers& numbers) {
  return numbers.per_number_beyond * beyond * 0.5 * std::log(std::max(blocks, 1.0));
}

double sharpnessOf(const ScoreTable& table, const JudgeNumbers& numbers) {
  return numbers.sharpness * std::pow(table.blocks / kTypicalBlocks, numbers.growth);
}

double lossOf(double left, double expected, const JudgeNumbers& numbers) {
  return std::log(expected) + (numbers.tails + 1.0) * std::log1p(left / (numbers.tails * expected));
}

LogWeights logWeights(const ScoreTable& table, const JudgeNumbers& numbers) {
  const double sharpness = sharpnessOf(table, numbers);
  const ArrayXXd s2 = expectedSquares(table, numbers);
  const ArrayXXd student = table.left.binaryExpr(s2, [&](double left, double s) { return lossOf(left, s, numbers); });
  LogWeights weights{-0.5 * sharpness * (student.matrix() * table.weight.matrix()).array(),
                     -0.5 * sharpness * lossBeside(table, s2) + numbers.rest};
  for (std::size_t h = 0; h < table.members.size(); ++h) {
    const double prior = priorOf(table, numbers, h) + priorOfValues(table, numbers, h);
    weights.alone[static_cast<Index>(h)] += prior;
    // With an unlisted cause, right and wrong values are one answer: the re-estimated model without its own prior.
    double& beside = weights.beside[static_cast<Index>(h)];
    beside += prior;
    if (table.another_reading[h]) {
      beside = kImpossible;
    }
  }
  weights.beside[Evidence::kReEstimated] -= priorOf(table, numbers, Evidence::kReEstimated);
  weights.beside[Evidence::kAsConfigured] = kImpossible;
  if (table.guess) {
    refuseConfigured(table, weights);
  }
  refuseInfinite(weights.alone);
  refuseInfinite(weights.beside);
  return weights;
}

}  // namespace rubber_suspension::diagnosis::judge
