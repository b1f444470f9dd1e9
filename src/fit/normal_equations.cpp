// Products of columns by blocks of the logs.
#include "fit/normal_equations.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fit/bounded_least_squares.h"
#include "fit/gram.h"
#include "fit/parallel.h"

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

// The columns of the least squares: derivatives of the force, what is free in each log, and last the residual.
struct Columns {
  const std::vector<log::Record>& records;
  const std::vector<double>& weights;
  const std::vector<Eigen::VectorXd>& base;
  const std::vector<ForceColumn>& derivatives;
  FreeInLog free;
  Eigen::Index width;

  // Which of them are not zero in a block: those of the model, of what is free in its own log, and the residual.
  std::vector<Eigen::Index> placesIn(const Rows& rows) const {
    std::vector<Eigen::Index> places;
    const auto modelled = static_cast<Eigen::Index>(derivatives.size());
    for (Eigen::Index j = 0; j < modelled; ++j) {
      if (derivatives[static_cast<std::size_t>(j)]) {
        places.push_back(j);
      }
    }
    for (Eigen::Index j = 0; j < free.count(); ++j) {
      places.push_back(modelled + free.count() * static_cast<Eigen::Index>(rows.record) + j);
    }
    places.push_back(width - 1);
    return places;
  }

  // Their rows of a block; 0 where samples do not count.
  Eigen::MatrixXd in(const Rows& rows) const {
    const log::Record& record = records[rows.record];
    const double weight = weights[rows.record];
    const Eigen::Index size = rows.last - rows.first;
    const std::vector<Eigen::Index> places = placesIn(rows);
    const auto count = static_cast<Eigen::Index>(places.size());
    const Eigen::Index from_model = count - free.count() - 1;
    Eigen::MatrixXd local(size, count);
    for (Eigen::Index j = 0; j < from_model; ++j) {
      const auto& column = *derivatives[static_cast<std::size_t>(places[static_cast<std::size_t>(j)])];
      local.col(j) = weight * column[rows.record].segment(rows.first, size);
    }
    fillFreeInLog(free, record, base[rows.record], rows.first, weight, local.middleCols(from_model, free.count()));
    local.rightCols<1>() = weight * (record.force - base[rows.record]).segment(rows.first, size);
    if (record.counts.size() > 0) {
      local.array().colwise() *= record.counts.segment(rows.first, size).array();
    }
    return local;
  }
};

// By how much each nuisance of a log is in each of its columns; empty for logs without nuisances.
std::vector<Eigen::MatrixXd> sharesOfNuisances(const Columns& columns, const std::vector<Rows>& blocks, int threads) {
  std::vector<Eigen::MatrixXd> shares(columns.records.size());
  parallelFor(shares.size(), threads, [&](std::size_t r) {
    const Eigen::MatrixXd& nuisances = columns.records[r].nuisances;
    if (nuisances.cols() == 0) {
      return;
    }
    for (const Rows& rows : blocks) {
      if (rows.record == r) {
        const Eigen::MatrixXd share =
            nuisances.middleRows(rows.first, rows.last - rows.first).transpose() * columns.in(rows);
        shares[r] = shares[r].size() == 0 ? share : (shares[r] + share).eval();
      }
    }
  });
  return shares;
}

// A small matrix at its places in one of this width.
Eigen::MatrixXd spreadOut(const Eigen::MatrixXd& small, const std::vector<Eigen::Index>& places, Eigen::Index width) {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(width, width);
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t j = 0; j < places.size(); ++j) {
      result(places[i], places[j]) = small(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
    }
  }
  return result;
}

}  // namespace

// Sums, not differences: what is zero without a fold has to be so to the last bit.
void BlockGrams::sumUp() {
  sum = prior;
  without_fold.assign(kFolds, prior);
  for (std::size_t b = 0; b < gram.size(); ++b) {
    sum += gram[b];
    for (int other = 0; other < kFolds; ++other) {
      if (other != fold[b]) {
        without_fold[static_cast<std::size_t>(other)] += gram[b];
      }
    }
  }
}

BlockGrams normalEquations(const std::vector<log::Record>& records, const std::vector<double>& weights,
                           const std::vector<Eigen::VectorXd>& base, const std::vector<ForceColumn>& columns,
                           FreeInLog free, int threads) {
  const auto logs = static_cast<Eigen::Index>(records.size());
  const Eigen::Index width = static_cast<Eigen::Index>(columns.size()) + free.count() * logs + 1;
  const std::vector<Rows> blocks = cut(records);
  const Columns all{records, weights, base, columns, free, width};
  const std::vector<Eigen::MatrixXd> shares = sharesOfNuisances(all, blocks, threads);
  BlockGrams result;
  result.gram.resize(blocks.size());
  parallelFor(blocks.size(), threads, [&](std::size_t b) {
    const Rows& rows = blocks[b];
    const log::Record& record = records[rows.record];
    Eigen::MatrixXd local = all.in(rows);
    if (record.nuisances.cols() > 0) {
      local -= record.nuisances.middleRows(rows.first, rows.last - rows.first) * shares[rows.record];
    }
    result.gram[b] = spreadOut(gramOf(local), all.placesIn(rows), width);
  });
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

std::vector<double> crossValidate(const BlockGrams& blocks, const std::vector<Eigen::Index>& columns,
                                  const Eigen::VectorXd& lower, const Eigen::VectorXd& upper) {
  const auto count = static_cast<Eigen::Index>(columns.size());
  const Eigen::Index last = blocks.gram[0].rows() - 1;
  std::vector<double> errors(blocks.gram.size());
  Eigen::MatrixXd small(count, count);
  Eigen::VectorXd moment(count);
  for (int fold = 0; fold < kFolds; ++fold) {
    const Eigen::MatrixXd& total = blocks.without_fold[static_cast<std::size_t>(fold)];
    for (Eigen::Index i = 0; i < count; ++i) {
      const auto row = columns[static_cast<std::size_t>(i)];
      moment[i] = total(row, last);
      for (Eigen::Index j = 0; j < count; ++j) {
        small(i, j) = total(row, columns[static_cast<std::size_t>(j)]);
      }
    }
    const Eigen::VectorXd x = boundedLeastSquares(small, moment, lower, upper);
    for (std::size_t b = 0; b < blocks.gram.size(); ++b) {
      if (blocks.fold[b] != fold) {
        continue;
      }
      const Eigen::MatrixXd& gram = blocks.gram[b];
      double error = gram(last, last);
      for (Eigen::Index i = 0; i < count; ++i) {
        const auto row = columns[static_cast<std::size_t>(i)];
        error -= 2.0 * x[i] * gram(row, last);
        for (Eigen::Index j = 0; j < count; ++j) {
          error += x[i] * x[j] * gram(row, columns[static_cast<std::size_t>(j)]);
        }
      }
      errors[b] =
          std::isfinite(error) ? std::max(error, 0.0) / blocks.weight[b] : std::numeric_limits<double>::infinity();
    }
  }
  return errors;
}

}  // namespace rubber_suspension::fit
