// Fits laws all of whose numbers are free.
#include "diagnosis/results/law_fit.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "diagnosis/hypotheses/fitted_component.h"
#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension::diagnosis::results {
namespace {

constexpr double kFarthest = 5.0;  // largest |ln(number / start)|: a factor of 150

const element::ParameterInfo& infoOf(const element::ElementDescription& entry, const std::string& key) {
  return *element::findParameter(element::findElementType(entry.type)->parameters, key);
}

double& numberAt(Entries& entries, const NumberPlace& place) {
  return entries[place.entry].values[place.key][place.index];
}

double startOf(const Entries& entries, const NumberPlace& place) {
  return entries[place.entry].list(place.key)[place.index];
}

// Returns a number of a law as a parameter of the fit, with its bounds.
fit::BasisTerm unknownOf(const MemberLaw& law, const NumberPlace& place) {
  const element::ParameterInfo& info = infoOf(law.start[place.entry], place.key);
  const element::Range& range = info.range;
  const double value = startOf(law.start, place);
  const double least = value > 0.0 ? range.lower / value : range.upper / value;
  const double most = value > 0.0 ? range.upper / value : range.lower / value;
  fit::BasisTerm unknown;
  unknown.lower = least > 0.0 ? std::max(-kFarthest, std::log(least)) : -kFarthest;
  unknown.upper = std::min(kFarthest, std::log(most));
  if (info.unit == "s") {
    unknown.upper = std::min(unknown.upper, std::log(std::max(1.0, law.longest_time / value)));
  }
  return unknown;
}

}  // namespace

std::vector<NumberPlace> numbersOf(const Entries& entries) {
  std::vector<NumberPlace> places;
  for (std::size_t e = 0; e < entries.size(); ++e) {
    for (const auto& [key, values] : entries[e].values) {
      element::ParameterInfo info = infoOf(entries[e], key);
      info.is_list = false;
      for (std::size_t i = 0; i < values.size(); ++i) {
        if (element::isFree(info, {values[i]})) {
          places.push_back({e, key, i});
        }
      }
    }
  }
  return places;
}

Entries MemberLaw::at(const Eigen::VectorXd& scales) const {
  if (!terms.empty()) {
    hypotheses::FittedHypothesis alone;
    alone.hypothesis.terms = terms;
    alone.fit.parameters.scales = scales;
    return hypotheses::entriesOf(alone);
  }
  Entries entries = start;
  Eigen::Index next = 0;
  for (const NumberPlace& place : numbersOf(start)) {
    numberAt(entries, place) *= std::exp(scales[next++]);
  }
  return entries;
}

fit::Hypothesis Law::hypothesis() const {
  fit::Hypothesis result = about;
  result.law = [law = *this](const Eigen::VectorXd& scales) {
    Entries entries;
    const std::vector<Entries> of_members = law.at(scales);
    for (std::size_t m = 0; m < of_members.size(); ++m) {
      if (law.members[m].terms.empty()) {
        entries.insert(entries.end(), of_members[m].begin(), of_members[m].end());
      }
    }
    return entries;
  };
  for (const MemberLaw& law : members) {
    result.members.push_back(law.member);
    result.terms.insert(result.terms.end(), law.terms.begin(), law.terms.end());
    for (const NumberPlace& place : law.terms.empty() ? numbersOf(law.start) : std::vector<NumberPlace>()) {
      result.terms.push_back(unknownOf(law, place));
    }
  }
  return result;
}

std::vector<Entries> Law::at(const Eigen::VectorXd& scales) const {
  std::vector<Entries> result;
  Eigen::Index first = 0;
  for (const MemberLaw& law : members) {
    const auto size = static_cast<Eigen::Index>(law.size());
    result.push_back(law.at(scales.segment(first, size)));
    first += size;
  }
  return result;
}

}  // namespace rubber_suspension::diagnosis::results
