// The search over candidate effects: all singles, and the likeliest pairs and triples until more effects are no
// likelier.
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

/// A hypothesis fitted jointly with the model parameters.
struct FittedHypothesis {
  fit::Hypothesis hypothesis;
  fit::Fit fit;
};

/// Largest ratio of the gap in sample to that on held-out blocks that chance explains.
constexpr double kBetterByChance = 1.02;

/// Noise floors, in units of the force's standard deviation.
struct Noise {
  double floor = 0.0;           ///< of all logs
  double floor_with_rig = 0.0;  ///< the same with the errors of the rig, which no model explains
  std::vector<double> of_logs;  ///< floor of each log of the fit
  std::vector<double> unseen;   ///< floor of each log held out (floorsOfUnseen())
  std::vector<double> rest;     ///< of each log, least noise in the residual of any model
  std::vector<double> caused;   ///< of each log, error that noise of the displacement causes in the model
  std::string source;
};

/// Visibility of a candidate in the logs.
struct Visibility {
  double share = 0.0;     ///< part of its force that re-estimation does not hide [-]
  bool testable = false;  ///< a typical size of it would show in these logs
};

/// All hypotheses that were tried. Errors are root mean squares in units of the force's standard deviation.
struct Search {
  fit::Excitation excitation;
  std::vector<fit::Candidate> candidates;
  std::vector<std::string> excluded;  ///< effects that are ruled out, but fitted for their probability otherwise
  bool guess = false;                 ///< the data sheet is a guess
  double configured_gap = 0.0;        ///< as configured, without any fit
  /// The model with its configured parameters. All else in its fit is that of the re-estimated model.
  FittedHypothesis as_configured;
  FittedHypothesis re_estimated;          ///< model parameters alone
  std::vector<FittedHypothesis> singles;  ///< one per candidate, in their order
  std::vector<FittedHypothesis> pairs;    ///< those that are worth a full fit by a screening of all, best first
  std::vector<FittedHypothesis> triples;
  double surrogate_gap = 0.0;   ///< held-out gap with all candidates at once, as of a flexible fit
  double discretisation = 0.0;  ///< gap due to the lag of dashpots at the time steps of the logs
  Noise noise;
  std::vector<Visibility> visibility;  ///< of each candidate
  std::vector<Implant> implants;       ///< each candidate implanted into these logs; none into a table

  /// Returns a hypothesis by its index in the evidence.
  const FittedHypothesis& at(int hypothesis) const;

  /// Returns singles, pairs and triples, in the order of the evidence.
  std::vector<const FittedHypothesis*> withEffects() const;

  /// Returns true if a hypothesis competes with others (fit::Hypothesis::competes()) and has none of these effects.
  bool competes(const fit::Hypothesis& hypothesis, const std::vector<std::string>& without) const;

  /// Returns the likeliest hypothesis other than `one` by its error over all logs; it may be the model alone.
  const FittedHypothesis& likeliestBeside(const FittedHypothesis& one) const;
};

/// Returns the evidence of a search without logs, errors and sizes, which evidenceOfLogs() or the rows of a table add.
judge::Evidence evidenceOf(const Search& search);

/// Returns evidence without hypotheses and without exclusions.
judge::Evidence evidenceOfNone(const Search& search);

/// Called with the stage's name and the fraction done.
using ProgressCallback = std::function<void(const std::string&, double)>;

class Measured;

/// Returns the effects that the component or the options rule out. Throws std::invalid_argument if the options name an
/// unknown effect.
std::vector<std::string> excludedEffects(const io::ComponentDescription& component, const DiagnosisOptions& options);

/// Fits hypotheses to a measurement on `threads` threads. If effects are excluded, the search first fits the others and
/// then continues as if nothing were excluded.
Search search(const Measured& measured, const std::vector<std::string>& excluded, int threads,
              const ProgressCallback& progress = {});

}  // namespace rubber_suspension::diagnosis::hypotheses
