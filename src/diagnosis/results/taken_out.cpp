// The account of what was taken out of each log.
#include "diagnosis/results/taken_out.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "gap/simulate.h"
#include "rubber_suspension/gap/gap.h"

namespace rubber_suspension::diagnosis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

double meanSquare(const VectorXd& residual, const VectorXd& counts) {
  return residual.cwiseProduct(counts).squaredNorm() / counts.sum();
}

VectorXd countsOf(const log::Record& record) {
  return record.counts.size() == 0 ? VectorXd::Ones(record.size()).eval() : record.counts;
}

// With the first cycle of a log that starts in motion.
VectorXd withStart(VectorXd counts) {
  for (Index i = 0; i < counts.size() && counts[i] == 0.0; ++i) {
    counts[i] = 1.0;
  }
  return counts;
}

using Displacements = std::vector<VectorXd>;

// Forces over other displacements of the same records.
gap::Forces simulateOver(const std::vector<element::ElementDescription>& elements,
                         const std::vector<log::Record>& of_the_fit, const std::vector<log::Record>& held_out,
                         const Displacements& displacements) {
  gap::Forces forces = gap::simulate(elements, of_the_fit, [&](const log::Record& record) {
    return displacements[static_cast<std::size_t>(&record - of_the_fit.data())];
  });
  for (std::size_t i = 0; i < held_out.size(); ++i) {
    const VectorXd& z = displacements[of_the_fit.size() + i];
    forces.push_back(gap::simulate(elements, {held_out[i]}, [&](const log::Record&) { return z; }).front());
  }
  return forces;
}

// Share of a signal's square that a straight line has, both about the mean.
double shareOfLine(const VectorXd& values) {
  const VectorXd time = VectorXd::LinSpaced(values.size(), -1.0, 1.0);
  const VectorXd centred = values.array() - values.mean();
  const double square = centred.squaredNorm() * time.squaredNorm();
  return square > 0.0 ? std::pow(centred.dot(time), 2) / square : 0.0;
}

// What of a record's residual its nuisances take: what is the same all along is a zero; the rest is a drift where it
// goes on all along, else what was left from before.
void takeNuisances(const log::Record& record, const VectorXd& counts, const VectorXd& residual, LogAccount& account) {
  const VectorXd counted = residual.cwiseProduct(counts);
  const VectorXd taken = counted - record.withoutRig(residual);
  const VectorXd zero = taken.dot(counts) / counts.sum() * counts;
  const double scale = counts.sum() * std::pow(record.force_deviation, 2);
  account.takeOut(taken_out::kZero, account.left() - zero.dot(2.0 * counted - taken) / scale);
  account.takeOut(shareOfLine(taken - zero) > 0.5 ? taken_out::kDrift : taken_out::kInitialState,
                  record.withoutRig(residual).squaredNorm() / scale);
}

// Forces of the elements on the displacement at each stage.
struct Stages {
  gap::Forces recorded;
  gap::Forces bridged;
  gap::Forces shifted;   // without its zero and delay
  gap::Forces smoothed;  // what hypotheses are fitted with
};

LogAccount accountOf(const log::Record& record, const ChannelsBefore& before, const Stages& forces, std::size_t r,
                     fit::FreeInLog free) {
  const double variance = std::pow(record.force_deviation, 2);
  LogAccount account(
      record.name,
      std::pow(gap::gapOfResidual(before.force - forces.recorded[r], gap::standardDeviation(before.force)), 2));
  const VectorXd counts = countsOf(record);
  const VectorXd bridged = before.bridged_force - forces.bridged[r];
  account.takeOut(taken_out::kSpikes, meanSquare(bridged, withStart(counts)) / variance);
  account.takeOut(taken_out::kInitialState, meanSquare(bridged, counts) / variance);
  account.takeOut(taken_out::kZero, meanSquare(record.force - forces.bridged[r], counts) / variance);
  account.takeOut(taken_out::kDisplacement, meanSquare(record.force - forces.shifted[r], counts) / variance);
  const VectorXd residual = record.force - forces.smoothed[r];
  account.takeOut(taken_out::kNoise, meanSquare(residual, counts) / variance);
  takeNuisances(record, counts, residual, account);
  const auto without = [&](fit::FreeInLog also) {
    return fit::withFreeInLog(also, record, forces.smoothed[r]).withoutRig(residual).squaredNorm() / counts.sum() /
           variance;
  };
  if (free.trend) {
    account.takeOut(taken_out::kDrift, without({true, false}));
  }
  if (free.gain) {
    account.takeOut(taken_out::kGain, without(free));
  }
  return account;
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
  std::vector<TakenOut> entries;
  for (const auto& [kind, square] : squares_) {
    if (square != 0.0) {
      entries.push_back({log_, kind, signedRoot(square)});
    }
  }
  return entries;
}

std::vector<ChannelsBefore> channelsBefore(const std::vector<log::Log>& logs, const std::vector<log::Log>& hold_out,
                                           const std::vector<log::Record>& prepared) {
  std::vector<ChannelsBefore> channels;
  for (const auto* list : {&logs, &hold_out}) {
    for (const log::Log& log : *list) {
      log::Record raw = log::rawRecord(log);
      const log::Record& record = prepared[channels.size()];
      channels.push_back(
          {std::move(raw.raw_displacement), std::move(raw.force), record.raw_displacement, record.force});
    }
  }
  return channels;
}

std::vector<LogAccount> accountsOf(const std::vector<element::ElementDescription>& elements,
                                   const std::vector<log::Record>& of_the_fit, const std::vector<log::Record>& held_out,
                                   const std::vector<ChannelsBefore>& before, fit::FreeInLog free) {
  Displacements recorded;
  Displacements bridged;
  Displacements shifted;
  Displacements smoothed;
  for (const ChannelsBefore& log : before) {
    recorded.push_back(log.displacement);
    bridged.push_back(log.bridged_displacement);
  }
  for (const auto* list : {&of_the_fit, &held_out}) {
    for (const log::Record& record : *list) {
      shifted.push_back(record.raw_displacement);
      smoothed.push_back(record.displacement);
    }
  }
  const auto over = [&](const Displacements& z) { return simulateOver(elements, of_the_fit, held_out, z); };
  Stages forces;
  forces.recorded = over(recorded);
  forces.bridged = bridged == recorded ? forces.recorded : over(bridged);
  forces.shifted = shifted == bridged ? forces.bridged : over(shifted);
  forces.smoothed = smoothed == shifted ? forces.shifted : over(smoothed);
  std::vector<LogAccount> accounts;
  for (const auto* list : {&of_the_fit, &held_out}) {
    for (const log::Record& record : *list) {
      const std::size_t r = accounts.size();
      accounts.push_back(accountOf(record, before[r], forces, r, free));
    }
  }
  return accounts;
}

std::vector<std::string> describeTakenOut(const std::vector<TakenOut>& taken_out) {
  constexpr double kTold = 0.01;  // of the force
  std::vector<std::string> phrases;
  std::string log;
  for (const TakenOut& one : taken_out) {
    if (std::abs(one.share) < kTold) {
      continue;
    }
    std::string kind = one.kind;
    std::replace(kind.begin(), kind.end(), '_', ' ');
    const std::string share = fmt::format("{} {:.2g} %", kind, 100.0 * one.share);
    if (one.log == log) {
      phrases.back() += ", " + share;
    } else {
      phrases.push_back(one.log + ": " + share);
      log = one.log;
    }
  }
  return phrases;
}

}  // namespace rubber_suspension::diagnosis
