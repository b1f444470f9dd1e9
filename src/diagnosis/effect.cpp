// The list of effects, and the numbers of a component file that reports state first.
#include "diagnosis/effect.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "element/each.h"
#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension::diagnosis {
namespace {

// The list is local, because static objects of different files are constructed in an undefined order.
std::vector<Effect>& entered() {
  static std::vector<Effect> list;
  return list;
}

std::vector<Effect> inOrder() {
  std::vector<Effect> list = entered();
  std::sort(list.begin(), list.end(), [](const Effect& a, const Effect& b) { return a.place < b.place; });
  const auto twice =
      std::adjacent_find(list.begin(), list.end(), [](const Effect& a, const Effect& b) { return a.place == b.place; });
  if (twice != list.end()) {
    throw std::logic_error("two effects have the same place: " + std::to_string(twice->place));
  }
  return list;
}

// Returns the effect whose headline numbers include entries of this type, or null if there is none.
const Effect* toldBy(const std::string& type) {
  const auto found = std::find_if(effects().begin(), effects().end(), [&](const Effect& effect) {
    const auto& types = effect.headline_types;
    return std::find(types.begin(), types.end(), type) != types.end();
  });
  return found == effects().end() ? nullptr : &*found;
}

}  // namespace

EffectEntry::EffectEntry(const Effect& effect) { entered().push_back(effect); }

const std::vector<Effect>& effects() {
  static const std::vector<Effect> list = inOrder();
  return list;
}

const Effect& effectNamed(const std::string& name) {
  static const Effect unknown;
  const auto found =
      std::find_if(effects().begin(), effects().end(), [&](const Effect& effect) { return effect.name == name; });
  return found == effects().end() ? unknown : *found;
}

std::vector<fit::Candidate> candidates(const fit::Excitation& excitation) {
  return element::each(effects(), [&](const Effect& effect) {
    fit::Candidate candidate{effect.name, effect.documentation, effect.on_rig, {}};
    effect.add_terms(excitation, candidate);
    // For tiny motions, the typical coefficients of terms of high powers exceed the range of every law.
    std::vector<fit::BasisTerm>& terms = candidate.terms;
    terms.erase(std::remove_if(terms.begin(), terms.end(), [](const auto& term) { return term.typical > term.upper; }),
                terms.end());
    if (candidate.applies()) {
      candidate.contains = effect.contains;
    }
    return candidate;
  });
}

double valueOr(const element::ElementDescription& entry, const std::string& name, double otherwise) {
  return entry.values.count(name) != 0 ? entry.value(name) : otherwise;
}

std::vector<HeadlineValue> movedOf(const std::vector<element::ElementDescription>& group) {
  std::vector<HeadlineValue> result;
  const std::vector<element::ParameterInfo>& table = element::findElementType(group.front().type)->parameters;
  for (const element::ParameterInfo& parameter : table) {
    const bool is_size = &parameter == &table.front();  // the first parameter of a law is its size
    const bool in_turn = parameter.name == "reduction";
    double sum = 0.0;
    bool given = false;
    for (const element::ElementDescription& entry : group) {
      const auto found = entry.values.find(parameter.name);
      given = given || (found != entry.values.end() && element::isFree(parameter, found->second));
      const double value = found == entry.values.end() ? 0.0 : found->second.at(0);
      sum += in_turn ? (1.0 - sum) * value : value;
    }
    if (given && (group.size() == 1 || is_size)) {
      result.push_back({(group.size() > 1 ? "total_" : "") + parameter.name, parameter.unit, sum,
                        is_size || parameter.role == element::Role::scale});
    }
  }
  return result;
}

std::vector<HeadlineValue> headlineValuesOf(const std::vector<element::ElementDescription>& entries) {
  std::map<std::string, std::vector<element::ElementDescription>> groups;
  for (const element::ElementDescription& entry : entries) {
    const Effect* const effect = toldBy(entry.type);
    groups[effect != nullptr ? effect->name : entry.type].push_back(entry);
  }
  std::vector<HeadlineValue> result;
  for (const auto& [name, group] : groups) {
    const Effect* const effect = toldBy(group.front().type);
    for (HeadlineValue value : effect != nullptr ? effect->headline(group) : movedOf(group)) {
      const bool taken = std::any_of(result.begin(), result.end(), [&](const auto& v) { return v.name == value.name; });
      value.name += taken ? "_of_" + name : "";
      result.push_back(std::move(value));
    }
  }
  return result;
}

std::map<std::string, double> headlineOf(const std::vector<element::ElementDescription>& entries) {
  std::map<std::string, double> result;
  for (const HeadlineValue& value : headlineValuesOf(entries)) {
    result[value.name] = value.value;
  }
  return result;
}

}  // namespace rubber_suspension::diagnosis
