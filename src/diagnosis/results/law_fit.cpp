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
constexpr double kModelStep = 1e-4;
constexpr double kTermStep = 0.02;  // of the typical scale

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

fit::ForceColumn LawForces::difference(const fit::ParameterVector& parameters, const gap::Forces& base,
                                       Eigen::Index unknown, double step) const {
  const Eigen::Index of_model = parameters.model.size();
  fit::ParameterVector moved = parameters;
  (unknown < of_model ? moved.model[unknown] : moved.scales[unknown - of_model]) += step;
  auto forces = at(moved);
  if (!forces) {
    forces = base;  // no model there: the parameter cannot move
  }
  for (std::size_t r = 0; r < base.size(); ++r) {
    (*forces)[r] = ((*forces)[r] - base[r]) / step;
  }
  return fit::columnOf(std::move(*forces));
}

double LawForces::stepOf(const fit::ParameterVector& parameters, const fit::BasisTerm& unknown, Eigen::Index t) const {
  double step = kNumberStep;
  if (std::find(places_.begin(), places_.end(), t) != places_.end()) {
    step = (parameters.scales[t] == 0.0 ? 1.0 : kTermStep) * unknown.typical;
  }
  return parameters.scales[t] + step > unknown.upper ? -step : step;
}

std::vector<fit::ForceColumn> LawForces::columns(const fit::ParameterVector& parameters, const gap::Forces& base,
                                                 int threads) const {
  const Eigen::Index of_model = parameters.model.size();
  const fit::Hypothesis all = law_.hypothesis();
  std::vector<fit::ForceColumn> columns(static_cast<std::size_t>(of_model + parameters.scales.size()));
  fit::parallelFor(columns.size(), threads, [&](std::size_t j) {
    const auto unknown = static_cast<Eigen::Index>(j);
    const Eigen::Index t = unknown - of_model;
    const double step = t < 0 ? kModelStep : stepOf(parameters, all.terms[static_cast<std::size_t>(t)], t);
    columns[j] = difference(parameters, base, unknown, step);
  });
  return columns;
}

LawFitter::LawFitter(const fit::Fitter& fitter, const Law& law, int threads)
    : HypothesisFitter(fitter.model(), fitter.oneDeviation()),
      fitter_(fitter),
      forces_(fitter.sharedRecords(), fitter.model(), law),
      threads_(threads) {}

}  // namespace rubber_suspension::diagnosis::results
