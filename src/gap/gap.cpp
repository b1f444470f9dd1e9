// Computes the gap and its noise floor.
#include "rubber_suspension/gap/gap.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "numerics/elimination.h"
#include "numerics/gram.h"
#include "numerics/least_squares.h"

namespace rubber_suspension::gap {
namespace {

// Returns the products of residual, fit parameters of the log and errors of the rig over a part of a record.
Eigen::MatrixXd productsOver(const PreparedRecord& record, const Eigen::VectorXd& residual, const OwnUnknowns& own,
                             Eigen::Index first, Eigen::Index count) {
  const Eigen::Index rig = record.rig.columns.cols();
  Eigen::MatrixXd columns(count, 1 + own.columns.cols() + rig);
  columns.col(0) = residual.segment(first, count);
  if (own.columns.cols() > 0) {  // an empty matrix has no address
    columns.middleCols(1, own.columns.cols()) = own.columns.middleRows(first, count);
  }
  if (record.counts.size() > 0) {
    columns.array().colwise() *= record.counts.segment(first, count).array();
  }
  if (rig > 0) {
    columns.rightCols(rig) = record.rig.columns.middleRows(first, count);
  }
  return numerics::gramOf(columns);
}

void addParts(const PreparedRecord& record, const Eigen::VectorXd& residual, const OwnUnknowns& own, int log,
              std::vector<PartError>& parts) {
  constexpr Eigen::Index kParts = 10;
  std::vector<Eigen::MatrixXd> products;
  numerics::BlockPlaces places;
  places.in_sample = false;
  for (Eigen::Index p = 0; p < kParts; ++p) {
    const Eigen::Index first = record.size() * p / kParts;
    const Eigen::Index count = record.size() * (p + 1) / kParts - first;
    const double counted = record.counted(first, count);
    if (counted > 0.0) {
      products.push_back(productsOver(record, residual, own, first, count));
      places.fold.push_back(places.folds++);
      places.share.push_back(counted / record.counted());
    }
  }
  numerics::BlockProducts left =
      numerics::withoutErrors(products, numerics::penaltyOfWhitening(record.rig.columns), places);
  if (own.penalty.size() > 0) {
    Eigen::MatrixXd shares;
    left = numerics::withoutUnknowns(left, own.penalty, places, shares);
  }
  for (std::size_t p = 0; p < places.share.size(); ++p) {
    const double square = std::max(0.0, left.held_out[p](0, 0)) / std::pow(record.force_deviation, 2);
    parts.push_back({square / (places.share[p] * record.counted()), record.weight * places.share[p], log});
  }
}

}  // namespace

double relativeGap(const std::vector<double>& measured, const std::vector<double>& simulated,
                   const std::vector<double>& counts) {
  if (measured.empty() || measured.size() != simulated.size()) {
    throw std::invalid_argument(
        fmt::format("there are {} measured and {} simulated forces; accepted: equal numbers, at least 1",
                    measured.size(), simulated.size()));
  }
  const auto counted = [&](std::size_t i) { return counts.empty() || counts[i] > 0.0; };
  double sum = 0.0;
  double number = 0.0;
  for (std::size_t i = 0; i < measured.size(); ++i) {
    sum += counted(i) ? measured[i] : 0.0;
    number += counted(i) ? 1.0 : 0.0;
  }
  const double mean = sum / number;
  double gap = 0.0;
  double variance = 0.0;
  for (std::size_t i = 0; i < measured.size(); ++i) {
    if (counted(i)) {
      gap += (measured[i] - simulated[i]) * (measured[i] - simulated[i]);
      variance += (measured[i] - mean) * (measured[i] - mean);
    }
  }
  if (!(variance > 0.0)) {
    throw std::invalid_argument(
        fmt::format("the measured force is {:g} N throughout; accepted: a varying force", mean));
  }
  return std::sqrt(gap / variance);
}

double standardDeviation(const Eigen::VectorXd& values) {
  return std::sqrt((values.array() - values.mean()).square().mean());
}

double gapOfResidual(const Eigen::VectorXd& residual, double standard_deviation) {
  return std::sqrt(residual.squaredNorm() / static_cast<double>(residual.size())) / standard_deviation;
}

double residualAboveFloor(double gap, double floor) { return std::sqrt(std::max(0.0, gap * gap - floor * floor)); }

double closedFraction(double before, double after, double floor) {
  const double closable = before - floor;
  return closable > 1e-12 ? std::clamp((before - after) / closable, -1.0, kMostClosed) : 0.0;
}

double gapOfParts(const std::vector<PartError>& parts) {
  double sum = 0.0;
  double weight = 0.0;
  for (const PartError& part : parts) {
    sum += part.weight * part.error;
    weight += part.weight;
  }
  return std::sqrt(sum / weight);
}

std::vector<PartError> partErrors(const std::vector<PreparedRecord>& records,
                                  const std::vector<Eigen::VectorXd>& simulated, const std::vector<OwnUnknowns>& own) {
  std::vector<PartError> parts;
  for (std::size_t r = 0; r < records.size(); ++r) {
    const OwnUnknowns none{Eigen::MatrixXd(records[r].size(), 0), Eigen::VectorXd(0)};
    addParts(records[r], records[r].force - simulated[r], own.empty() ? none : own[r], static_cast<int>(r), parts);
  }
  return parts;
}

double whiteNoiseFloor(const log::Record& record, const Eigen::VectorXd& residual) {
  const double edge = std::min(3.0 * record.highest_frequency, 0.3 / record.dt);
  return std::min(log::whiteNoiseAbove(residual, record.dt, edge),
                  log::whiteNoiseAbove(record.force, record.dt, edge)) /
         record.force_deviation;
}

}  // namespace rubber_suspension::gap
