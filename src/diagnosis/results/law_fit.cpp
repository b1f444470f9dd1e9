// Laws with few numbers as unknowns of a fit.
#include "diagnosis/results/law_fit.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "diagnosis/hypotheses/fitted_component.h"
#include "fit/parallel.h"
#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension::diagnosis::results {
namespace {

constexpr double kFarthest = 5.0;     // logarithm of a number over its start: a factor of 150
constexpr double kNumberStep = 1e-3;  // of such a logarithm, for difference quotients

const element::ParameterInfo& infoOf(const element::ElementDescription& entry, const std::string& key) {
  return *element::findParameter(element::findElementType(entry.type)->parameters, key);
}

double& numberAt(Entries& entries, const NumberPlace& place) {
  return entries[place.entry].values[place.key][place.index];
}

double startOf(const Entries& entries, const NumberPlace& place) {
  return entries[place.entry].list(place.key)[place.index];
}

// The bounds of a number, as the fit moves it.
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

// Numbers that move each by itself may leave what a law allows of them together.
bool canBeMade(const Entries& entries) {
  try {
    std::for_each(entries.begin(), entries.end(), element::makeElement);
    return true;
  } catch (const std::invalid_argument&) {
    return false;
  }
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

LawForces::LawForces(std::shared_ptr<const std::vector<log::Record>> records, const fit::ModelParameters& model,
                     const Law& law)
    : forces_(std::move(records), model), law_(law) {
  Eigen::Index place = 0;
  for (const MemberLaw& member : law.members) {
    for (const fit::BasisTerm& term : member.terms) {
      terms_.terms.push_back(term);
      places_.push_back(place++);
    }
    place += member.terms.empty() ? static_cast<Eigen::Index>(member.size()) : 0;
  }
}

fit::ParameterVector LawForces::ofTerms(const fit::ParameterVector& parameters) const {
  return {parameters.model, parameters.scales(places_)};
}

Entries LawForces::entriesAt(const Eigen::VectorXd& scales) const {
  Entries entries;
  const std::vector<Entries> of_members = law_.at(scales);
  for (std::size_t m = 0; m < of_members.size(); ++m) {
    if (law_.members[m].terms.empty()) {
      entries.insert(entries.end(), of_members[m].begin(), of_members[m].end());
    }
  }
  return entries;
}

std::optional<gap::Forces> LawForces::at(const fit::ParameterVector& parameters) const {
  const Entries entries = entriesAt(parameters.scales);
  return canBeMade(entries) ? forces_.at(terms_, ofTerms(parameters), entries) : std::nullopt;
}

fit::ForceColumn LawForces::byNumber(const fit::ParameterVector& parameters, const gap::Forces& base,
                                     const fit::BasisTerm& number, Eigen::Index t) const {
  const double step = parameters.scales[t] + kNumberStep > number.upper ? -kNumberStep : kNumberStep;
  fit::ParameterVector moved = parameters;
  moved.scales[t] += step;
  auto forces = at(moved);
  if (!forces) {
    forces = base;  // no law there: the number cannot move
  }
  for (std::size_t r = 0; r < base.size(); ++r) {
    (*forces)[r] = ((*forces)[r] - base[r]) / step;
  }
  return fit::columnOf(std::move(*forces));
}

std::vector<fit::ForceColumn> LawForces::columns(const fit::ParameterVector& parameters, const gap::Forces& base,
                                                 int threads) const {
  const auto of_model = static_cast<std::size_t>(parameters.model.size());
  std::vector<fit::ForceColumn> known =
      forces_.columns(terms_, ofTerms(parameters), {}, base, threads, entriesAt(parameters.scales));
  std::vector<fit::ForceColumn> columns(of_model + static_cast<std::size_t>(parameters.scales.size()));
  for (std::size_t i = 0; i < known.size(); ++i) {
    columns[i < of_model ? i : of_model + static_cast<std::size_t>(places_[i - of_model])] = std::move(known[i]);
  }
  const fit::Hypothesis all = law_.hypothesis();
  fit::parallelFor(all.terms.size(), threads, [&](std::size_t t) {
    if (!columns[of_model + t]) {
      columns[of_model + t] = byNumber(parameters, base, all.terms[t], static_cast<Eigen::Index>(t));
    }
  });
  return columns;
}

LawFitter::LawFitter(const fit::Fitter& fitter, const Law& law, int threads)
    : HypothesisFitter(fitter.model(), fitter.oneDeviation()),
      fitter_(fitter),
      forces_(fitter.sharedRecords(), fitter.model(), law),
      threads_(threads) {}

}  // namespace rubber_suspension::diagnosis::results
