// Candidates and hypotheses. A candidate is an effect that a model may lack, with entries for `add:` whose scales a fit
// determines. A hypothesis is a set of candidates.
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

/// An entry for `add:` with a scale that a fit determines. The force is assumed to be differentiable with respect to
/// the scale. At scale 0 the entry is omitted.
struct BasisTerm {
  std::function<element::ElementDescription(double scale)> at;  ///< null if the scale is a parameter of Hypothesis::law
  double typical = 1.0;                                         ///< typical scale of a visible effect
  double start = 0.0;  ///< another scale from which fits may start, if the measurement suggests one
  double lower = 0.0;
  double upper = element::kLargestNumber;
  bool additive = true;    ///< the force is that of the component plus scale times the force of the entry alone
  bool refines = false;    ///< too similar to other terms of its effect to be determined in the first steps of a fit
  bool on_rig = false;     ///< additive even if effects act on the component
  bool is_offset = false;  ///< the scale is a force offset of all logs: the mean of the offsets fitted to each log
  bool is_gain = false;    ///< the scale is a gain of all logs: the mean of the gains fitted to each log
  /// The entry is a factor 1 - scale * share on the force, where the share depends only on the displacement.
  bool softening = false;
  bool of_a_side = false;  ///< differs from other terms only in its side, which a settled loop does not show
  /// A displacement offset changes more than the mean of the term's force. Set by Fitter::prepare().
  bool depends_on_place = false;
  /// Returns the force of the entry at scale 1 from later samples, too, which the entry itself cannot use; may be null.
  std::function<Eigen::VectorXd(const log::Record&)> exact;
  /// Effect of the entry on each log at scale 1: the force that it adds [N], or the share by which it reduces the force
  /// [-]. Set by findUnitEffects() for additive and softening terms.
  ForceColumn unit_effect;

  /// Returns true if the effect of the term at scale 1 depends only on the displacement.
  bool hasUnitEffect() const { return additive || softening; }
};

/// A stiffness that grows with the displacement. Some laws can scale with the slope of such a curve.
struct Curve {
  double growth = 0.0;  ///< ln of the stiffness at the largest displacement over that at 0
  double side = 0.0;    ///< 1: grows in tension only, -1: in compression only, 0: in both
};

/// An unmodelled effect, with its name in reports. Its basis terms approximate all forms of the effect's law. Bounds on
/// their scales admit only physical laws (dissipating friction, stiffening stops, ...).
struct Candidate {
  std::string effect;
  std::string documentation;  ///< one sentence on the effect and its signature
  bool on_rig = false;        ///< true for an effect of the rig, not of the rubber
  std::vector<BasisTerm> terms;
  /// Effects that are limiting cases of the law. A hypothesis also has the terms of one of them.
  std::vector<std::string> contains = {};
  /// Number of nonzero terms of the law that was fitted alone; 0 before this fit.
  std::size_t numbers_alone = 0;
  /// Number of terms that one law needs; each further nonzero term counts as a parameter. 0 if any number is one law.
  std::size_t terms_of_one = 0;
  PerLogNuisances free_in_log = {};  ///< nuisance parameters that are fitted with the candidate
  bool one_form = false;     ///< true if the law has one form, such as a mass; other laws only approximate the true law
  bool constant = false;     ///< true if it adds a constant force, which has no form error
  bool is_friction = false;  ///< true if friction may have a separate factor in each log
  /// True if the effect is equivalent to a factor on all model parameters. It then competes with other effects only if
  /// gains differ between logs.
  bool like_parameters = false;

  /// Returns the terms for a value of a shape parameter, on which the force depends nonlinearly; null without a shape.
  std::function<std::vector<BasisTerm>(double)> terms_at = nullptr;
  double least_shape = 0.0;
  double largest_shape = 0.0;
  /// Returns the terms of a law that scales with a curve, to replace `terms` with one more parameter; may be null.
  std::function<std::vector<BasisTerm>(const Curve&)> along = nullptr;
  std::vector<BasisTerm> curved = {};  ///< terms along the best curve; empty if no curve justifies a further parameter
  /// Further laws of few parameters. Each is a point from which a fit of all of them may start. After the verdict one
  /// of these laws, or a few of the terms, represents the effect.
  std::vector<BasisTerm> laws = {};

  /// Returns false if the logs cannot show the effect, so that it has no terms.
  bool applies() const { return !terms.empty(); }

  /// Returns true if the effect applies and changes of model parameters cannot replace it.
  bool competes() const { return applies() && (!like_parameters || free_in_log.gain); }
};

/// Returns a term that scales one parameter of an element, in which its force is linear. `others`: further parameters.
BasisTerm additiveTerm(const std::string& type, const std::string& scaled, double typical,
                       const element::ParameterValues& others = {});

/// Candidate of a basis term, and index among the candidate's terms. Terms along a curve follow the others.
struct TermPlace {
  int candidate = 0;
  std::size_t term = 0;

  friend bool operator==(const TermPlace& a, const TermPlace& b) {
    return a.candidate == b.candidate && a.term == b.term;
  }
};

/// A set of candidates that act in addition to a model. The empty set is the model alone, whose parameters are fitted.
struct Hypothesis {
  std::vector<int> members;       ///< indices of the candidates, ascending
  std::vector<BasisTerm> terms;   ///< terms of all candidates, in the order of `members`
  std::vector<TermPlace> places;  ///< candidate and index of each term
  /// Number of terms of each candidate, with the terms of contained effects and without terms of an earlier candidate.
  std::vector<std::size_t> counts;
  std::vector<int> held;        ///< contained candidates whose terms the hypothesis also has
  std::vector<int> curved;      ///< candidates, including contained ones, whose terms follow a curve
  PerLogNuisances free_in_log;  ///< nuisance parameters that are fitted with the hypothesis
  /// Returns the entries of a law as a function of all scales; null without a law. Terms without an entry of their own
  /// are parameters of this law.
  std::function<std::vector<element::ElementDescription>(const Eigen::VectorXd& scales)> law;
  bool like_parameters = false;  ///< true if changes of model parameters can replace the terms

  /// Returns true if the hypothesis has terms that changes of model parameters cannot replace.
  bool competes() const { return !terms.empty() && (!like_parameters || free_in_log.gain); }

  /// Returns true if model parameters keep their configured values, because the terms replace changes of parameters.
  bool keepsParameters() const { return !terms.empty() && like_parameters && !free_in_log.gain; }

  /// Returns true if the force is the force of the model plus the forces of the terms.
  bool isAdditive() const;
};

/// Returns the hypothesis with the candidates `members`. If a candidate contains several laws, it extends only one of
/// them, preferably the first of `preferred`. Otherwise it would be no simpler than all these laws together. `curved`:
/// candidates whose terms follow a curve (Candidate::curved).
Hypothesis makeHypothesis(const std::vector<Candidate>& candidates, const std::vector<int>& members,
                          const std::vector<int>& preferred = {}, const std::vector<int>& curved = {});

/// Returns true if a candidate contains another one.
bool contains(const Candidate& larger, const Candidate& smaller);

/// Returns the indices of the candidates that a candidate contains.
std::vector<int> containedBy(const std::vector<Candidate>& candidates, const Candidate& larger);

/// Returns true if each candidate of `smaller` is in `larger` or is contained by a candidate in it.
bool holds(const std::vector<Candidate>& candidates, const std::vector<int>& larger, const std::vector<int>& smaller);

/// Returns the number of parameters beyond the contained laws, or beyond one law per candidate. A law that contains
/// another counts for the nonzero terms that it has in addition to Candidate::numbers_alone of the contained law, but
/// at least for one, because its own terms may replace those of the contained law. Each curve is a parameter, too.
std::size_t numbersBeyond(const std::vector<Candidate>& candidates, const Hypothesis& hypothesis,
                          const Eigen::VectorXd& scales);

/// The parameters of a fit of a hypothesis.
struct ParameterVector {
  Eigen::VectorXd model;   ///< logarithms of the model parameters over their configured values
  Eigen::VectorXd scales;  ///< scales of the hypothesis' basis terms

  /// Returns the largest magnitude of an element of `model`.
  double largestChange() const { return model.size() > 0 ? model.cwiseAbs().maxCoeff() : 0.0; }
};

/// Returns the effect of an additive or softening term on each log at scale 1: the force that it adds [N], or the share
/// by which it reduces the force [-].
gap::Forces effectOfEntry(const BasisTerm& term, const std::vector<gap::PreparedRecord>& records);

/// Computes unit effects of additive and softening terms on these records once, so that fits need not simulate them.
void findUnitEffects(std::vector<Candidate>& candidates, const std::vector<gap::PreparedRecord>& records, int threads);

/// Returns the hypothesis for other records. Terms with an `exact` force use it as unit effect; all other terms have to
/// be simulated.
Hypothesis aboutOtherRecords(const Hypothesis& hypothesis, const std::vector<gap::PreparedRecord>& records);

}  // namespace rubber_suspension::fit
