// Accounts for the errors that were removed from each log.
#include "diagnosis/results/taken_out.h"

#include <algorithm>
#include <cmath>

#include "diagnosis/hypotheses/unseen_logs.h"
#include "element/each.h"
#include "fit/free_in_log.h"
#include "gap/drive.h"
#include "numerics/gram.h"
#include "numerics/symmetric.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/gap/gap.h"
#include "rubber_suspension/io/rig_tolerances.h"
#include "rubber_suspension/measurement/rig_model.h"

namespace rubber_suspension::diagnosis::results {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

double meanSquare(const VectorXd& residual, const VectorXd& counts) {
  return residual.cwiseProduct(counts).squaredNorm() / counts.sum();
}

VectorXd countsOf(const log::Record& record) {
  return record.counts.size() == 0 ? VectorXd::Ones(record.size()).eval() : record.counts;
}

// Lets the first cycle of a log that starts in motion count as well, except where its force was not measured.
VectorXd withStart(VectorXd counts, const VectorXd& measured) {
  for (Index i = 0; i < counts.size() && counts[i] == 0.0; ++i) {
    counts[i] = measured.size() == 0 ? 1.0 : measured[i];
  }
  return counts;
}

using Displacements = std::vector<VectorXd>;

// Returns the forces on the same records when other displacements drive the elements.
gap::Forces simulateOver(const std::vector<element::ElementDescription>& elements,
                         const std::vector<gap::PreparedRecord>& of_the_fit,
                         const std::vector<gap::PreparedRecord>& held_out, const Displacements& displacements) {
  gap::Forces forces = gap::simulate(elements, of_the_fit, gap::drivenBy(displacements, of_the_fit));
  for (std::size_t i = 0; i < held_out.size(); ++i) {
    const VectorXd& z = displacements[of_the_fit.size() + i];
    forces.push_back(gap::simulate(elements, {held_out[i]}, [&](const log::Record&) { return z; }).front());
  }
  return forces;
}

// Effect of each error of the rig on the force, as one column per error, and the kind under which it is reported.
struct KindColumns {
  std::vector<std::string> kinds;
  Eigen::MatrixXd columns;
};

const char* kindOf(measurement::Nuisance nuisance) {
  switch (nuisance) {
    case measurement::Nuisance::force_zero:
      return taken_out::kZero;
    case measurement::Nuisance::gain:
      return taken_out::kGain;
    case measurement::Nuisance::initial_state:
      return taken_out::kInitialState;
    case measurement::Nuisance::displacement_zero:
      return taken_out::kDisplacement;
    default:
      return taken_out::kDelay;
  }
}

// Returns columns that span slow changes over the whole log: a straight line and half cosines.
Eigen::MatrixXd driftColumns(Index samples) {
  constexpr Index kCosines = 8;
  const auto count = static_cast<double>(samples);
  Eigen::MatrixXd columns(samples, kCosines + 1);
  columns.col(0) = VectorXd::LinSpaced(samples, -1.0, 1.0);
  for (Index k = 1; k <= kCosines; ++k) {
    columns.col(k) =
        (Eigen::ArrayXd::LinSpaced(samples, 0.5, count - 0.5) * (element::kPi * static_cast<double>(k) / count)).cos();
  }
  return columns;
}

KindColumns kindColumns(const log::Record& record, const VectorXd& simulated) {
  const measurement::RigColumns rig =
      measurement::RigModel({record}, {}, io::RigTolerances{}).columns({simulated}, {}).front();
  const Eigen::MatrixXd drift = driftColumns(record.size());
  KindColumns result;
  for (const measurement::Nuisance nuisance : rig.nuisances) {
    result.kinds.emplace_back(kindOf(nuisance));
  }
  result.kinds.insert(result.kinds.end(), static_cast<std::size_t>(drift.cols()), taken_out::kDrift);
  result.columns.resize(record.size(), rig.columns.cols() + drift.cols());
  result.columns << rig.columns, drift;
  return result;
}

// Divides the part of the residual that errors of the rig explain among the kinds of errors. A kind counts by the share
// of its column that these errors explain.
void takeNuisances(const gap::PreparedRecord& record, const VectorXd& counts, const VectorXd& simulated,
                   LogAccount& account) {
  constexpr double kRidge = 1e-6;
  const VectorXd residual = (record.force - simulated).cwiseProduct(counts);
  const VectorXd left = record.withoutRig(residual);
  const double scale = counts.sum() * std::pow(record.force_deviation, 2);
  if (record.rig.columns.cols() > 0) {
    const VectorXd taken = residual - left;
    KindColumns kinds = kindColumns(record, simulated);
    for (Index j = 0; j < kinds.columns.cols(); ++j) {
      const VectorXd column = kinds.columns.col(j).cwiseProduct(counts).normalized();
      kinds.columns.col(j) = (1.0 - record.withoutRig(column).norm()) * column;
    }
    const Index size = kinds.columns.cols();
    const Eigen::MatrixXd gram = numerics::gramOf(kinds.columns) + kRidge * Eigen::MatrixXd::Identity(size, size);
    const VectorXd values = numerics::Cholesky(gram).solve(VectorXd(kinds.columns.transpose() * taken));
    // |residual|^2 - |left|^2 is the product of `taken` and `both`. This product is linear in what was removed.
    const VectorXd both = residual + left;
    for (Index j = 0; j < size; ++j) {
      const double square = values[j] * kinds.columns.col(j).dot(both) / scale;
      account.takeOut(kinds.kinds[static_cast<std::size_t>(j)], account.left() - square);
    }
  }
}

// Forces of the elements for two displacements: as recorded, and after missing samples have been bridged.
struct Stages {
  gap::Forces recorded;
  gap::Forces bridged;
};

LogAccount accountOf(const gap::PreparedRecord& record, const prepare::RawChannels& raw, const Stages& forces,
                     std::size_t r, const fit::PerLogNuisances& free) {
  const double variance = std::pow(record.force_deviation, 2);
  const auto listOf = [](const VectorXd& values) { return std::vector<double>(values.begin(), values.end()); };
  const double recorded = gap::relativeGap(listOf(raw.force), listOf(forces.recorded[r]), listOf(raw.counts));
  LogAccount account(record.name, recorded * recorded);
  const VectorXd counts = countsOf(record);
  const VectorXd residual = record.force - forces.bridged[r];
  const VectorXd measured = withStart(counts, raw.counts);
  const bool has_line = raw.line.size() > 0;
  account.takeOut(taken_out::kSpikes,
                  meanSquare(has_line ? VectorXd(residual + raw.line) : residual, measured) / variance);
  if (has_line) {
    account.takeOut(taken_out::kLine, meanSquare(residual, measured) / variance);
  }
  account.takeOut(taken_out::kInitialState, meanSquare(residual, counts) / variance);
  takeNuisances(record, counts, forces.bridged[r], account);
  // As for gaps, the errors of the rig that are removed from a part of the log are estimated from its other parts. A
  // reduction that belongs to no other kind counts as initial state.
  const auto without = [&](const fit::PerLogNuisances& also) {
    const double gap =
        gap::gapOfParts(gap::partErrors({record}, {forces.bridged[r]}, {also.unknowns(record, r, forces.bridged[r])}));
    return gap * gap;
  };
  account.takeOut(taken_out::kInitialState, without({}));
  if (free.by_zero) {
    account.takeOut(taken_out::kDisplacement, without({false, false, false, free.by_zero}));
  }
  if (free.trend) {
    account.takeOut(taken_out::kDrift, without({true, false, false, free.by_zero}));
  }
  if (free.by_factor) {
    account.takeOut(taken_out::kFriction, without(free));
  }
  return account;
}

// Returns the change of the force by an offset of the displacement, for each record.
std::vector<VectorXd> byZeros(const std::vector<element::ElementDescription>& elements,
                              const std::vector<gap::PreparedRecord>& of_the_fit,
                              const std::vector<gap::PreparedRecord>& held_out) {
  std::vector<VectorXd> columns = fit::byZero(elements, of_the_fit);
  for (const gap::PreparedRecord& record : held_out) {
    columns.push_back(fit::byZero(elements, {record}).front());
  }
  return columns;
}

double signedRoot(double square) { return std::copysign(std::sqrt(std::abs(square)), square); }

}  // namespace

void LogAccount::takeOut(const std::string& kind, double left) {
  const double square = left_ - left;
  left_ = left;
  const auto found = std::find_if(squares_.begin(), squares_.end(), [&](const auto& one) { return one.first == kind; });
  if (found == squares_.end()) {
    squares_.emplace_back(kind, square);
  } else {
    found->second += square;
  }
}

std::vector<TakenOut> LogAccount::entries() const {
  constexpr double kNothing = 1e-12;  // differences due to rounding
  std::vector<TakenOut> entries;
  for (const auto& [kind, square] : squares_) {
    if (std::abs(square) > kNothing) {
      entries.push_back({log_, kind, signedRoot(square)});
    }
  }
  return entries;
}

std::vector<LogAccount> accountsOf(const std::vector<element::ElementDescription>& elements,
                                   const std::vector<gap::PreparedRecord>& of_the_fit,
                                   const std::vector<gap::PreparedRecord>& held_out,
                                   const std::vector<prepare::RawChannels>& raw, fit::PerLogNuisances free) {
  const Displacements recorded = element::each(raw, &prepare::RawChannels::displacement);
  Displacements bridged;
  for (const auto* list : {&of_the_fit, &held_out}) {
    for (const gap::PreparedRecord& record : *list) {
      bridged.push_back(record.raw_displacement);
    }
  }
  const auto over = [&](const Displacements& z) { return simulateOver(elements, of_the_fit, held_out, z); };
  Stages forces;
  forces.recorded = over(recorded);
  forces.bridged = bridged == recorded ? forces.recorded : over(bridged);
  if (free.by_zero) {
    free.by_zero = fit::columnOf(byZeros(elements, of_the_fit, held_out));
  }
  if (free.by_factor) {
    gap::Forces friction = fit::frictionOf(elements, of_the_fit);
    const gap::Forces unseen = hypotheses::frictionOfEach(elements, held_out);
    friction.insert(friction.end(), unseen.begin(), unseen.end());
    free.by_factor = fit::columnOf(friction);
  }
  std::vector<LogAccount> accounts;
  for (const auto* list : {&of_the_fit, &held_out}) {
    for (const gap::PreparedRecord& record : *list) {
      const std::size_t r = accounts.size();
      accounts.push_back(accountOf(record, raw[r], forces, r, free));
    }
  }
  return accounts;
}

}  // namespace rubber_suspension::diagnosis::results
