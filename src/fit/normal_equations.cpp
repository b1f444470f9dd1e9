// Products of columns by blocks of the logs.
#include "fit/normal_equations.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "element/each.h"
#include "fit/parallel.h"
#include "numerics/bounded_least_squares.h"
#include "numerics/gram.h"

namespace rubber_suspension::fit {
namespace {

constexpr double kCyclesPerBlock = 4.0;  // of the motion's mean frequency: longer than what a residual remembers
constexpr double kMostBlocks = 24.0;
constexpr double kFewestBlocks = 8.0;

using Places = std::vector<Eigen::Index>;

// These and the next ones from `first` on.
Places with(Places places, Eigen::Index first, Eigen::Index count) {
  places.resize(places.size() + static_cast<std::size_t>(count));
  std::iota(places.end() - count, places.end(), first);
  return places;
}

// Some columns over samples of a log from `first` on, as many as the matrix has rows, weighted.
void fill(const std::vector<ForceColumn>& columns, const Places& which, std::size_t r, Eigen::Index first,
          double weight, Eigen::Ref<Eigen::MatrixXd> to) {
  for (std::size_t j = 0; j < which.size(); ++j) {
    const ForceColumn& column = columns[static_cast<std::size_t>(which[j])];
    to.col(static_cast<Eigen::Index>(j)) = weight * (*column)[r].segment(first, to.rows());
  }
}

// Leaves out samples that do not count, and adds what the rig may have added as the last columns.
void finish(const log::Record& record, Eigen::Index first, Eigen::MatrixXd& columns) {
  if (record.counts.size() > 0) {
    columns.array().colwise() *= record.counts.segment(first, columns.rows()).array();
  }
  if (record.nuisances.cols() > 0) {
    columns.rightCols(record.nuisances.cols()) = record.nuisances.middleRows(first, columns.rows());
  }
}

// Takes what the rig may have added, the last columns N, out of the products in the blocks of a log:
// (x - N s)'(y - N t), s and t being its shares in the whole log. Returns the squares before that.
Eigen::VectorXd freeOfRig(Eigen::Index rig, Eigen::Index width, std::vector<Eigen::MatrixXd>& grams) {
  Eigen::MatrixXd shares = Eigen::MatrixXd::Zero(rig, width);
  Eigen::VectorXd squares = Eigen::VectorXd::Zero(width);
  for (const Eigen::MatrixXd& gram : grams) {
    shares += gram.bottomLeftCorner(rig, width);
    squares += gram.diagonal().head(width);
  }
  for (Eigen::MatrixXd& gram : grams) {
    const Eigen::MatrixXd on_rig = gram.bottomLeftCorner(rig, width);
    const Eigen::MatrixXd left = on_rig - gram.bottomRightCorner(rig, rig) * shares;
    gram = (gram.topLeftCorner(width, width) - on_rig.transpose() * shares - shares.transpose() * left).eval();
  }
  return squares;
}

}  // namespace

// Sums, not differences: what is zero without a fold has to be so to the last bit.
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
}

BlockGrams BlockGrams::of(const std::vector<Eigen::Index>& unknowns) const {
  const auto part = [&](const Eigen::MatrixXd& all) { return ofUnknowns(all, unknowns); };
  return {element::each(gram, part),        fold, record, weight, part(prior), squares(unknowns), part(sum),
          element::each(without_fold, part)};
}

// What is to be multiplied.
struct LogBlocks::Request {
  const gap::Forces& base;
  const std::vector<ForceColumn>& columns;
  const FreeInLog& free;
  Eigen::Index width;  // of the columns, what is free in all logs, and the residual
  Places fresh;        // columns to be multiplied by all others
  Places known;        // those that no fit changes
  Places index;        // of these among all that no fit changes
};

LogBlocks::LogBlocks(const std::vector<log::Record>& records, std::vector<double> weights,
                     std::vector<ForceColumn> known, int threads)
    : records_(records), weights_(std::move(weights)), known_(std::move(known)), blocks_(records.size()) {
  const auto count = static_cast<Eigen::Index>(known_.size());
  parallelFor(records.size(), threads, [&](std::size_t r) {
    blocks_[r] = cut(records[r]);
    for (Block& block : blocks_[r]) {
      Eigen::MatrixXd columns(block.size, count + records[r].nuisances.cols());
      fill(known_, with({}, 0, count), r, block.first, weights_[r], columns);
      finish(records[r], block.first, columns);
      block.known = numerics::gramOf(columns);
    }
  });
}

// None where no sample counts, as where a sensor gave nothing for some cycles.
std::vector<LogBlocks::Block> LogBlocks::cut(const log::Record& record) {
  const double cycles = record.duration() * record.mean_frequency;
  const auto count =
      static_cast<Eigen::Index>(std::clamp(std::round(cycles / kCyclesPerBlock), kFewestBlocks, kMostBlocks));
  std::vector<Block> blocks;
  for (Eigen::Index b = 0; b < count; ++b) {
    const Eigen::Index first = record.size() * b / count;
    const Eigen::Index size = record.size() * (b + 1) / count - first;
    if (record.counted(first, size) > 0.0) {
      blocks.push_back({first, size, {}});
    }
  }
  return blocks;
}

// What is free in a log, and its residual.
Eigen::MatrixXd LogBlocks::ownOf(const Request& request, std::size_t r) const {
  const Eigen::Index free = request.free.count();
  Eigen::MatrixXd columns(records_[r].size(), free + 1);
  columns.leftCols(free) = weights_[r] * request.free.columns(records_[r], r, request.base[r]);
  columns.col(free) = weights_[r] * (records_[r].force - request.base[r]);
  return columns;
}

// Of the blocks of one log.
std::vector<Eigen::MatrixXd> LogBlocks::productsIn(std::size_t r, const Request& request) const {
  const Eigen::Index rig = records_[r].nuisances.cols();
  const Eigen::Index free = request.free.count();
  const auto first_free = static_cast<Eigen::Index>(request.columns.size()) + free * static_cast<Eigen::Index>(r);
  const Places own = with(with(request.fresh, first_free, free), request.width - 1, 1);
  const Places own_and_rig = with(own, request.width, rig);
  const Places known_and_rig = with(request.known, request.width, rig);
  const Places index = with(request.index, static_cast<Eigen::Index>(known_.size()), rig);
  const Eigen::MatrixXd of_log = ownOf(request, r);
  std::vector<Eigen::MatrixXd> grams;
  for (const Block& block : blocks_[r]) {
    Eigen::MatrixXd columns(block.size, static_cast<Eigen::Index>(own_and_rig.size()));
    fill(request.columns, request.fresh, r, block.first, weights_[r], columns);
    columns.middleCols(static_cast<Eigen::Index>(request.fresh.size()), of_log.cols()) =
        of_log.middleRows(block.first, block.size);
    finish(records_[r], block.first, columns);
    Eigen::MatrixXd& gram = grams.emplace_back(Eigen::MatrixXd::Zero(request.width + rig, request.width + rig));
    gram(own_and_rig, own_and_rig) = numerics::gramOf(columns);
    if (!request.known.empty()) {
      Eigen::MatrixXd known(block.size, static_cast<Eigen::Index>(request.known.size()));
      fill(known_, request.index, r, block.first, weights_[r], known);
      const Eigen::MatrixXd mixed = numerics::productOf(columns.leftCols(static_cast<Eigen::Index>(own.size())), known);
      gram(own, request.known) = mixed;
      gram(request.known, own) = mixed.transpose();
      gram(known_and_rig, known_and_rig) = block.known(index, index);
    }
  }
  return grams;
}

// Trends and zeros of the displacement are in units that count as the standard deviation of their log's force.
Eigen::MatrixXd LogBlocks::priorOf(const Request& request) const {
  Eigen::VectorXd prior = Eigen::VectorXd::Zero(request.width);
  auto place = static_cast<Eigen::Index>(request.columns.size());
  for (std::size_t r = 0; r < records_.size(); ++r, place += request.free.count()) {
    const double force = std::pow(weights_[r] * records_[r].force_deviation, 2) * records_[r].counted();
    prior.segment(place, request.free.count()) = force * request.free.costs(records_[r]).cwiseAbs2();
  }
  return prior.asDiagonal();
}

BlockGrams LogBlocks::normalEquations(const gap::Forces& base, const std::vector<ForceColumn>& columns,
                                      const FreeInLog& free, int threads) const {
  const std::size_t logs = records_.size();
  const std::size_t unknowns = columns.size() + logs * static_cast<std::size_t>(free.count());
  Request request{base, columns, free, static_cast<Eigen::Index>(unknowns) + 1, {}, {}, {}};
  for (std::size_t j = 0; j < columns.size(); ++j) {
    const auto found = std::find(known_.begin(), known_.end(), columns[j]);
    if (columns[j] && found != known_.end()) {
      request.known.push_back(static_cast<Eigen::Index>(j));
      request.index.push_back(found - known_.begin());
    } else if (columns[j]) {
      request.fresh.push_back(static_cast<Eigen::Index>(j));
    }
  }
  std::vector<std::vector<Eigen::MatrixXd>> grams(logs);
  std::vector<Eigen::VectorXd> squares(logs);
  parallelFor(logs, threads, [&](std::size_t r) {
    grams[r] = productsIn(r, request);
    squares[r] = freeOfRig(records_[r].nuisances.cols(), request.width, grams[r]);
  });
  BlockGrams result;
  result.prior = priorOf(request);
  result.squares = Eigen::VectorXd::Zero(request.width);
  for (std::size_t r = 0; r < logs; ++r) {
    result.squares += squares[r];
    const double in_all = records_[r].counted() * static_cast<double>(logs);
    for (std::size_t b = 0; b < blocks_[r].size(); ++b) {
      result.gram.push_back(std::move(grams[r][b]));
      result.fold.push_back(static_cast<int>(b + r) % kFolds);
      result.record.push_back(static_cast<int>(r));
      result.weight.push_back(records_[r].weight * records_[r].counted(blocks_[r][b].first, blocks_[r][b].size) /
                              in_all);
    }
  }
  return result;
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
  for (std::size_t b = 0; b < blocks.gram.size(); ++b) {
    const double error = squaresLeft(blocks.gram[b], by_fold[static_cast<std::size_t>(blocks.fold[b])]);
    errors.push_back(std::isfinite(error) ? std::max(error, 0.0) / blocks.weight[b]
                                          : std::numeric_limits<double>::infinity());
  }
  return errors;
}

}  // namespace rubber_suspension::fit
