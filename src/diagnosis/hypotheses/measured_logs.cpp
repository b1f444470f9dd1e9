// Computes the discretisation error and the noise of logs.
#include "diagnosis/hypotheses/measured_logs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "diagnosis/effect.h"
#include "diagnosis/hypotheses/screening.h"
#include "diagnosis/hypotheses/shapes.h"
#include "diagnosis/hypotheses/unseen_logs.h"
#include "fit/free_in_log.h"
#include "gap/simulate.h"
#include "measurement/friction_noise.h"
#include "measurement/rig_noise.h"
#include "rubber_suspension/measurement/noise_floor.h"

namespace rubber_suspension::diagnosis::hypotheses {
namespace {

// Returns the least held-out gap of any hypothesis without trends, which absorb slow noise, on all logs.
double leastLeft(const Search& search) {
  double least = search.re_estimated.fit.held_out;
  for (const FittedHypothesis* fitted : search.withEffects()) {
    least = fitted->hypothesis.free_in_log.trend ? least : std::min(least, fitted->fit.held_out);
  }
  return least;
}

// Returns the least gap of any hypothesis with effects on the held-out blocks of each log.
std::vector<double> leastLeftOfLogs(const Search& search, std::size_t logs) {
  std::vector<double> least(logs, std::numeric_limits<double>::infinity());
  for (const FittedHypothesis* fitted : search.withEffects()) {
    const std::vector<double> squares =
        errorsByLog(fitted->fit.blocks, std::vector<double>(logs, std::numeric_limits<double>::infinity()));
    for (std::size_t r = 0; r < logs; ++r) {
      least[r] = std::min(least[r], std::sqrt(squares[r]));
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
  std::vector<fit::Candidate> all = diagnosis::candidates(excitation);
  settleShapes(fitter_, re_estimated, fitter_.records(), threads, all);
  fitter_.prepare(all, threads);
  return all;
}

// Returns the RMS difference between the force of the model and that of smooth dashpots, weighted as in the gap.
double MeasuredLogs::discretisationError(const FittedHypothesis& model) const {
  const auto elements = withSmoothDashpots(*fit::elementsOf(fitter_.model(), model.hypothesis, model.fit.parameters));
  if (elements.empty()) {
    return 0.0;
  }
  const auto smooth = gap::simulate(elements, fitter_.records());
  const auto lagging = *fitter_.forces().at(model.hypothesis, model.fit.parameters);
  double sum = 0.0;
  for (std::size_t r = 0; r < smooth.size(); ++r) {
    const gap::PreparedRecord& record = fitter_.records()[r];
    sum += record.weight * (smooth[r] - lagging[r]).squaredNorm() / static_cast<double>(record.size()) /
           std::pow(record.force_deviation, 2);
  }
  return std::sqrt(sum / static_cast<double>(smooth.size()));
}

// Estimates the noise of each log as the larger of two values. The first is the noise in the residual outside the band
// of the excitation, for the model in which it is least, because residuals also contain errors of the model. The second
// is the force that noise of the displacement causes, limited to the least gap of any model on this log. The noise
// floor of all logs together is at most the least gap of any model.
Noise MeasuredLogs::estimateNoise(const FittedHypothesis& best, const Search& search) const {
  const std::vector<gap::PreparedRecord>& records = fitter_.records();
  const auto forces = *fitter_.forces().at(best.hypothesis, best.fit.parameters);
  Noise noise;
  noise.caused = search.noise.caused;
  if (noise.caused.empty()) {
    const FittedHypothesis& model = search.re_estimated;
    noise.caused =
        measurement::frictionNoise(*fit::elementsOf(fitter_.model(), model.hypothesis, model.fit.parameters), records);
  }
  noise.rest = search.noise.rest;
  noise.rest.resize(records.size(), std::numeric_limits<double>::infinity());
  fit::PerLogNuisances free = freeOfNoise(best.hypothesis);
  free.by_factor = best.hypothesis.free_in_log.by_factor;
  std::vector<double> rig;  // gaps that errors of the rig cause, for the best model
  for (std::size_t r = 0; r < records.size(); ++r) {
    const Eigen::VectorXd residual = records[r].force - forces[r];
    const double left = measurement::relativeFloor(free.addedTo(records[r], r, forces[r]), residual);
    noise.rest[r] = std::min(noise.rest[r], left);
    rig.push_back(measurement::rigCost(records[r], residual));
  }
  const std::vector<double> least = leastLeftOfLogs(search, records.size());
  const measurement::NoiseLimit limit = measurement::noiseLimit(noise.rest, records);
  bool by_displacement = false;
  for (std::size_t r = 0; r < records.size(); ++r) {
    const double left = std::min(noise.rest[r], limit.of(records[r]));
    const double caused = std::min(noise.caused[r], least[r]);
    by_displacement = by_displacement || caused > left;
    noise.of_logs.push_back(std::max(left, caused));
  }
  noise.floor = commonFloor(noise.of_logs, records);
  const double too_much = noise.floor / leastLeft(search);
  if (too_much > 1.0 && std::isfinite(too_much)) {  // the ratio is infinite if the gap is 0
    for (double& of_log : noise.of_logs) {
      of_log /= too_much;
    }
    noise.floor /= too_much;
  }
  noise.floor_with_rig = std::hypot(noise.floor, commonFloor(rig, records));
  noise.source = std::string("spectrum of the residual outside the band of the excitation") +
                 (by_displacement ? ", and the force that the model computes from the noise of the displacement" : "");
  return noise;
}

Search implanted(fit::Fitter& fitter, double noise, int threads) {
  Search search;
  search.excitation = fit::summarise(fitter.records());
  search.candidates = diagnosis::candidates(search.excitation);
  fitter.prepare(search.candidates, threads);
  search.noise.floor = noise;
  search.re_estimated.fit.parameters = fitter.configured(search.re_estimated.hypothesis);
  search.implants = implantAll(fitter, Screening(fitter, search.candidates, search.re_estimated, threads), threads);
  return search;
}

}  // namespace rubber_suspension::diagnosis::hypotheses
