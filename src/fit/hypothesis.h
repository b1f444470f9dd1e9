// Candidate effects that a model may lack, as entries for `add:` whose scales a fit determines, and hypotheses, which
// are sets of candidates.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "element/largest_number.h"
#include "fit/free_in_log.h"
#include "rubber_suspension/element/parameter.h"
#include "rubber_suspension/gap/prepared_record.h"
#include "rubber_suspension/log/record.h"

namespace rubber_suspension::fit {

/// One entry for `add:` and the scale that a fit determines. The force is assumed to be differentiable in the scale; at
/// scale 0 the entry is omitted.
struct BasisTerm {
  std::function<element::ElementDescription(double scale)> at;  ///< null: the scale is a parameter of Hypothesis::law
  double typical = 1.0;                                         ///< a scale of the order that a visible effect has
  double start = 0.0;  ///< a further scale from which fits may start, if the measurement suggests one
  double lower = 0.0;
  double upper = element::kLargestNumber;
  bool additive = true;  ///< the force is that of the component plus scale times that of the entry alone
  bool refines = false;  ///< too similar to the other terms of its effect to be determined in the first steps of a fit
  bool on_rig = false;   ///< additive whatever effects act on the component
  bool is_offset = false;  ///< the scale is an offset of all forces: the mean of those that are free in each log
  bool is_gain = false;    ///< the scale is a gain on all forces: the mean of those that are free in each log
  /// A force effect with the factor 1 - scale * share, where the share depends on the displacement alone.
  bool softening = false;
  bool of_a_side = false;  ///< differs from other terms in its side only, which a settled loop does not show
  /// An offset of the displacement changes more of its force than the mean; set by Fitter::prepare.
  bool depends_on_place = false;
  /// Force of the entry alone at scale 1 from later samples as well, which the entry itself cannot use; null: none.
  std::function<Eigen::VectorXd(const log::Record&)> exact;
  /// The effect of the entry on each log at scale 1: the force that it adds [N], or the share by which it reduces the
  /// force [-]. Set by findUnitEffects for additive and softening terms.
  ForceColumn unit_effect;

  /// Returns true if the effect of the term at scale 1 depends on the displacement alone.
  bool hasUnitEffect() const { return additive || softening; }
};

/// A stiffness that grows with the displacement.
struct Curve {
  double growth = 0.0;  ///< ln of the stiffness at the largest displacement over that at 0
  double side = 0.0;    ///< 1: in tension only, -1: in compression only, 0: in both
};

/// An unmodelled effect by its name in reports. Its basis terms span the shapes that the effect's law can have; bounds
/// on their scales admit physical laws only (dissipating friction, stiffening stops, ...).
struct Candidate {
  std::string effect;
  std::string documentation;  ///< what it is and its signature, one sentence
  bool on_rig = false;        ///< belongs to the rig, not to the rubber
  std::vector<BasisTerm> terms;
  /// Effects that are limits of its law; a hypothesis has the terms of one of them as well.
  std::vector<std::string> contains = {};
  /// Number of terms that make one law; each further nonzero one counts as a parameter. 0: any number is one law.
  std::size_t terms_of_one = 0;
  PerLogNuisances free_in_log = {};  ///< nuisance parameters that belong to it
  bool one_form = false;     ///< its law has a single form, such as that of a mass; others approximate the true law
  bool constant = false;     ///< adds a constant force, which has no form error
  bool is_friction = false;  ///< may have a separate factor in each log
  /// Equivalent to a factor on all model parameters, which alone it cannot be distinguished from; it competes with
  /// other effects only if gains differ between logs.
  bool like_parameters = false;

  /// The terms at a value of a shape parameter, in which the force is not linear; null: there is none.
  std::function<std::vector<BasisTerm>(double)> terms_at = nullptr;
  double least_shape = 0.0;
  double largest_shape = 0.0;
  /// The terms of a law along a curve, which replace `terms` and have one parameter more; null: there is none.
  std::function<std::vector<BasisTerm>(const Curve&)> along = nullptr;
  std::vector<BasisTerm> curved = {};  ///< `along` the curve that was found; empty: no curve is worth its parameter
  /// Further laws of few parameters, at points where a fit of all of these may start: after the verdict one of them, or
  /// a few of the terms, represents the effect.
  std::vector<BasisTerm> laws = {};

  /// Returns false if the logs cannot show the effect at all: it has no terms then.
  bool applies() const { return !terms.empty(); }

  /// Returns true if it competes with others: it applies, and changes of model parameters cannot replace it.
  bool competes() const { return applies() && (!like_parameters || free_in_log.gain); }
};

/// Returns a basis term that scales one parameter of an element, in which its force is linear; the others are given.
BasisTerm additiveTerm(const std::string& type, const std::string& scaled, double typical,
                       const element::ParameterValues& others = {});

/// A basis term by its candidate and its index among the candidate's terms, followed by those along a curve.
struct TermPlace {
  int candidate = 0;
  std::size_t term = 0;

  friend bool operator==(const TermPlace& a, const TermPlace& b) {
    return a.candidate == b.candidate && a.term == b.term;
  }
};

/// A set of candidates that act in addition to a model. The empty set is the model alone with free parameters.
struct Hypothesis {
  std::vector<int> members;       ///< indices of the candidates, ascending
  std::vector<BasisTerm> terms;   ///< of all members, one member after the other
  std::vector<TermPlace> places;  ///< of the terms among the candidates
  /// Number of terms of each member: its own and those that it contains, without those of an earlier member.
  std::vector<std::size_t> counts;
  std::vector<int> held;        ///< contained candidates whose terms it has as well
  std::vector<int> curved;      ///< members and held candidates whose terms follow the curve
  PerLogNuisances free_in_log;  ///< nuisance parameters that are free as well
  /// Entries of a law whose parameters are the scales of the terms without entry, as a function of all scales; null:
  /// there is none.
  std::function<std::vector<element::ElementDescription>(const Eigen::VectorXd& scales)> law;
  bool like_parameters = false;  ///< changes of model parameters can replace its terms

  /// Returns true if it competes with others: it has terms that changes of model parameters cannot replace.
  bool competes() const { return !terms.empty() && (!like_parameters || free_in_log.gain); }

  /// Returns true if model parameters stay as configured, because its terms replace their changes.
  bool keepsParameters() const { return !terms.empty() && like_parameters && !free_in_log.gain; }

  /// Returns true if the force is that of the model plus those of the terms.
  bool isAdditive() const;
};

/// Returns the hypothesis that these candidates act. A member that contains several laws extends one of them, the first
/// of `preferred`: if it extended all of them, it would be no simpler than the set of these. Candidates of `curved`
/// follow the curve.
Hypothesis makeHypothesis(const std::vector<Candidate>& candidates, const std::vector<int>& members,
                          const std::vector<int>& preferred = {}, const std::vector<int>& curved = {});

/// Returns true if a candidate contains another one.
bool contains(const Candidate& larger, const Candidate& smaller);

/// Returns the indices of the candidates that a candidate contains.
std::vector<int> containedBy(const std::vector<Candidate>& candidates, const Candidate& larger);

/// Returns true if each member of `smaller` is in `larger` or is contained by a member of it.
bool holds(const std::vector<Candidate>& candidates, const std::vector<int>& larger, const std::vector<int>& smaller);

/// Returns the number of parameters that the members have beyond the laws that they contain, or beyond one law: own
/// terms with nonzero scales, at least one for a member that contains a law, and one for each curve.
std::size_t numbersBeyond(const std::vector<Candidate>& candidates, const Hypothesis& hypothesis,
                          const Eigen::VectorXd& scales);

/// The parameters of a fit of a hypothesis.
struct ParameterVector {
  Eigen::VectorXd model;   ///< logarithms of the model parameters over their configured values
  Eigen::VectorXd scales;  ///< of the hypothesis' basis terms

  /// Returns the largest magnitude among the logarithms of the model parameters' ratios.
  double largestChange() const { return model.size() > 0 ? model.cwiseAbs().maxCoeff() : 0.0; }
};

/// Returns the effect of the entry of an additive or softening term on each log at scale 1: the force that it adds [N],
/// or the share by which it reduces the force [-].
gap::Forces effectOfEntry(const BasisTerm& term, const std::vector<gap::PreparedRecord>& records);

/// Finds the unit effects of additive and softening terms on these records once, so that fits need not simulate them.
void findUnitEffects(std::vector<Candidate>& candidates, const std::vector<gap::PreparedRecord>& records, int threads);

/// Returns the hypothesis for other records: terms with an `exact` force have it as unit effect, all others have to be
/// simulated.
Hypothesis aboutOtherRecords(const Hypothesis& hypothesis, const std::vector<gap::PreparedRecord>& records);

}  // namespace rubber_suspension::fit
