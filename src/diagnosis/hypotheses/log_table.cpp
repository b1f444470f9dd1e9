// Computes errors, noise floors and sizes for each log.
#include "diagnosis/hypotheses/log_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numeric>
#include <utility>

#include "diagnosis/hypotheses/fitted_component.h"
#include "diagnosis/hypotheses/unseen_logs.h"
#include "fit/free_in_log.h"
#include "fit/parallel.h"
#include "numerics/fourier.h"
#include "rubber_suspension/gap/gap.h"
#include "rubber_suspension/measurement/noise_floor.h"

namespace rubber_suspension::diagnosis::hypotheses {
namespace {

// Returns the mean square of a force without errors of the rig, divided by the variance of the record's force.
double meanSquare(const gap::PreparedRecord& record, const Eigen::VectorXd& force) {
  return record.withoutRig(force).squaredNorm() / record.counted() / std::pow(record.force_deviation, 2);
}

// Returns the squared residual of a log that the nuisance parameters `free` explain in addition to `others`.
double takenInLog(const fit::PerLogNuisances& free, const fit::PerLogNuisances& others,
                  const gap::PreparedRecord& record, const Eigen::VectorXd& simulated) {
  const Eigen::VectorXd residual = record.force - simulated;
  const auto left = [&](const fit::PerLogNuisances& all) {
    return meanSquare(all.addedTo(record, 0, simulated), residual);
  };
  return std::max(0.0, left(others) - left(free | others));
}

// Returns the size of a force. For an effect of the rubber the mean is removed, because an offset would absorb it.
double sizeOf(const log::Record& record, const Eigen::VectorXd& force, bool on_rig) {
  const Eigen::VectorXd counts = record.counts.size() > 0 ? record.counts : Eigen::VectorXd::Ones(record.size());
  const double mean = on_rig ? 0.0 : force.dot(counts) / record.counted();
  return (force.array() - mean).square().matrix().dot(counts) / record.counted() / std::pow(record.force_deviation, 2);
}

// Returns the size of an effect in each log. `added` is the force that the effect adds, and `with` is the force of the
// model with the effect, which its per-log nuisance parameters need.
std::vector<double> sizesOfMember(const fit::Candidate& candidate, const fit::PerLogNuisances& all,
                                  const std::vector<gap::PreparedRecord>& records, const gap::Forces& added,
                                  const gap::Forces& with) {
  const fit::PerLogNuisances free = candidate.free_in_log & all;
  const fit::PerLogNuisances others{all.trend && !free.trend, all.offset && !free.offset, all.gain && !free.gain};
  std::vector<double> sizes;
  for (std::size_t r = 0; r < records.size(); ++r) {
    const double size = sizeOf(records[r], added[r], candidate.on_rig) +
                        (free.any() ? takenInLog(free, others, records[r], with[r]) : 0.0);
    sizes.push_back(std::isfinite(size) ? size : std::numeric_limits<double>::infinity());
  }
  return sizes;
}

// Returns the hypothesis without trends, which absorb slow noise, that has the least error on the logs of the fit.
const FittedHypothesis& bestOf(const Search& search) {
  const FittedHypothesis* best = &search.re_estimated;
  for (const FittedHypothesis* fitted : search.withEffects()) {
    best = !fitted->hypothesis.free_in_log.trend && fitted->fit.score() < best->fit.score() ? fitted : best;
  }
  return *best;
}

// Returns the standard error of the logarithm of the noise floor, estimated from three parts of the record.
double floorUncertainty(const gap::PreparedRecord& record, const Eigen::VectorXd& residual) {
  constexpr Eigen::Index kParts = 3;
  const Eigen::VectorXd left = record.withoutRig(residual);
  const Eigen::VectorXd counts = record.counts.size() > 0 ? record.counts : Eigen::VectorXd::Ones(record.size());
  gap::PreparedRecord part(record, {{}, record.rig.one_deviation, record.rig.slow_noise});
  std::array<double, kParts> logarithms{};
  for (Eigen::Index p = 0; p < kParts; ++p) {
    const Eigen::Index first = record.size() * p / kParts;
    const Eigen::Index size = record.size() * (p + 1) / kParts - first;
    part.counts = Eigen::VectorXd::Zero(record.size());
    part.counts.segment(first, size) = counts.segment(first, size);
    logarithms[static_cast<std::size_t>(p)] = std::log(std::max(measurement::relativeFloor(part, left), 1e-9));
  }
  const Eigen::Map<const Eigen::ArrayXd> values(logarithms.data(), kParts);
  return std::sqrt((values - values.mean()).square().sum() / (kParts * (kParts - 1.0)));
}

// Returns the fractions of the squared residual of a log in each octave. Trends, offsets, gains and factors that are
// free in the log are removed from the residual first.
std::vector<double> sharesOfLeft(const fit::Hypothesis& hypothesis, const gap::PreparedRecord& record,
                                 std::size_t place, const Eigen::VectorXd& simulated) {
  fit::PerLogNuisances free = hypothesis.free_in_log;
  free.by_zero = nullptr;
  const Eigen::VectorXd left = record.force - simulated;
  return octaveShares(free.any() ? free.addedTo(record, place, simulated).withoutRig(left) : record.withoutRig(left));
}

// Returns the weight of each octave: the mean of its fractions in the force of the model and in the residual (`left`).
// The residual counts, because it also has to be explained outside the frequencies of the motion.
std::vector<double> octavesOf(const Eigen::VectorXd& modelled, const std::vector<double>& left) {
  std::vector<double> octaves = octaveShares(modelled.array() - modelled.mean());
  if (octaves.empty() || left.empty()) {
    return {};
  }
  for (std::size_t octave = 0; octave < octaves.size(); ++octave) {
    octaves[octave] = 0.5 * (octaves[octave] + left[octave]);
  }
  return octaves;
}

std::vector<double> whereCounted(const std::vector<double>& values, const std::vector<double>& octaves) {
  constexpr double kLeast = 1e-3;
  std::vector<double> counted;
  for (std::size_t octave = 0; octave < std::min(values.size(), octaves.size()); ++octave) {
    if (octaves[octave] >= kLeast) {
      counted.push_back(values[octave]);
    }
  }
  return counted;
}

class LogTable {
 public:
  LogTable(const PreparedCase& prepared, const Search& search, int threads)
      : prepared_(prepared), search_(search), threads_(threads), evidence_(evidenceOf(search)) {}

  judge::Evidence run() {
    predictUnseen();
    addLogs();
    fit::parallelFor(evidence_.hypotheses.size(), threads_, [&](std::size_t h) {
      addErrorsOf(static_cast<int>(h), evidence_.hypotheses[h]);
      addSizesOf(static_cast<int>(h), evidence_.hypotheses[h]);
      addSharesOf(static_cast<int>(h), evidence_.hypotheses[h]);
    });
    addOctaves();
    return std::move(evidence_);
  }

 private:
  void predictUnseen() {
    unseen_.resize(prepared_.held_out.empty() ? 0 : evidence_.hypotheses.size());
    fit::parallelFor(unseen_.size(), threads_, [&](std::size_t h) {
      unseen_[h] = unseenErrors(prepared_.model, search_.at(static_cast<int>(h)), prepared_.held_out);
    });
  }

  void addLogs() {
    const FittedHypothesis& best = bestOf(search_);
    const gap::Forces forces = *prepared_.fitter.forces().at(best.hypothesis, best.fit.parameters);
    addLogs(prepared_.training, forces, search_.noise.of_logs, false);
    if (!prepared_.held_out.empty()) {
      addLogs(prepared_.held_out, predict(prepared_.model, best, prepared_.held_out), search_.noise.unseen, true);
    }
    countBlocks(search_.re_estimated.fit.blocks, 0);
    if (!unseen_.empty()) {
      countBlocks(unseen_[judge::Evidence::kReEstimated], prepared_.training.size());
    }
  }

  void countBlocks(const std::vector<gap::PartError>& blocks, std::size_t first) {
    for (const gap::PartError& block : blocks) {
      ++evidence_.logs[first + static_cast<std::size_t>(block.log)].blocks;
    }
  }

  void addLogs(const std::vector<gap::PreparedRecord>& records, const gap::Forces& forces,
               const std::vector<double>& floors, bool unseen) {
    for (std::size_t r = 0; r < records.size(); ++r) {
      const double uncertainty = floorUncertainty(records[r], records[r].force - forces[r]);
      const double floor = std::hypot(floors[r], measurement::rigCost(records[r], records[r].force - forces[r]));
      evidence_.logs.push_back({floor, uncertainty, records[r].weight, unseen, 0});
    }
  }

  void addErrorsOf(int place, judge::HypothesisEvidence& hypothesis) const {
    const FittedHypothesis& fitted = search_.at(place);
    const std::vector<double> of_all(evidence_.logs.size(), fitted.fit.held_out * fitted.fit.held_out);
    hypothesis.log_errors =
        errorsByLog(place == judge::Evidence::kAsConfigured ? partsAsConfigured() : fitted.fit.blocks, of_all);
    if (!unseen_.empty()) {
      const std::vector<double> unseen = errorsByLog(unseen_[static_cast<std::size_t>(place)], of_all);
      std::copy_n(unseen.begin(), prepared_.held_out.size(),
                  hypothesis.log_errors.end() - static_cast<std::ptrdiff_t>(prepared_.held_out.size()));
    }
  }

  // Returns errors on all samples. Without a fit, no part of a log has to be held out.
  std::vector<gap::PartError> partsAsConfigured() const {
    const FittedHypothesis& model = search_.as_configured;
    return gap::partErrors(prepared_.training, *prepared_.fitter.forces().at(model.hypothesis, model.fit.parameters));
  }

  void addSizesOf(int place, judge::HypothesisEvidence& hypothesis) const {
    const FittedHypothesis& fitted = search_.at(place);
    if (fitted.hypothesis.members.empty()) {
      return;
    }
    hypothesis.sizes = memberSizes(search_.candidates, prepared_.fitter.forces(), fitted);
    for (const gap::PreparedRecord& record : prepared_.held_out) {  // each held-out log is of a new component
      const FittedHypothesis of_record{fit::aboutOtherRecords(fitted.hypothesis, {record}), fitted.fit};
      const auto sizes = memberSizes(search_.candidates, fit::HypothesisForces({record}, prepared_.model), of_record);
      for (std::size_t m = 0; m < sizes.size(); ++m) {
        hypothesis.sizes[m].push_back(sizes[m].front());
      }
    }
  }

  // Adds the fractions of the logs of the fit. The octaves of held-out logs are not distinguished.
  void addSharesOf(int place, judge::HypothesisEvidence& hypothesis) const {
    const FittedHypothesis& fitted = search_.at(place);
    const auto forces = prepared_.fitter.forces().at(fitted.hypothesis, fitted.fit.parameters);
    for (std::size_t r = 0; forces && r < forces->size(); ++r) {
      hypothesis.shares.push_back(sharesOfLeft(fitted.hypothesis, prepared_.training[r], r, (*forces)[r]));
    }
  }

  void addOctaves() {
    const std::vector<std::vector<double>>& left = evidence_.at(judge::Evidence::kReEstimated).shares;
    const FittedHypothesis& model = search_.re_estimated;
    const auto forces = prepared_.fitter.forces().at(model.hypothesis, model.fit.parameters);
    for (std::size_t r = 0; r < left.size(); ++r) {
      const std::vector<double> octaves = octavesOf((*forces)[r], left[r]);
      for (judge::HypothesisEvidence& hypothesis : evidence_.hypotheses) {
        if (r < hypothesis.shares.size()) {
          hypothesis.shares[r] = whereCounted(hypothesis.shares[r], octaves);
        }
      }
      setOctaves(whereCounted(octaves, octaves), evidence_.logs[r]);
    }
  }

  static void setOctaves(std::vector<double> octaves, judge::LogEvidence& log) {
    const double sum = std::accumulate(octaves.begin(), octaves.end(), 0.0);
    for (double& octave : octaves) {
      octave /= sum;
    }
    if (!octaves.empty()) {
      log.octaves = std::move(octaves);
    }
  }

  const PreparedCase& prepared_;
  const Search& search_;
  int threads_;
  std::vector<UnseenErrors> unseen_;  // errors of each hypothesis; empty without hold-outs
  judge::Evidence evidence_;
};

}  // namespace

fit::ParameterVector withoutMember(const FittedHypothesis& fitted, std::size_t member) {
  fit::ParameterVector parameters = fitted.fit.parameters;
  const std::vector<std::size_t>& counts = fitted.hypothesis.counts;
  const auto first =
      std::accumulate(counts.begin(), counts.begin() + static_cast<std::ptrdiff_t>(member), std::size_t{0});
  parameters.scales.segment(static_cast<Eigen::Index>(first), static_cast<Eigen::Index>(counts[member])).setZero();
  return parameters;
}

std::vector<std::vector<double>> memberSizes(const std::vector<fit::Candidate>& candidates,
                                             const fit::HypothesisForces& forces, const FittedHypothesis& fitted) {
  std::vector<std::vector<double>> sizes;
  const bool frees = fitted.hypothesis.free_in_log.any();
  const gap::Forces with = frees ? *forces.at(fitted.hypothesis, fitted.fit.parameters) : gap::Forces();
  for (std::size_t m = 0; m < fitted.hypothesis.members.size(); ++m) {
    const fit::Candidate& candidate = candidates[static_cast<std::size_t>(fitted.hypothesis.members[m])];
    const Eigen::VectorXd others = withoutMember(fitted, m).scales;
    const gap::Forces added = forces.moreThanWith(others, fitted.hypothesis, fitted.fit.parameters);
    sizes.push_back(sizesOfMember(candidate, fitted.hypothesis.free_in_log, forces.records(), added, with));
  }
  return sizes;
}

std::vector<double> floorsOfUnseen(const PreparedCase& prepared, const Search& search) {
  const FittedHypothesis& best = bestOf(search);
  return prepared.held_out.empty()
             ? std::vector<double>()
             : noiseFloors(augmentedDescription(prepared.model, best).allElements(), freeOfNoise(best.hypothesis),
                           predict(prepared.model, best, prepared.held_out), prepared.held_out,
                           measurement::noiseLimit(search.noise.of_logs, prepared.training));
}

judge::Evidence evidenceOfLogs(const PreparedCase& prepared, const Search& search, int threads) {
  return LogTable(prepared, search, threads).run();
}

std::vector<double> octaveShares(const Eigen::VectorXd& values) {
  const auto spectrum = numerics::paddedSpectrum({values.data(), values.data() + values.size()});
  std::vector<double> shares = {std::norm(spectrum.front())};
  for (std::size_t first = 1; first < spectrum.size(); first *= 2) {
    const std::size_t end = std::min(2 * first, spectrum.size());
    shares.push_back(0.0);
    for (std::size_t line = first; line < end; ++line) {
      shares.back() += std::norm(spectrum[line]);
    }
  }
  const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
  if (!(std::isfinite(sum) && sum > 0.0)) {
    return {};
  }
  for (double& share : shares) {
    share /= sum;
  }
  return shares;
}

}  // namespace rubber_suspension::diagnosis::hypotheses
