// Effects that a diagnosis may name. Each is declared in one file of hypotheses/candidate/; nothing else branches on a
// name.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "fit/excitation.h"
#include "fit/hypothesis.h"
#include "rubber_suspension/element/parameter.h"
#include "rubber_suspension/io/component_file.h"

namespace rubber_suspension::diagnosis {

/// One headline number of an effect.
struct HeadlineValue {
  std::string name;
  std::string unit;  ///< SI; "1" for none
  double value = 0.0;
  bool is_scale = false;  ///< the effect vanishes if the value is 0
};

/// Visibility of an effect in the settled loops of a table, or the reason for none.
enum class InSettledLoops {
  shown,
  over_before,      ///< softening and warming end before a loop has settled
  has_crept,        ///< creep is over by then
  no_part_of_loop,  ///< a constant force or a trend
};

/// The declaration of an effect, which is all that is known of it before any log.
struct Effect {
  using Entries = std::vector<element::ElementDescription>;

  int place = 0;  ///< in the list and on the reference page; unique
  std::string name = {};
  std::string documentation = {};  ///< description and signature of the effect, one sentence
  bool on_rig = false;             ///< belongs to the rig, not to the rubber
  /// Adds the terms with their bounds for logs of an excitation; none if such logs cannot show the effect.
  void (*add_terms)(const fit::Excitation& excitation, fit::Candidate& candidate) = nullptr;
  InSettledLoops in_settled_loops = InSettledLoops::shown;
  bool falls_like_warming = false;  ///< stiffness falls in the course of logs, as in a warming room
  /// Reason why tables cannot be diagnosed with a component that has an element of this name; empty if they can.
  std::string not_beside_tables = {};
  /// Effects that are limits of its law, which can therefore represent them.
  std::vector<std::string> contains = {};

  /// Rewrites fitted entries as a user would write them; null if they stay as they are.
  void (*tidy)(Entries& entries) = nullptr;
  /// Returns the headline numbers of all entries of `headline_types` together; null: those of headlineValuesOf().
  std::vector<HeadlineValue> (*headline)(const Entries& entries) = nullptr;
  std::vector<std::string> headline_types = {};
  /// Returns the sizes that logs of this excitation determine, if these are not the headline numbers; else null.
  std::vector<HeadlineValue> (*sizes)(const Entries& entries, const fit::Excitation& excitation) = nullptr;
  std::map<std::string, std::string> labels = {};  ///< of headline numbers, in front of their values

  /// Returns other causes of the same residual, for brackets before the headline numbers; empty if there are none.
  std::string (*readings)(const io::ComponentDescription& configured) = nullptr;
  /// Returns phrases for the list of headline numbers, from the entries of the augmented component.
  std::vector<std::string> (*facts)(const Entries& augmented) = nullptr;
  /// Returns a sentence for a verdict that names this effect first, from its headline numbers.
  std::string (*remark)(const std::map<std::string, double>& numbers) = nullptr;
  /// Sentence for a verdict of wrong values, if this effect alone is an alternative.
  std::string beside_values = {};
};

/// Enters an effect into the list when constructed, as a static object in the effect's own file.
struct EffectEntry {
  explicit EffectEntry(const Effect& effect);
};

/// Returns all effects in the order of their places. Throws std::logic_error if two have the same place.
const std::vector<Effect>& effects();

/// Returns the effect of this name; for an unknown name, an effect of default values.
const Effect& effectNamed(const std::string& name);

/// Returns all effects as candidates for logs of this excitation, in the order of their places.
std::vector<fit::Candidate> candidates(const fit::Excitation& excitation);

/// Returns the headline numbers of entries: what a fit moved, without choices and references. Entries of the
/// headline_types of an effect are reduced together by its Effect::headline, entries of any other type by movedOf().
std::vector<HeadlineValue> headlineValuesOf(const std::vector<element::ElementDescription>& entries);

/// Returns headline numbers by name, as in report.json.
std::map<std::string, double> headlineOf(const std::vector<element::ElementDescription>& entries);

/// Returns the numbers of an entry that a fit moves. For several entries of one type, returns only the sum of their
/// first parameter, as total_NAME; reductions of softenings, which act one after the other, are compounded.
std::vector<HeadlineValue> movedOf(const std::vector<element::ElementDescription>& group);

/// Returns a value of an entry, or `otherwise` if the entry lacks it.
double valueOr(const element::ElementDescription& entry, const std::string& name, double otherwise);

}  // namespace rubber_suspension::diagnosis
