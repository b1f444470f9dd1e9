// Candidate effects: what a model may lack, as entries for `add:` whose scales a fit determines; and hypotheses that
// some of them are at work, ready to be fitted.
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

/// One entry for `add:` and the scale that a fit determines. The component's force is taken as differentiable in the
/// scale; at scale 0 the entry is left out.
struct BasisTerm {
  std::function<element::ElementDescription(double scale)> at;  ///< null: it is a number of Hypothesis::law
  double typical = 1.0;                                         ///< a scale of the order that a visible effect has
  double start = 0.0;  ///< a scale that fits may start from besides 0, where what was measured tells one
  double lower = 0.0;
  double upper = element::kLargestNumber;
  bool additive = true;    ///< the force is that of the component plus scale times that of the entry alone
  bool refines = false;    ///< much like its fellows, so that a fit far from its end would confuse them
  bool on_rig = false;     ///< additive whatever effects act on the component
  bool is_offset = false;  ///< the scale is a zero of all forces: of those that are free in each log, the mean
  bool is_gain = false;    ///< the scale is a gain on all forces: of gains that are free in each log, the mean
  /// A force effect whose factor is 1 less the scale times a share that the displacement alone decides.
  bool softening = false;
  bool of_a_side = false;  ///< differs from its fellows by a side only, which a settled loop about its mean has not
  /// A zero of the displacement changes more of it than its mean; set by Fitter::prepare.
  bool depends_on_place = false;
  /// Force of the entry alone at scale 1 where samples to come tell it better than the entry, which may not look ahead.
  std::function<Eigen::VectorXd(const log::Record&)> exact;
  /// The effect of the entry on each log at scale 1: the force that it adds [N], or the share of the component's force
  /// that it takes [-]. Set by findUnitEffects for additive and softening terms.
  ForceColumn unit_effect;

  /// True if the effect of the term at scale 1 depends on the displacement alone.
  bool hasUnitEffect() const { return additive || softening; }
};

/// A stiffness that grows with the displacement.
struct Curve {
  double growth = 0.0;  ///< logarithm of that at the largest displacement over that at 0
  double side = 0.0;    ///< 1: in tension only, -1: in compression only, 0: in both
};

/// An unmodelled effect by its name in reports. Its basis terms span the shapes that the effect's law can take: their
/// scales are bounded such that only physical laws can be composed (dissipating friction, stiffening stops, ...).
struct Candidate {
  std::string effect;
  std::string documentation;  ///< what it is and its signature, one sentence
  bool on_rig = false;        ///< belongs to the rig, not to the rubber
  std::vector<BasisTerm> terms;
  /// Effects that its law has as a limit: it holds their terms besides its own.
  std::vector<std::string> contains = {};
  /// So many terms make one law; each further one at work is a number more. 0: any number of terms is one law.
  std::size_t terms_of_one = 0;
  PerLogNuisances free_in_log = {};  ///< belongs to it
  bool one_form = false;     ///< its law has one form, as that of a mass; others stand for the rubber's or the rig's
  bool constant = false;     ///< adds a constant force, whose form is never wrong
  bool is_friction = false;  ///< may have a factor of its own in each log
  /// Equivalent to scaling all model parameters: alone it is another reading of wrong ones; beside other effects it
  /// competes only if gains differ between logs.
  bool like_parameters = false;

  /// The terms at a value of a number that the force is not linear in, which lies between these; null: there is none.
  std::function<std::vector<BasisTerm>(double)> terms_at = nullptr;
  double least_shape = 0.0;
  double largest_shape = 0.0;
  /// The terms of a law that follows a curve, in place of its own and with one number more; null: it follows none.
  std::function<std::vector<BasisTerm>(const Curve&)> along = nullptr;
  std::vector<BasisTerm> curved = {};  ///< those of the curve that was found; empty: none is worth its number
  /// Further laws of few numbers, at the places where a fit of all their numbers may start: after the verdict one of
  /// these, or a few of the terms, stands for the effect.
  std::vector<BasisTerm> laws = {};

  /// False where the logs lack what would show it at all: then it has no terms, and takes part in nothing.
  bool applies() const { return !terms.empty(); }

  /// True if it competes with others: it applies, and has an effect that parameters do not have.
  bool competes() const { return applies() && (!like_parameters || free_in_log.gain); }
};

/// A basis term that scales one parameter of an element whose force is linear in it, the others being given.
BasisTerm additiveTerm(const std::string& type, const std::string& scaled, double typical,
                       const element::ParameterValues& others = {});

/// A basis term by its candidate, and by its place among the terms of that; those along a curve come after them.
struct TermPlace {
  int candidate = 0;
  std::size_t term = 0;

  friend bool operator==(const TermPlace& a, const TermPlace& b) {
    return a.candidate == b.candidate && a.term == b.term;
  }
};

/// Candidates at work beside a model. Without members it is the model alone, its parameters free.
struct Hypothesis {
  std::vector<int> members;       ///< the candidates at work by their index, ascending
  std::vector<BasisTerm> terms;   ///< of all members, one member after the other
  std::vector<TermPlace> places;  ///< of these among the candidates
  /// Terms of each member: its own, then those of what it contains, without those of an earlier member.
  std::vector<std::size_t> counts;
  std::vector<int> held;        ///< contained candidates whose terms it has
  std::vector<int> curved;      ///< of these and of the members those whose terms follow the curve
  PerLogNuisances free_in_log;  ///< is free as well
  /// The entries of a law with numbers of its own, which are those terms that have no entry, by all scales; null: there
  /// is none.
  std::function<std::vector<element::ElementDescription>(const Eigen::VectorXd& scales)> law;
  bool like_parameters = false;  ///< re-estimated parameters do the same as terms of it

  /// True if it competes with others: it has terms, and an effect that parameters do not have.
  bool competes() const { return !terms.empty() && (!like_parameters || free_in_log.gain); }

  /// True if model parameters are those configured, because its terms replace their changes.
  bool keepsParameters() const { return !terms.empty() && like_parameters && !free_in_log.gain; }

  /// True if the force is that of the model plus those of the terms.
  bool isAdditive() const;
};

/// The hypothesis that these candidates are at work. A member that contains several laws is beyond one of them at a
/// time, the first of `preferred`: beyond all of them it would be beyond a set, and no simpler than that. Candidates of
/// `curved` follow the curve.
Hypothesis makeHypothesis(const std::vector<Candidate>& candidates, const std::vector<int>& members,
                          const std::vector<int>& preferred = {}, const std::vector<int>& curved = {});

/// True if a candidate contains another one.
bool contains(const Candidate& larger, const Candidate& smaller);

/// Indices of the candidates that a candidate contains.
std::vector<int> containedBy(const std::vector<Candidate>& candidates, const Candidate& larger);

/// True if a set of candidates contains another one: for each of its members it has the same or one that contains it.
bool holds(const std::vector<Candidate>& candidates, const std::vector<int>& larger, const std::vector<int>& smaller);

/// The numbers at these scales that are not at their limits and that the members have beyond the laws that they
/// contain: at least one for each member that contains any; and one for each that follows a curve.
std::size_t numbersBeyond(const std::vector<Candidate>& candidates, const Hypothesis& hypothesis,
                          const Eigen::VectorXd& scales);

/// Where a fit of a hypothesis is.
struct ParameterVector {
  Eigen::VectorXd model;   ///< logarithms of the model parameters over their configured values
  Eigen::VectorXd scales;  ///< of the hypothesis' basis terms

  /// Largest magnitude among the logarithms: how far a model parameter is from its configured value.
  double largestChange() const { return model.size() > 0 ? model.cwiseAbs().maxCoeff() : 0.0; }
};

/// The effect of the entry of an additive or softening term on each log at scale 1: the force that it adds [N], or the
/// share of the component's force that it takes [-].
gap::Forces effectOfEntry(const BasisTerm& term, const std::vector<gap::PreparedRecord>& records);

/// Find the unit effects of additive and softening terms on these records once, so that fits need not simulate them.
void findUnitEffects(std::vector<Candidate>& candidates, const std::vector<gap::PreparedRecord>& records, int threads);

/// Returns the hypothesis for other records, with the force of terms that follows from the records; all others are to
/// be simulated.
Hypothesis aboutOtherRecords(const Hypothesis& hypothesis, const std::vector<gap::PreparedRecord>& records);

}  // namespace rubber_suspension::fit
