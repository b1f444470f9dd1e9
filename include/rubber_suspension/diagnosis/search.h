// The search over candidate effects: all singles, all pairs, triples where a rest remains.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "rubber_suspension/fit/hypothesis.h"

namespace rubber_suspension::diagnosis {

/// A set of candidate effects fitted jointly with the model's own parameters.
struct Trial {
  std::vector<int> members;  ///< indices into Search::candidates, ascending
  std::vector<fit::Atom> atoms;
  fit::Fit fit;
};

/// Everything that was tried. Errors are root mean squares in units of the force's standard deviation.
struct Search {
  fit::Excitation excitation;
  std::vector<fit::Candidate> candidates;
  double configured_gap = 0.0;  ///< as configured
  Trial re_estimated;           ///< own parameters alone
  fit::Fit element_level;       ///< every parameter of every element of the model free, nothing added
  std::vector<Trial> singles;   ///< one per candidate, in their order
  std::vector<Trial> pairs;     ///< the pairs that a screening of all found worth a full fit, best first
  std::vector<Trial> triples;
  double surrogate_gap = 0.0;        ///< held out, all candidates at once: what a flexible fit could close
  double discretisation = 0.0;       ///< what dashpots of the model err by at the time steps of the logs
  double noise = 0.0;                ///< noise floor of all logs
  std::vector<double> record_noise;  ///< of each log, in units of its force's deviation
  std::string noise_source;
  std::vector<double> visible_share;  ///< per candidate: part of its force that re-estimation does not hide [-]
  std::vector<bool> testable;         ///< per candidate: a typical size of it would show in these logs
};

/// True if one of these candidates frees a slow trend per log.
bool hasTrends(const std::vector<fit::Candidate>& candidates, const std::vector<int>& members);

/// True if one of these candidates is named only where no others explain the gap.
bool hasLastResort(const std::vector<fit::Candidate>& candidates, const std::vector<int>& members);

/// Called with the stage's name and the fraction done.
using ProgressCallback = std::function<void(const std::string&, double)>;

/// Fit all hypotheses on `threads` threads.
Search search(const fit::Fitter& fitter, const fit::Fitter& element_level, int threads,
              const ProgressCallback& progress = {});

}  // namespace rubber_suspension::diagnosis
