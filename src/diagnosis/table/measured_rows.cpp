// Excitation, candidates and noise of a table.
#include "diagnosis/table/measured_rows.h"

#include <algorithm>
#include <stdexcept>

#include "diagnosis/hypotheses/candidate/registry.h"
#include "diagnosis/hypotheses/measured_logs.h"
#include "diagnosis/hypotheses/odds.h"
#include "diagnosis/hypotheses/shapes.h"
#include "fit/master_curve.h"

namespace rubber_suspension::diagnosis::table {

// Softening and heat are over before a loop has settled; what creeps has crept; a constant force and a trend are no
// part of a loop.
const std::vector<std::string>& neverShownByTables() {
  static const std::vector<std::string> names = {"stress_softening", "self_heating", "creep", "force_offset",
                                                 "force_drift"};
  return names;
}

MeasuredRows::MeasuredRows(const io::ComponentDescription& component, const std::vector<fit::TablePoint>& points,
                           Scatter scatter)
    : scatter_(std::move(scatter)),
      loops_(std::make_shared<const fit::TableLoops>(points)),
      model_(component, fit::Level::specification),
      fitter_(loops_, model_, hypotheses::errorScale().oneOfSheet()) {}

fit::Excitation MeasuredRows::excitation() const {
  fit::Excitation excitation = fit::summarise(*loops_->records());
  if (fit::hasTemperatures(loops_->points())) {
    try {
      const fit::MasterCurve curve = fit::masterCurve(loops_->points(), fit::middleTemperature(loops_->points()));
      excitation.activation_energy = curve.activationEnergy();
    } catch (const std::invalid_argument&) {  // nothing tells the shifts
    }
  }
  return excitation;
}

std::vector<fit::Candidate> MeasuredRows::candidates(const fit::Excitation& excitation,
                                                     const hypotheses::FittedHypothesis& re_estimated,
                                                     int threads) const {
  std::vector<fit::Candidate> all = hypotheses::candidate::candidates(excitation);
  const std::vector<std::string>& never = neverShownByTables();
  for (fit::Candidate& candidate : all) {
    if (std::find(never.begin(), never.end(), candidate.effect) != never.end()) {
      candidate.terms.clear();
      candidate.free_in_log = {};
    }
  }
  // A loop about its mean has no side: to its fundamental, damping that grows towards one is a dashpot.
  for (fit::Candidate& candidate : all) {
    const auto has_side = [](const fit::BasisTerm& term) { return term.at(term.typical).type == "position_dashpot"; };
    candidate.terms.erase(std::remove_if(candidate.terms.begin(), candidate.terms.end(), has_side),
                          candidate.terms.end());
  }
  hypotheses::settleShapes(fitter_, re_estimated, *loops_->records(), threads, all);
  fit::findUnitEffects(all, *loops_->records(), threads);
  return all;
}

double MeasuredRows::discretisationError(const hypotheses::FittedHypothesis& model) const {
  const auto elements = *fit::elementsOf(model_, model.hypothesis, model.fit.parameters);
  const auto smooth = hypotheses::withSmoothDashpots(elements);
  if (smooth.empty()) {
    return 0.0;
  }
  const auto lagging = loops_->stiffnessOf(elements);
  std::vector<fit::TablePoint> points = loops_->points();
  const auto exact = loops_->stiffnessOf(smooth);
  for (std::size_t r = 0; r < points.size(); ++r) {
    points[r].stiffness = std::abs(exact[r]);
    points[r].loss_angle = std::arg(exact[r]);
  }
  return fit::gapOfTable(points, lagging);
}

hypotheses::Noise MeasuredRows::estimateNoise(const hypotheses::FittedHypothesis& best,
                                              const hypotheses::Search& /*search*/) const {
  hypotheses::Noise noise;
  noise.floor = noise.least = std::min(scatter_.level, best.fit.held_out);
  noise.of_logs.assign(loops_->points().size(), noise.floor);
  noise.source = scatter_.source + (noise.floor < scatter_.level ? ", no more than what a model leaves" : "");
  return noise;
}

}  // namespace rubber_suspension::diagnosis::table
