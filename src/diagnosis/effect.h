// Effects that a diagnosis may name. Each is declared in one file of hypotheses/candidate/.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "fit/excitation.h"
#include "fit/hypothesis.h"
#include "rubber_suspension/element/parameter.h"
#include "rubber_suspension/io/component_file.h"

namespace rubber_suspension::diagnosis {

/// A number that reports state for an effect.
struct HeadlineValue {
  std::string name;
  std::string unit;  ///< in SI units; "1" for a dimensionless number
  double value = 0.0;
  bool is_scale = false;  ///< the effect vanishes if the number is 0
};

/// States whether an effect is visible in the settled loops of a table, or else why not.
enum class InSettledLoops {
  shown,
  over_before,      ///< the effect, such as softening or warming, ends before a loop has settled
  has_crept,        ///< the creep has ended before a loop has settled
  no_part_of_loop,  ///< the effect is a constant force or a trend, which a loop does not contain
};

/// The declaration of an effect: everything that is known of the effect without any log.
struct Effect {
  using Entries = std::vector<element::ElementDescription>;

  int place = 0;  ///< position in the list and on the reference page; unique
  std::string name = {};
  std::string documentation = {};  ///< one sentence that describes the effect and how it shows in logs
  bool on_rig = false;             ///< the effect belongs to the rig, not to the rubber
  /// Adds basis terms with bounds to a candidate; adds none if logs with this excitation cannot show the effect.
  void (*add_terms)(const fit::Excitation& excitation, fit::Candidate& candidate) = nullptr;
  InSettledLoops in_settled_loops = InSettledLoops::shown;
  bool falls_like_warming = false;  ///< lowers the stiffness in the course of the logs, as a warming room does
  /// Why tables cannot be diagnosed if the component has an element of this name; empty if they can.
  std::string not_beside_tables = {};
  /// Effects that are limits of the law of this effect, which can therefore represent them.
  std::vector<std::string> contains = {};

  /// Rewrites fitted entries as a user would write them. Null if the entries remain as fitted.
  void (*tidy)(Entries& entries) = nullptr;
  /// Returns the headline numbers of all entries of `headline_types` together. If null, movedOf() returns them.
  std::vector<HeadlineValue> (*headline)(const Entries& entries) = nullptr;
  std::vector<std::string> headline_types = {};
  /// Returns the sizes that logs with this excitation determine. Null if these are the headline numbers.
  std::vector<HeadlineValue> (*sizes)(const Entries& entries, const fit::Excitation& excitation) = nullptr;
  std::map<std::string, std::string> labels = {};  ///< texts in front of the headline numbers, by name

  /// Returns other causes of the same residual, which a report states in brackets; empty if there are none.
  std::string (*readings)(const io::ComponentDescription& configured) = nullptr;
  /// Returns phrases that follow the headline numbers, from the entries of the augmented component.
  std::vector<std::string> (*facts)(const Entries& augmented) = nullptr;
  /// Returns a sentence about the headline numbers, for a verdict that names this effect first.
  std::string (*remark)(const std::map<std::string, double>& numbers) = nullptr;
  /// Sentence for a verdict of wrong values to which this effect alone is an alternative.
  std::string beside_values = {};
};

/// Adds an effect to the list when it is constructed. Each effect defines one as a static object in its own file.
struct EffectEntry {
  explicit EffectEntry(const Effect& effect);
};

/// Returns all effects sorted by `place`. Throws std::logic_error if two effects have the same place.
const std::vector<Effect>& effects();

/// Returns the effect with this name, or an effect with default values if no effect has it.
const Effect& effectNamed(const std::string& name);

/// Returns a candidate for each effect for logs with this excitation, sorted by `place`.
std::vector<fit::Candidate> candidates(const fit::Excitation& excitation);

/// Returns the headline numbers of entries: the numbers that a fit changes, without options and reference values. If
/// the type of an entry is one of the headline_types of an effect, Effect::headline computes the numbers of all such
/// entries together; otherwise movedOf() computes those of each type.
std::vector<HeadlineValue> headlineValuesOf(const std::vector<element::ElementDescription>& entries);

/// Returns the headline numbers by name, as report.json contains them.
std::map<std::string, double> headlineOf(const std::vector<element::ElementDescription>& entries);

/// Returns the numbers that a fit changes in an entry. For several entries of one type, returns only the sum of their
/// first parameter, as total_NAME; reductions by softening, which act one after the other, are compounded.
std::vector<HeadlineValue> movedOf(const std::vector<element::ElementDescription>& group);

/// Returns a value of an entry, or `otherwise` if the entry lacks it.
double valueOr(const element::ElementDescription& entry, const std::string& name, double otherwise);

}  // namespace rubber_suspension::diagnosis
