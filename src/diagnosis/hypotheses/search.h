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

/// By this ratio at most, a fit predicts blocks that took no part in it better than it fits the others: by chance.
constexpr double kBetterByChance = 1.02;

/// Noise floors, in units of the force's standard deviation.
struct Noise {
  double floor = 0.0;           ///< of all logs
  double floor_with_rig = 0.0;  ///< the same with the errors of the rig, which any model leaves
  std::vector<double> of_logs;  ///< floor of each log of the fit
  std::vector<double> unseen;   ///< floor of each log held out (floorsOfUnseen())
  std::vector<double> rest;     ///< of each log, noise of the least that models leave
  std::vector<double> caused;   ///< of each log, what the noise of the displacement causes in the model
  std::string source;
};

/// Visibility of a candidate in the logs.
struct Visibility {
  double share = 0.0;     ///< part of its force that re-estimation does not hide [-]
  bool testable = false;  ///< a typical size of it would show in these logs
};

/// Everything that was tried. Errors are root mean squares in units of the force's standard deviation.
struct Search {
  fit::Excitation excitation;
  std::vector<fit::Candidate> candidates;
  std::vector<std::string> excluded;  ///< effects that are ruled out, and fitted for what they would be otherwise
  bool guess = false;                 ///< the data sheet is a guess
  double configured_gap = 0.0;        ///< as configured, without any fit
  /// Parameters as configured. Where they are not worth a change, those re-estimated are within the noise of them:
  /// their held-out blocks stand for these.
  FittedHypothesis as_configured;
  FittedHypothesis re_estimated;          ///< model parameters alone
  std::vector<FittedHypothesis> singles;  ///< one per candidate, in their order
  std::vector<FittedHypothesis> pairs;    ///< those that a screening of all found worth a full fit, best first
  std::vector<FittedHypothesis> triples;
  double surrogate_gap = 0.0;   ///< held out, all candidates at once: what a flexible fit could close
  double discretisation = 0.0;  ///< what dashpots of the model err by at the time steps of the logs
  Noise noise;
  std::vector<Visibility> visibility;  ///< of each candidate
  std::vector<Implant> implants;       ///< each candidate implanted into these logs; none into a table

  /// A hypothesis by its place in the evidence.
  const FittedHypothesis& at(int hypothesis) const;

  /// Singles, pairs and triples, in the order of the evidence.
  std::vector<const FittedHypothesis*> withEffects() const;

  /// True if a hypothesis competes with others: it does by itself, and has none of these effects.
  bool competes(const fit::Hypothesis& hypothesis, const std::vector<std::string>& without) const;

  /// The likeliest besides one, by what it leaves of all logs: with effects, or the model alone.
  const FittedHypothesis& likeliestBeside(const FittedHypothesis& one) const;
};

/// The hypotheses of a search, each without what it leaves of logs and what its members add to them: that is what
/// logs tell (evidenceOfLogs()), or the rows of a table.
judge::Evidence evidenceOf(const Search& search);

/// Evidence without any hypothesis, and with nothing excluded.
judge::Evidence evidenceOfNone(const Search& search);

/// Called with the stage's name and the fraction done.
using ProgressCallback = std::function<void(const std::string&, double)>;

class Measured;

/// Effects that the component or the options rule out. Throws std::invalid_argument for a name that is none.
std::vector<std::string> excludedEffects(const io::ComponentDescription& component, const DiagnosisOptions& options);

/// Fit all hypotheses about what was measured on `threads` threads. With effects that are excluded the search
/// continues once the others are fitted, as if nothing was.
Search search(const Measured& measured, const std::vector<std::string>& excluded, int threads,
              const ProgressCallback& progress = {});

}  // namespace rubber_suspension::diagnosis::hypotheses
