// Excitation, discretisation and noise of logs.
#include "diagnosis/hypotheses/measured_logs.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "diagnosis/hypotheses/candidate/registry.h"
#include "diagnosis/hypotheses/shapes.h"
#include "diagnosis/hypotheses/unseen_logs.h"
#include "fit/free_in_log.h"
#include "gap/simulate.h"
#include "measurement/friction_noise.h"
#include "measurement/rig_noise.h"
#include "rubber_suspension/measurement/noise_floor.h"

namespace rubber_suspension::diagnosis::hypotheses {
namespace {

// The gap that the best hypothesis leaves in the held-out blocks of all logs, but for those with trends, which take
// slow noise with them.
double leastLeft(const Search& search) {
  double least = search.re_estimated.fit.held_out;
  for (const FittedHypothesis* fitted : search.withEffects()) {
    least = fitted->hypothesis.free_in_log.trend ? least : std::min(least, fitted->fit.held_out);
  }
  return least;
}

// The gap that the best hypothesis of each log leaves in its held-out blocks.
std::vector<double> leastLeftOfLogs(const Search& search, std::size_t logs) {
  std::vector<double> least(logs, std::numeric_limits<double>::infinity());
  for (const FittedHypothesis* fitted : search.withEffects()) {
    std::vector<double> squares(logs, 0.0);
    std::vector<double> weights(logs, 0.0);
    for (const gap::PartError& block : fitted->fit.blocks) {
      squares[static_cast<std::size_t>(block.log)] += block.weight * block.error;
      weights[static_cast<std::size_t>(block.log)] += block.weight;
    }
    for (std::size_t r = 0; r < logs; ++r) {
      least[r] = weights[r] > 0.0 ? std::min(least[r], std::sqrt(squares[r] / weights[r])) : least[r];
    }
  }
  return least;
}

}  // namespace

std::vector<element::ElementDescription> withSmoothDashpots(std::vector<element::ElementDescription> elements) {
  bool any = false;
  for (element::ElementDescription& element : elements) {
    if (element.type == "dashpot") {
      element.values["order"] = {2.0};
      any = true;
    }
  }
  return any ? elements : std::vector<element::ElementDescription>{};
}

fit::Excitation MeasuredLogs::excitation() const { return fit::summarise(fitter_.records()); }

std::vector<fit::Candidate> MeasuredLogs::candidates(const fit::Excitation& excitation,
                                                     const FittedHypothesis& re_estimated, int threads) const {
  std::vector<fit::Candidate> all = candidate::candidates(excitation);
  settleShapes(fitter_, re_estimated, fitter_.records(), threads, all);
  fitter_.prepare(all, threads);
  return all;
}

// RMS of what the lag of dashpots makes of the model's force, weighted as a gap is.
double MeasuredLogs::discretisationError(const FittedHypothesis& model) const {
  const auto elements = withSmoothDashpots(*fit::elementsOf(fitter_.model(), model.hypothesis, model.fit.parameters));
  if (elements.empty()) {
    return 0.0;
  }
  const auto smooth = gap::simulate(elements, fitter_.records());
  const auto lagging = *fitter_.forces().at(model.hypothesis, model.fit.parameters);
  double sum = 0.0;
  for (std::size_t r = 0; r < smooth.size(); ++r) {
    const log::Record& record = fitter_.records()[r];
    sum += record.weight * (smooth[r] - lagging[r]).squaredNorm() / static_cast<double>(record.size()) /
           std::pow(record.force_deviation, 2);
  }
  return std::sqrt(sum / static_cast<double>(smooth.size()));
}

// For each log, the larger one of the noise of what the best model leaves outside the band of the excitation, and of
// what the noise of the displacement causes, which is no more than what any model leaves. A better model leaves less
// that is not noise: of several, the least counts, log by log. All of it is no more than what any model leaves of all
// logs.
void MeasuredLogs::estimateNoise(const FittedHypothesis& best, Search& result) const {
  const std::vector<log::Record>& records = fitter_.records();
  const auto forces = *fitter_.forces().at(best.hypothesis, best.fit.parameters);
  if (result.record_caused.empty()) {
    const FittedHypothesis& model = result.re_estimated;
    result.record_caused =
        measurement::frictionNoise(*fit::elementsOf(fitter_.model(), model.hypothesis, model.fit.parameters), records);
  }
  fit::FreeInLog free = freeOfNoise(best.hypothesis);
  free.by_factor = best.hypothesis.free_in_log.by_factor;
  const std::vector<double> least = leastLeftOfLogs(result, records.size());
  result.record_rest.resize(records.size(), std::numeric_limits<double>::infinity());
  for (std::size_t r = 0; r < records.size(); ++r) {
    const Eigen::VectorXd residual = records[r].force - forces[r];
    const double left = free.any() ? measurement::relativeFloor(free.addedTo(records[r], r, forces[r]), residual)
                                   : measurement::relativeFloor(records[r], residual);
    result.record_rest[r] = std::min(result.record_rest[r], left);
  }
  const measurement::NoiseLimit limit = measurement::noiseLimit(result.record_rest, records);
  bool by_displacement = false;
  result.record_noise.clear();
  for (std::size_t r = 0; r < records.size(); ++r) {
    const double left = std::min(result.record_rest[r], limit.of(records[r]));
    const double caused = std::min(result.record_caused[r], least[r]);
    by_displacement = by_displacement || caused > left;
    result.record_noise.push_back(std::max(left, caused));
  }
  result.noise = commonFloor(result.record_noise, records);
  const double too_much = result.noise / leastLeft(result);
  if (too_much > 1.0 && std::isfinite(too_much)) {  // never 0
    for (double& noise : result.record_noise) {
      noise /= too_much;
    }
    result.noise /= too_much;
  }
  result.record_rig.clear();
  for (std::size_t r = 0; r < records.size(); ++r) {
    result.record_rig.push_back(measurement::rigCost(records[r], records[r].force - forces[r]));
  }
  result.least = std::hypot(result.noise, commonFloor(result.record_rig, records));
  result.noise_source = by_displacement
                            ? "spectrum of the residual outside the band of the excitation, and noise of the "
                              "displacement through the model"
                            : "spectrum of the residual outside the band of the excitation";
}

}  // namespace rubber_suspension::diagnosis::hypotheses
