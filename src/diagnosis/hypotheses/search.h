// The search over sets of effects: all single effects, then pairs and triples, as long as more effects may be likelier.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "diagnosis/hypotheses/implant.h"
#include "diagnosis/judge/evidence.h"
#include "fit/excitation.h"
#include "fit/hypothesis_fitter.h"
#include "rubber_suspension/diagnosis/diagnosis.h"
#include "rubber_suspension/io/component_file.h"

namespace rubber_suspension::diagnosis::hypotheses {

/// A hypothesis that is fitted together with the model parameters.
struct FittedHypothesis {
  fit::Hypothesis hypothesis;
  fit::Fit fit;
};

/// Largest ratio of the gap on the data of the fit to the gap on held-out blocks that chance explains.
constexpr double kBetterByChance = 1.02;

/// Noise floors, divided by the standard deviation of the force.
struct Noise {
  double floor = 0.0;           ///< noise floor of all logs together
  double floor_with_rig = 0.0;  ///< the same noise floor with the errors of the rig, which no model explains
  std::vector<double> of_logs;  ///< noise floor of each log of the fit
  std::vector<double> unseen;   ///< noise floor of each held-out log (floorsOfUnseen())
  std::vector<double> rest;     ///< for each log: least noise in the residual of any model
  std::vector<double> caused;   ///< for each log: error of the simulated force due to noise of the displacement
  std::string source;
};

struct Visibility {
  double share = 0.0;     ///< part of its force that re-estimated model parameters do not absorb [-]
  bool testable = false;  ///< an effect of typical size would be visible in these logs
};

/// All hypotheses that were fitted. Errors are root mean squares divided by the standard deviation of the force.
struct Search {
  fit::Excitation excitation;
  std::vector<fit::Candidate> candidates;
  std::vector<std::string> excluded;  ///< excluded effects, fitted for the probability that they would have otherwise
  bool guess = false;                 ///< the data sheet is a guess
  double configured_gap = 0.0;        ///< gap of the model as configured, without any fit
  /// The model with its configured parameters. Everything else in its fit is copied from the re-estimated model.
  FittedHypothesis as_configured;
  FittedHypothesis re_estimated;          ///< the model with fitted parameters, without effects
  std::vector<FittedHypothesis> singles;  ///< a hypothesis for each candidate, in the order of the candidates
  std::vector<FittedHypothesis> pairs;    ///< pairs worth a full fit according to the screening, sorted by error
  std::vector<FittedHypothesis> triples;
  double surrogate_gap = 0.0;   ///< held-out gap with all candidates at once, as for a flexible fit
  double discretisation = 0.0;  ///< gap that the lag of dashpots causes at the time steps of the logs
  Noise noise;
  std::vector<Visibility> visibility;  ///< visibility of each candidate
  std::vector<Implant> implants;       ///< each candidate added to these logs (implantAll())

  /// Returns the hypothesis with this index in the evidence.
  const FittedHypothesis& at(int hypothesis) const;

  /// Returns the singles, pairs and triples in the order of the evidence.
  std::vector<const FittedHypothesis*> withEffects() const;

  /// Returns true if a hypothesis competes (fit::Hypothesis::competes()) and contains none of the effects `without`.
  bool competes(const fit::Hypothesis& hypothesis, const std::vector<std::string>& without) const;

  /// Returns the likeliest hypothesis on all logs other than `one`, possibly the model without effects.
  const FittedHypothesis& likeliestBeside(const FittedHypothesis& one) const;
};

/// Returns the evidence of a search without the logs, errors and sizes, which evidenceOfLogs() or diagnoseTable() adds.
judge::Evidence evidenceOf(const Search& search);

/// Returns evidence that describes the candidates only, without hypotheses and exclusions.
judge::Evidence evidenceOfNone(const Search& search);

/// Called with the name of the stage and the fraction of the search that is done.
using ProgressCallback = std::function<void(const std::string&, double)>;

class Measured;

/// Returns the excluded effects. Throws std::invalid_argument if the options exclude an unknown effect.
std::vector<std::string> excludedEffects(const io::ComponentDescription& component, const DiagnosisOptions& options);

/// Fits hypotheses to a measurement on `threads` threads. If effects are excluded, the search first fits the hypotheses
/// without them, and then continues as if nothing were excluded.
Search search(const Measured& measured, const std::vector<std::string>& excluded, int threads,
              const ProgressCallback& progress = {});

}  // namespace rubber_suspension::diagnosis::hypotheses
