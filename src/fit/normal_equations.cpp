// Products of columns by blocks of the logs.
#include "fit/normal_equations.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "fit/gram.h"
#include "fit/parallel.h"
#include "numerics/bounded_least_squares.h"

namespace rubber_suspension::fit {
namespace {

constexpr double kCyclesPerBlock = 4.0;  // of the motion's mean frequency: longer than what a residual remembers
constexpr double kMostBlocks = 24.0;
constexpr double kFewestBlocks = 8.0;

int blocksOf(const log::Record& record) {
  const double cycles = record.duration() * record.mean_frequency;
  return static_cast<int>(std::clamp(std::round(cycles / kCyclesPerBlock), kFewestBlocks, kMostBlocks));
}

// Samples of a log.
struct Rows {
  std::size_t record;
  Eigen::Index first;
  Eigen::Index last;  // the one after them
};

// Blocks of the logs; none where no sample counts, as where a sensor gave nothing for some cycles.
std::vector<Rows> cut(const std::vector<log::Record>& records) {
  std::vector<Rows> blocks;
  for (std::size_t r = 0; r < records.size(); ++r) {
    const Eigen::Index size = records[r].size();
    const int count = blocksOf(records[r]);
    for (int b = 0; b < count; ++b) {
      const Rows rows{r, size * b / count, size * (b + 1) / count};
      if (records[r].counted(rows.first, rows.last - rows.first) > 0.0) {
        blocks.push_back(rows);
      }
    }
  }
  return blocks;
}

// Columns over some samples, weighted.
Eigen::MatrixXd blockOf(const std::vector<ForceColumn>& columns, const Rows& rows, double weight) {
  const Eigen::Index count = rows.last - rows.first;
  Eigen::MatrixXd matrix(count, static_cast<Eigen::Index>(columns.size()));
  for (std::size_t j = 0; j < columns.size(); ++j) {
    matrix.col(static_cast<Eigen::Index>(j)) = weight * (*columns[j])[rows.record].segment(rows.first, count);
  }
  return matrix;
}

void maskOut(const log::Record& record, Eigen::Ref<Eigen::MatrixXd> columns) {
  if (record.counts.size() > 0) {
    columns.array().colwise() *= record.counts.array();
  }
}

// Columns of one log, and what is in the nuisances of each block of it.
struct OfBlock {
  Eigen::MatrixXd products;      // of columns with each other; within OfLog freed of the nuisances
  Eigen::MatrixXd on_nuisances;  // of nuisances with columns
  Eigen::MatrixXd nuisances;     // of nuisances with each other
};

// `columns`: the rows of the block.
OfBlock productsIn(const Rows& rows, const log::Record& record, const Eigen::Ref<const Eigen::MatrixXd>& columns) {
  const Eigen::Index count = columns.cols();
  const Eigen::Index rig = record.nuisances.cols();
  Eigen::MatrixXd local(columns.rows(), count + rig);
  local.leftCols(count) = columns;
  if (rig > 0) {
    local.rightCols(rig) = record.nuisances.middleRows(rows.first, local.rows());
  }
  const Eigen::MatrixXd gram = gramOf(local);
  return {gram.topLeftCorner(count, count), gram.bottomLeftCorner(rig, count), gram.bottomRightCorner(rig, rig)};
}

// Products of some columns with others once each log is freed of its nuisances: (x - N s)'(y - N t) of a block, s and t
// being the shares of the nuisances in the whole log.
Eigen::MatrixXd freed(const Eigen::MatrixXd& products, const Eigen::MatrixXd& nuisances, const Eigen::MatrixXd& of_x,
                      const Eigen::MatrixXd& s, const Eigen::MatrixXd& of_y, const Eigen::MatrixXd& t) {
  if (nuisances.cols() == 0) {
    return products;
  }
  return products - s.transpose() * of_y - of_x.transpose() * t + s.transpose() * (nuisances * t);
}

// The blocks of one log.
struct OfLog {
  std::vector<OfBlock> blocks;
  Eigen::MatrixXd shares;   // of the nuisances in the columns
  Eigen::VectorXd squares;  // of the columns, with what the rig may have added
};

// From place `first` on among all blocks, for columns over the rows of a block.
OfLog productsOver(const std::vector<Rows>& blocks, std::size_t first, std::size_t r, const log::Record& record,
                   const std::function<Eigen::MatrixXd(const Rows& rows)>& columns) {
  OfLog result;
  for (std::size_t b = first; b < blocks.size() && blocks[b].record == r; ++b) {
    result.blocks.push_back(productsIn(blocks[b], record, columns(blocks[b])));
    const OfBlock& block = result.blocks.back();
    if (b == first) {
      result.shares = Eigen::MatrixXd::Zero(block.on_nuisances.rows(), block.on_nuisances.cols());
      result.squares = Eigen::VectorXd::Zero(block.products.cols());
    }
    result.shares += block.on_nuisances;
    result.squares += block.products.diagonal();
  }
  for (OfBlock& block : result.blocks) {
    block.products =
        freed(block.products, block.nuisances, block.on_nuisances, result.shares, block.on_nuisances, result.shares);
  }
  return result;
}

// The columns of the least squares: derivatives of the force, what is free in each log, and last the residual.
struct Columns {
  const std::vector<log::Record>& records;
  const std::vector<double>& weights;
  const std::vector<Eigen::VectorXd>& base;
  const std::vector<ForceColumn>& derivatives;
  FreeInLog free;
  const KnownColumns* known;
  const ForceColumn& by_zero;

  Eigen::Index width() const {
    return static_cast<Eigen::Index>(derivatives.size()) + free.count() * static_cast<Eigen::Index>(records.size()) + 1;
  }
};

// The same, sorted by what has to be multiplied.
struct Sorted {
  std::vector<ForceColumn> fresh;
  std::vector<Eigen::Index> fresh_places;
  std::vector<ForceColumn> known;
  std::vector<Eigen::Index> known_places;
  std::vector<Eigen::Index> known_index;  // among KnownColumns
};

Sorted sortedBy(const KnownColumns* known, const std::vector<ForceColumn>& derivatives) {
  Sorted sorted;
  for (std::size_t j = 0; j < derivatives.size(); ++j) {
    const Eigen::Index index = derivatives[j] && known != nullptr ? known->find(derivatives[j]) : -1;
    if (index >= 0) {
      sorted.known.push_back(derivatives[j]);
      sorted.known_places.push_back(static_cast<Eigen::Index>(j));
      sorted.known_index.push_back(index);
    } else if (derivatives[j]) {
      sorted.fresh.push_back(derivatives[j]);
      sorted.fresh_places.push_back(static_cast<Eigen::Index>(j));
    }
  }
  return sorted;
}

// Those that are to be multiplied in one log: derivatives, what is free in it, its residual.
Eigen::MatrixXd freshOver(const Columns& all, const Sorted& sorted, std::size_t r) {
  const log::Record& record = all.records[r];
  const auto derivatives = static_cast<Eigen::Index>(sorted.fresh.size());
  Eigen::MatrixXd columns(record.size(), derivatives + all.free.count() + 1);
  columns.leftCols(derivatives) = blockOf(sorted.fresh, {r, 0, record.size()}, all.weights[r]);
  fillFreeInLog(all.free, record, all.base[r], all.by_zero ? (*all.by_zero)[r] : Eigen::VectorXd(), 0, all.weights[r],
                columns.middleCols(derivatives, all.free.count()));
  columns.rightCols<1>() = all.weights[r] * (record.force - all.base[r]);
  maskOut(record, columns);
  return columns;
}

std::vector<Eigen::Index> placesOfFresh(const Columns& all, const Sorted& sorted, std::size_t r) {
  std::vector<Eigen::Index> places = sorted.fresh_places;
  const Eigen::Index of_log = all.free.count();
  const auto first = static_cast<Eigen::Index>(all.derivatives.size()) + of_log * static_cast<Eigen::Index>(r);
  for (Eigen::Index j = 0; j < of_log; ++j) {
    places.push_back(first + j);
  }
  places.push_back(all.width() - 1);
  return places;
}

void place(const Eigen::MatrixXd& small, const std::vector<Eigen::Index>& rows,
           const std::vector<Eigen::Index>& columns, Eigen::MatrixXd& gram) {
  gram(rows, columns) = small;
  gram(columns, rows) = small.transpose();
}

// Grams of the blocks of one log, from place `first` on among all blocks.
void fillGrams(const Columns& all, const Sorted& sorted, std::size_t r, std::size_t first,
               const std::vector<Rows>& blocks, std::vector<Eigen::MatrixXd>& grams, Eigen::VectorXd& squares) {
  const log::Record& record = all.records[r];
  const Eigen::MatrixXd fresh = freshOver(all, sorted, r);
  const std::vector<Eigen::Index> places = placesOfFresh(all, sorted, r);
  const OfLog of_fresh = productsOver(blocks, first, r, record, [&](const Rows& rows) {
    return Eigen::MatrixXd(fresh.middleRows(rows.first, rows.last - rows.first));
  });
  if (of_fresh.blocks.empty()) {
    return;
  }
  squares(places) = of_fresh.squares;
  const bool known = !sorted.known.empty();
  Eigen::MatrixXd known_shares;
  if (known) {
    known_shares = all.known->shares(r)(Eigen::all, sorted.known_index);
  }
  for (std::size_t i = 0; i < of_fresh.blocks.size(); ++i) {
    const Rows& rows = blocks[first + i];
    const OfBlock& block = of_fresh.blocks[i];
    Eigen::MatrixXd& gram = grams[first + i];
    gram = Eigen::MatrixXd::Zero(all.width(), all.width());
    place(block.products, places, places, gram);
    if (!known) {
      continue;
    }
    const Eigen::MatrixXd of_block = blockOf(sorted.known, rows, all.weights[r]);
    const Eigen::MatrixXd mixed = fresh.middleRows(rows.first, of_block.rows()).transpose() * of_block;
    const Eigen::MatrixXd on_nuisances = all.known->onNuisances(first + i)(Eigen::all, sorted.known_index);
    place(freed(mixed, block.nuisances, block.on_nuisances, of_fresh.shares, on_nuisances, known_shares), places,
          sorted.known_places, gram);
    gram(sorted.known_places, sorted.known_places) =
        all.known->products(first + i)(sorted.known_index, sorted.known_index);
  }
}

// Trends and zeros of the displacement are in units that count as the standard deviation of their log's force.
Eigen::MatrixXd priorOfFree(const Columns& all) {
  Eigen::MatrixXd prior = Eigen::MatrixXd::Zero(all.width(), all.width());
  auto of_log = prior.diagonal().tail(prior.rows() - static_cast<Eigen::Index>(all.derivatives.size()));
  for (std::size_t r = 0; r < all.records.size(); ++r) {
    const log::Record& record = all.records[r];
    const Eigen::Index first = all.free.count() * static_cast<Eigen::Index>(r);
    const Eigen::Index trends = all.free.trend ? kTrendsPerLog : 0;
    const double force = std::pow(all.weights[r] * record.force_deviation, 2) * record.counted();
    of_log.segment(first, trends) = force * costsOfTrends(record).head(trends).cwiseAbs2();
    if (all.free.zero) {
      of_log[first + trends] = force;
    }
  }
  return prior;
}

// The first block of each log, by its place among all; a log none of whose blocks counts has that of the next.
std::vector<std::size_t> firstBlocks(const std::vector<Rows>& blocks, std::size_t logs) {
  std::vector<std::size_t> first(logs, 0);
  for (std::size_t r = 0; r < logs; ++r) {
    while (first[r] < blocks.size() && blocks[first[r]].record < r) {
      ++first[r];
    }
  }
  return first;
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

KnownColumns::KnownColumns(const std::vector<log::Record>& records, const std::vector<double>& weights,
                           std::vector<ForceColumn> columns, int threads)
    : columns_(std::move(columns)), shares_(records.size()), squares_(records.size()) {
  for (std::size_t j = 0; j < columns_.size(); ++j) {
    places_[columns_[j].get()] = static_cast<Eigen::Index>(j);
  }
  const std::vector<Rows> blocks = cut(records);
  const std::vector<std::size_t> first = firstBlocks(blocks, records.size());
  products_.resize(blocks.size());
  on_nuisances_.resize(blocks.size());
  parallelFor(records.size(), threads, [&](std::size_t r) {
    OfLog of_log = productsOver(blocks, first[r], r, records[r], [&](const Rows& rows) {
      Eigen::MatrixXd local = blockOf(columns_, rows, weights[r]);
      if (records[r].counts.size() > 0) {
        local.array().colwise() *= records[r].counts.segment(rows.first, local.rows()).array();
      }
      return local;
    });
    for (std::size_t i = 0; i < of_log.blocks.size(); ++i) {
      products_[first[r] + i] = std::move(of_log.blocks[i].products);
      on_nuisances_[first[r] + i] = std::move(of_log.blocks[i].on_nuisances);
    }
    shares_[r] = std::move(of_log.shares);
    squares_[r] = std::move(of_log.squares);
  });
}

double KnownColumns::squares(Eigen::Index column) const {
  double sum = 0.0;
  for (const Eigen::VectorXd& of_record : squares_) {
    sum += of_record.size() > 0 ? of_record[column] : 0.0;
  }
  return sum;
}

Eigen::Index KnownColumns::find(const ForceColumn& column) const {
  const auto found = places_.find(column.get());
  return found == places_.end() ? -1 : found->second;
}

BlockGrams normalEquations(const std::vector<log::Record>& records, const std::vector<double>& weights,
                           const std::vector<Eigen::VectorXd>& base, const std::vector<ForceColumn>& columns,
                           FreeInLog free, int threads, const KnownColumns* known, const ForceColumn& by_zero) {
  const auto logs = static_cast<Eigen::Index>(records.size());
  const std::vector<Rows> blocks = cut(records);
  const std::vector<std::size_t> first_block = firstBlocks(blocks, records.size());
  const Columns all{records, weights, base, columns, free, known, by_zero};
  const Sorted sorted = sortedBy(known, columns);
  BlockGrams result;
  result.gram.resize(blocks.size());
  std::vector<Eigen::VectorXd> squares(records.size(), Eigen::VectorXd::Zero(all.width()));
  parallelFor(records.size(), threads,
              [&](std::size_t r) { fillGrams(all, sorted, r, first_block[r], blocks, result.gram, squares[r]); });
  result.squares = Eigen::VectorXd::Zero(all.width());
  for (const Eigen::VectorXd& of_log : squares) {
    result.squares += of_log;
  }
  for (std::size_t j = 0; j < sorted.known.size(); ++j) {
    result.squares[sorted.known_places[j]] = known->squares(sorted.known_index[j]);
  }
  result.prior = priorOfFree(all);
  int place = 0;  // among the blocks of its log
  for (const Rows& rows : blocks) {
    const log::Record& record = records[rows.record];
    const bool first = result.record.empty() || result.record.back() != static_cast<int>(rows.record);
    place = first ? 0 : place + 1;
    result.fold.push_back((place + static_cast<int>(rows.record)) % kFolds);
    result.record.push_back(static_cast<int>(rows.record));
    result.weight.push_back(record.weight * record.counted(rows.first, rows.last - rows.first) /
                            (record.counted() * static_cast<double>(logs)));
  }
  return result;
}

Eigen::VectorXd solveColumns(const Eigen::MatrixXd& gram, const std::vector<Eigen::Index>& columns,
                             const Eigen::VectorXd& lower, const Eigen::VectorXd& upper) {
  return numerics::boundedLeastSquares(gram(columns, columns), gram(columns, gram.cols() - 1), lower, upper);
}

Eigen::VectorXd solveAll(const Eigen::MatrixXd& gram, const Eigen::VectorXd& lower, const Eigen::VectorXd& upper) {
  const Eigen::Index last = gram.cols() - 1;
  return numerics::boundedLeastSquares(gram.topLeftCorner(last, last), gram.col(last).head(last), lower, upper);
}

double squaresLeft(const Eigen::MatrixXd& gram, const std::vector<Eigen::Index>& columns,
                   const Eigen::VectorXd& coefficients) {
  const Eigen::Index last = gram.cols() - 1;
  const Eigen::MatrixXd of_columns = gram(columns, columns);
  const Eigen::VectorXd moment = gram(columns, last);
  return gram(last, last) - coefficients.dot(2.0 * moment - of_columns * coefficients);
}

std::vector<double> crossValidate(const BlockGrams& blocks, const std::vector<Eigen::Index>& columns,
                                  const std::function<Eigen::VectorXd(const Eigen::MatrixXd& gram)>& solve) {
  std::vector<double> errors(blocks.gram.size());
  for (std::size_t fold = 0; fold < blocks.without_fold.size(); ++fold) {
    const Eigen::VectorXd x = solve(blocks.without_fold[fold]);
    for (std::size_t b = 0; b < blocks.gram.size(); ++b) {
      if (blocks.fold[b] == static_cast<int>(fold)) {
        const double error = squaresLeft(blocks.gram[b], columns, x);
        errors[b] =
            std::isfinite(error) ? std::max(error, 0.0) / blocks.weight[b] : std::numeric_limits<double>::infinity();
      }
    }
  }
  return errors;
}

std::vector<double> crossValidate(const BlockGrams& blocks, const std::vector<Eigen::Index>& columns,
                                  const Eigen::VectorXd& lower, const Eigen::VectorXd& upper) {
  return crossValidate(blocks, columns,
                       [&](const Eigen::MatrixXd& gram) { return solveColumns(gram, columns, lower, upper); });
}

}  // namespace rubber_suspension::fit
