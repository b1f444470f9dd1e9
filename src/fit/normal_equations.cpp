// Normal equations of blocks of the logs.
#include "fit/normal_equations.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "element/each.h"
#include "fit/parallel.h"
#include "numerics/bounded_least_squares.h"
#include "numerics/elimination.h"
#include "numerics/gram.h"
#include "numerics/least_squares.h"

namespace rubber_suspension::fit {
namespace {

constexpr double kCyclesPerBlock = 4.0;  // cycles per block; residuals are correlated over shorter times
constexpr double kMostBlocks = 24.0;
constexpr double kFewestBlocks = 8.0;
constexpr double kBlocksOfAll = 480.0;  // blocks of all logs; many logs predict each other, so that each needs fewer
constexpr double kBlocksOfOne = 2.0;    // blocks of one log: one for its parameters, the other to measure the error

using Places = std::vector<Eigen::Index>;

void prepare(Eigen::Index width, Kept kept, const PerLogNuisances& free, BlockGrams& result) {
  const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(width, width);
  result.prior = result.sum = none;
  result.without_fold.assign(kFolds, none);
  result.squares = Eigen::VectorXd::Zero(width);
  result.mean_offset = Eigen::VectorXd::Zero(free.offset ? width : 0);
  result.mean_gain = Eigen::VectorXd::Zero(free.gain ? width : 0);
  if (kept == Kept::folds) {
    result.held_out.assign(kFolds, none);
    result.weight.assign(kFolds, 0.0);
    result.record.assign(kFolds, 0);
    result.fold.resize(kFolds);
    std::iota(result.fold.begin(), result.fold.end(), 0);
  }
}

// Appends the `count` indices that begin with `first`.
Places with(Places places, Eigen::Index first, Eigen::Index count) {
  places.resize(places.size() + static_cast<std::size_t>(count));
  std::iota(places.end() - count, places.end(), first);
  return places;
}

// Copies some columns of a log, weighted, from sample `first` on into the rows of a matrix.
void fill(const std::vector<ForceColumn>& columns, const Places& which, std::size_t r, Eigen::Index first,
          double weight, Eigen::Ref<Eigen::MatrixXd> to) {
  for (std::size_t j = 0; j < which.size(); ++j) {
    const ForceColumn& column = columns[static_cast<std::size_t>(which[j])];
    to.col(static_cast<Eigen::Index>(j)) = weight * (*column)[r].segment(first, to.rows());
  }
}

// Sets samples that do not count to 0.
void leaveOut(const log::Record& record, Eigen::Index first, Eigen::MatrixXd& columns) {
  if (record.counts.size() > 0) {
    columns.array().colwise() *= record.counts.segment(first, columns.rows()).array();
  }
}

}  // namespace

void BlockGrams::addPrior() {
  sum += prior;
  for (Eigen::MatrixXd& others : without_fold) {
    others += prior;
  }
}

// The blocks are summed for each fold, rather than subtracted from the sum, so that zeros remain exact.
void BlockGrams::sumUp() {
  sum = prior;
  const int folds = std::max(kFolds, 1 + *std::max_element(fold.begin(), fold.end()));
  without_fold.assign(static_cast<std::size_t>(folds), prior);
  for (std::size_t b = 0; b < gram.size(); ++b) {
    sum += gram[b];
    for (int other = 0; other < folds; ++other) {
      if (other != fold[b]) {
        without_fold[static_cast<std::size_t>(other)] += gram[b];
      }
    }
  }
  held_out = gram;
  blocks = gram.size();
}

BlockGrams BlockGrams::of(const std::vector<Eigen::Index>& unknowns) const {
  const auto part = [&](const Eigen::MatrixXd& all) { return ofUnknowns(all, unknowns); };
  BlockGrams result;
  result.gram = element::each(gram, part);
  result.held_out = element::each(held_out, part);
  result.fold = fold;
  result.record = record;
  result.weight = weight;
  result.prior = part(prior);
  result.squares = squares(unknowns);
  result.blocks = blocks;
  result.sum = part(sum);
  result.without_fold = element::each(without_fold, part);
  return result;
}

// The columns of the least-squares system whose products are requested.
struct LogBlocks::Request {
  const gap::Forces& base;
  const std::vector<ForceColumn>& columns;
  PerLogNuisances free;  // nuisance parameters that any result needs
  Kept kept;
  Eigen::Index width;  // number of columns, with the residual
  Places fresh;        // indices of columns to be multiplied by all others
  Places known;        // indices of columns that no fit changes
  Places index;        // indices of the known columns in known_
};

// Products of the columns, residual and nuisance parameters of one log after errors of its rig were removed.
struct LogBlocks::OfLog {
  numerics::BlockProducts products;
  numerics::BlockPlaces places;
  Eigen::VectorXd squares;
};

LogBlocks::LogBlocks(const std::vector<gap::PreparedRecord>& records, std::vector<double> weights,
                     std::vector<ForceColumn> known, int threads)
    : records_(records),
      weights_(std::move(weights)),
      known_(std::move(known)),
      blocks_(records.size()),
      penalties_(records.size()) {
  const auto count = static_cast<Eigen::Index>(known_.size());
  parallelFor(records.size(), threads, [&](std::size_t r) {
    blocks_[r] = cut(records[r], records.size());
    for (Block& block : blocks_[r]) {
      const Eigen::Index rig = records[r].rig.columns.cols();
      Eigen::MatrixXd columns(block.size, count + rig);
      fill(known_, with({}, 0, count), r, block.first, weights_[r], columns);
      leaveOut(records[r], block.first, columns);
      if (rig > 0) {
        columns.rightCols(rig) = records[r].rig.columns.middleRows(block.first, block.size);
      }
      block.known = numerics::gramOf(columns);
    }
    penalties_[r] = numerics::penaltyOfWhitening(records[r].rig.columns);
  });
}

// Cuts a log into blocks. Blocks in which no sample counts, as after failure of a sensor, are omitted.
std::vector<LogBlocks::Block> LogBlocks::cut(const log::Record& record, std::size_t logs) {
  const double cycles = record.duration() * record.mean_frequency;
  const double most = std::clamp(std::floor(kBlocksOfAll / static_cast<double>(logs)), kBlocksOfOne, kMostBlocks);
  const double fewest = std::min(kFewestBlocks, most);
  const auto count = static_cast<Eigen::Index>(std::clamp(std::round(cycles / kCyclesPerBlock), fewest, most));
  std::vector<Block> blocks;
  for (Eigen::Index b = 0; b < count; ++b) {
    const Eigen::Index first = record.size() * b / count;
    const Eigen::Index size = record.size() * (b + 1) / count - first;
    const double counted = record.counted(first, size);
    if (counted > 0.0) {
      blocks.push_back({first, size, counted, {}});
    }
  }
  return blocks;
}

// Returns the residual of a log and the columns of its nuisance parameters.
Eigen::MatrixXd LogBlocks::ownOf(const Request& request, std::size_t r) const {
  const Eigen::Index free = request.free.count();
  Eigen::MatrixXd columns(records_[r].size(), free + 1);
  columns.col(0) = weights_[r] * (records_[r].force - request.base[r]);
  columns.rightCols(free) = weights_[r] * request.free.columns(records_[r], r, request.base[r]);
  return columns;
}

// Returns, for each block of a log, the products of columns, residual, nuisance parameters and errors of the rig.
std::vector<Eigen::MatrixXd> LogBlocks::productsIn(std::size_t r, const Request& request) const {
  const Eigen::Index rig = records_[r].rig.columns.cols();
  const Eigen::MatrixXd of_log = ownOf(request, r);
  const Eigen::Index width = request.width - 1 + of_log.cols();
  const Places own = with(request.fresh, request.width - 1, of_log.cols());
  const Places of_rig = with({}, width, rig);
  const Places rig_of_known = with({}, static_cast<Eigen::Index>(known_.size()), rig);
  const Places known_and_rig = with(request.known, width, rig);
  const Places index = with(request.index, static_cast<Eigen::Index>(known_.size()), rig);
  std::vector<Eigen::MatrixXd> grams;
  for (const Block& block : blocks_[r]) {
    Eigen::MatrixXd columns(block.size, static_cast<Eigen::Index>(own.size()));
    fill(request.columns, request.fresh, r, block.first, weights_[r], columns);
    columns.rightCols(of_log.cols()) = of_log.middleRows(block.first, block.size);
    leaveOut(records_[r], block.first, columns);
    Eigen::MatrixXd& gram = grams.emplace_back(Eigen::MatrixXd::Zero(width + rig, width + rig));
    gram(own, own) = numerics::gramOf(columns);
    if (rig > 0) {
      const Eigen::MatrixXd mixed =
          numerics::productOf(columns, records_[r].rig.columns.middleRows(block.first, block.size));
      gram(own, of_rig) = mixed;
      gram(of_rig, own) = mixed.transpose();
      gram(of_rig, of_rig) = block.known(rig_of_known, rig_of_known);
    }
    if (!request.known.empty()) {
      Eigen::MatrixXd known(block.size, static_cast<Eigen::Index>(request.known.size()));
      fill(known_, request.index, r, block.first, weights_[r], known);
      const Eigen::MatrixXd mixed = numerics::productOf(columns, known);
      gram(own, request.known) = mixed;
      gram(request.known, own) = mixed.transpose();
      gram(known_and_rig, known_and_rig) = block.known(index, index);
    }
  }
  return grams;
}

LogBlocks::OfLog LogBlocks::ofLog(std::size_t r, const Request& request) const {
  const double counted = records_[r].counted();
  const std::vector<Eigen::MatrixXd> products = productsIn(r, request);
  OfLog result{{}, {{}, {}, kFolds, request.kept == Kept::blocks}, Eigen::VectorXd::Zero(request.width)};
  for (std::size_t b = 0; b < products.size(); ++b) {
    result.places.fold.push_back(static_cast<int>(b + r) % kFolds);
    result.places.share.push_back(blocks_[r][b].counted / counted);
    result.squares += products[b].diagonal().head(request.width);
  }
  result.products = numerics::withoutErrors(products, penalties_[r], result.places);
  if (request.kept == Kept::folds) {
    result.products = numerics::byFold(result.products, result.places);
  }
  return result;
}

// Adds a log after elimination of its nuisance parameters. Trends and displacement offsets are in units of the standard
// deviation of the log's force.
void LogBlocks::add(std::size_t r, const OfLog& of_log, const Request& request, const PerLogNuisances& free,
                    BlockGrams& result) const {
  const gap::PreparedRecord& record = records_[r];
  const double counted = record.counted();
  const auto logs = static_cast<double>(records_.size());
  Places columns = with({}, 0, request.width);
  for (const Eigen::Index place : free.placesIn(request.free)) {
    columns.push_back(request.width + place);
  }
  numerics::BlockProducts own = numerics::ofColumns(of_log.products, columns);
  if (free.any()) {
    const double force = std::pow(weights_[r] * record.force_deviation, 2) * counted;
    Eigen::MatrixXd shares;
    own = numerics::withoutUnknowns(own, force * free.costs(record).cwiseAbs2(), of_log.places, shares);
    if (free.offset) {
      result.mean_offset += shares.row(free.placeOfOffset()).transpose() * (record.force_deviation / logs);
    }
    if (free.gain) {
      result.mean_gain += shares.row(free.placeOfGain()).transpose() / logs;
    }
  }
  result.squares += of_log.squares;
  result.blocks += blocks_[r].size();
  result.sum += own.sum;
  for (std::size_t fold = 0; fold < own.without_fold.size(); ++fold) {
    result.without_fold[fold] += own.without_fold[fold];
  }
  for (std::size_t b = 0; b < own.held_out.size(); ++b) {
    if (request.kept == Kept::folds) {
      result.held_out[b] += own.held_out[b];
    } else {
      result.gram.push_back(std::move(own.in_sample[b]));
      result.held_out.push_back(std::move(own.held_out[b]));
      result.fold.push_back(of_log.places.fold[b]);
      result.record.push_back(static_cast<int>(r));
    }
  }
  for (std::size_t b = 0; b < blocks_[r].size(); ++b) {
    const double weight = record.weight * blocks_[r][b].counted / (counted * logs);
    if (request.kept == Kept::folds) {
      result.weight[(b + r) % kFolds] += weight;
    } else {
      result.weight.push_back(weight);
    }
  }
}

std::vector<BlockGrams> LogBlocks::normalEquations(const gap::Forces& base, const std::vector<ForceColumn>& columns,
                                                   const std::vector<PerLogNuisances>& free, Kept kept,
                                                   int threads) const {
  constexpr std::size_t kAtOnce = 8;  // logs whose products are in memory at the same time
  Request request{base, columns, {}, kept, static_cast<Eigen::Index>(columns.size()) + 1, {}, {}, {}};
  for (const PerLogNuisances& one : free) {
    request.free = request.free | one;
  }
  for (std::size_t j = 0; j < columns.size(); ++j) {
    const auto found = std::find(known_.begin(), known_.end(), columns[j]);
    if (columns[j] && found != known_.end()) {
      request.known.push_back(static_cast<Eigen::Index>(j));
      request.index.push_back(found - known_.begin());
    } else if (columns[j]) {
      request.fresh.push_back(static_cast<Eigen::Index>(j));
    }
  }
  std::vector<BlockGrams> results(free.size());
  for (std::size_t i = 0; i < free.size(); ++i) {
    prepare(request.width, kept, free[i], results[i]);
  }
  for (std::size_t first = 0; first < records_.size(); first += kAtOnce) {
    std::vector<OfLog> logs(std::min(kAtOnce, records_.size() - first));
    parallelFor(logs.size(), threads, [&](std::size_t i) { logs[i] = ofLog(first + i, request); });
    parallelFor(results.size(), threads, [&](std::size_t i) {
      for (std::size_t r = 0; r < logs.size(); ++r) {
        add(first + r, logs[r], request, free[i], results[i]);
      }
    });
  }
  return results;
}

Eigen::MatrixXd ofUnknowns(const Eigen::MatrixXd& gram, std::vector<Eigen::Index> unknowns) {
  unknowns.push_back(gram.cols() - 1);
  return gram(unknowns, unknowns);
}

Eigen::VectorXd solve(const Eigen::MatrixXd& gram, const numerics::Limits& bounds) {
  const Eigen::Index last = gram.cols() - 1;
  return numerics::boundedLeastSquares(gram.topLeftCorner(last, last), gram.col(last).head(last), bounds.lower,
                                       bounds.upper);
}

double squaresLeft(const Eigen::MatrixXd& gram, const Eigen::VectorXd& coefficients) {
  const Eigen::Index last = coefficients.size();
  const Eigen::VectorXd taken = 2.0 * gram.col(last).head(last) - gram.topLeftCorner(last, last) * coefficients;
  return gram(last, last) - coefficients.dot(taken);
}

std::vector<double> crossValidate(const BlockGrams& blocks,
                                  const std::function<Eigen::VectorXd(const Eigen::MatrixXd& gram)>& fit) {
  const std::vector<Eigen::VectorXd> by_fold = element::each(blocks.without_fold, fit);
  std::vector<double> errors;
  for (std::size_t b = 0; b < blocks.held_out.size(); ++b) {
    const double error = squaresLeft(blocks.held_out[b], by_fold[static_cast<std::size_t>(blocks.fold[b])]);
    errors.push_back(std::isfinite(error) ? std::max(error, 0.0) / blocks.weight[b]
                                          : std::numeric_limits<double>::infinity());
  }
  return errors;
}

}  // namespace rubber_suspension::fit
