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
  bool is_scale = false;  ///< the effect is gone at 0
};

/// Visibility of an effect in the settled loops of a table, or the reason for none.
enum class InSettledLoops {
  shown,
  over_before,      ///< softening and heat are over before a loop has settled
  has_crept,        ///< what creeps has crept by then
  no_part_of_loop,  ///< a constant force or a trend
};

/// All that is known of an effect before any log.
struct Effect {
  using Entries = std::vector<element::ElementDescription>;

  int place = 0;  ///< in the list and on the reference page; no two effects have the same
  std::string name = {};
  std::string documentation = {};  ///< what it is and its signature, one sentence
  bool on_rig = false;             ///< belongs to the rig, not to the rubber
  /// Adds the terms with their bounds for logs of an excitation; none where these lack what would show the effect.
  void (*add_terms)(const fit::Excitation& excitation, fit::Candidate& candidate) = nullptr;
  InSettledLoops in_settled_loops = InSettledLoops::shown;
  bool falls_like_warming = false;  ///< stiffness falls in the course of logs, as it does where a room warms
  /// Why no table can be diagnosed with a component that has an element of this name; empty: it can.
  std::string not_beside_tables = {};
  /// Effects that its law has as limits, so that it can do all that these do.
  std::vector<std::string> contains = {};

  /// Writes entries of a fit as a user would; null: they stay as they are.
  void (*tidy)(Entries& entries) = nullptr;
  /// The headline numbers of all entries of these types together; null: those of headlineValuesOf().
  std::vector<HeadlineValue> (*headline)(const Entries& entries) = nullptr;
  std::vector<std::string> headline_types = {};
  /// The sizes that logs of this excitation determine, where these are not the numbers of the law; null: the headline
  /// numbers.
  std::vector<HeadlineValue> (*sizes)(const Entries& entries, const fit::Excitation& excitation) = nullptr;
  std::map<std::string, std::string> labels = {};  ///< of headline numbers, in front of their values

  /// Said in brackets before the headline numbers: other causes that a component cannot tell from it; empty: none.
  std::string (*readings)(const io::ComponentDescription& configured) = nullptr;
  /// Said among the headline numbers, by the entries of the augmented component.
  std::vector<std::string> (*facts)(const Entries& augmented) = nullptr;
  /// A sentence beside the verdict that names it first, by its headline numbers.
  std::string (*remark)(const std::map<std::string, double>& numbers) = nullptr;
  std::string beside_values = {};  ///< a sentence where it is another reading of wrong values
};

/// Enters an effect into the list: one static object in the effect's own file does it.
struct EffectEntry {
  explicit EffectEntry(const Effect& effect);
};

/// All effects in the order of their places. Throws std::logic_error where two claim the same place.
const std::vector<Effect>& effects();

/// The effect of this name; of a name that is not in the list one of which nothing is declared.
const Effect& effectNamed(const std::string& name);

/// All effects as candidates for logs of this excitation, in the order of their places.
std::vector<fit::Candidate> candidates(const fit::Excitation& excitation);

/// Headline numbers of an effect, as an engineer says them: what a fit moved, without choices and references. Entries
/// that an effect tells together (Effect::headline) have the numbers of that effect, other entries of one type
/// movedOf().
std::vector<HeadlineValue> headlineValuesOf(const std::vector<element::ElementDescription>& entries);

/// Headline numbers by name, as in report.json.
std::map<std::string, double> headlineOf(const std::vector<element::ElementDescription>& entries);

/// The numbers that a fit moves of an entry; of several of one type the sum of the first parameter of their law, as
/// total_NAME, and of softenings, which act one after the other, what all together take.
std::vector<HeadlineValue> movedOf(const std::vector<element::ElementDescription>& group);

/// A value of an entry, which may lack it.
double valueOr(const element::ElementDescription& entry, const std::string& name, double otherwise);

}  // namespace rubber_suspension::diagnosis
