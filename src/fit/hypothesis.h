// A hypothesis: the candidate effects that are supposed to be at work beside a model, ready to be fitted.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "fit/candidate.h"
#include "fit/free_in_log.h"
#include "rubber_suspension/log/record.h"

namespace rubber_suspension::fit {

/// Without members it is the model alone, its parameters free.
struct Hypothesis {
  std::vector<int> members;      ///< the candidates at work by their index, ascending
  std::vector<BasisTerm> terms;  ///< of all members, one member after the other
  FreeInLog free_in_log;         ///< is free as well
  /// The effect of one standard deviation of the displacement's zero on the force of each log [N], over what it counts
  /// as in units of the force's standard deviation (DisplacementZero); null: nothing.
  std::shared_ptr<const std::vector<Eigen::VectorXd>> by_zero;
  bool like_parameters = false;  ///< re-estimated parameters do the same as terms of it

  /// Whether it competes with others: it has terms, and may do what parameters do not.
  bool competes() const { return !terms.empty() && (!like_parameters || free_in_log.gain); }

  /// True if the force is that of the model plus those of the terms.
  bool isAdditive() const;
};

/// The hypothesis that these candidates are at work.
Hypothesis makeHypothesis(const std::vector<Candidate>& candidates, const std::vector<int>& members);

/// Where a fit of a hypothesis is.
struct ParameterVector {
  Eigen::VectorXd model;   ///< logarithms of the model parameters over their configured values
  Eigen::VectorXd scales;  ///< of the hypothesis' basis terms

  /// Largest magnitude among the logarithms: how far a model parameter is from its configured value.
  double largestChange() const { return model.size() > 0 ? model.cwiseAbs().maxCoeff() : 0.0; }
};

/// Find the unit effects of additive and softening terms on these records once, so that fits need not simulate them.
void findUnitEffects(std::vector<Candidate>& candidates, const std::vector<log::Record>& records, int threads);

/// The same hypothesis about other records: terms whose force the records tell have it, all others are to be simulated.
Hypothesis aboutOtherRecords(const Hypothesis& hypothesis, const std::vector<log::Record>& records);

}  // namespace rubber_suspension::fit
