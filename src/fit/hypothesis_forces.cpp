// Forces of hypotheses and their derivatives.
#include "fit/hypothesis_forces.h"

#include <algorithm>
#include <stdexcept>
#include <variant>

#include "fit/parallel.h"
#include "numerics/difference_quotient.h"
#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension::fit {
namespace {

using numerics::kLogarithmStep;
using numerics::kScaleStep;

double scaleOf(const ParameterVector& parameters, std::size_t term) {
  return parameters.scales[static_cast<Eigen::Index>(term)];
}

// Adds the forces of all terms on the rig (`on_rig`), or of all other terms, to the force of a log.
void addForces(const Hypothesis& hypothesis, const ParameterVector& parameters, bool on_rig, std::size_t record,
               Eigen::VectorXd& force) {
  for (std::size_t t = 0; t < hypothesis.terms.size(); ++t) {
    const BasisTerm& term = hypothesis.terms[t];
    const double scale = scaleOf(parameters, t);
    if (scale != 0.0 && !term.softening && term.on_rig == on_rig) {
      force += scale * (*term.unit_effect)[record];
    }
  }
}

// Multiplies the force of a log by the factors of the softening terms.
void soften(const Hypothesis& hypothesis, const ParameterVector& parameters, std::size_t record,
            Eigen::VectorXd& force) {
  for (std::size_t t = 0; t < hypothesis.terms.size(); ++t) {
    const BasisTerm& term = hypothesis.terms[t];
    const double scale = scaleOf(parameters, t);
    if (scale != 0.0 && term.softening) {
      force.array() *= 1.0 - scale * (*term.unit_effect)[record].array();
    }
  }
}

// Returns the entries of the law of a hypothesis; nullopt if the law rejects the combination of fitted numbers.
std::optional<std::vector<element::ElementDescription>> lawOf(const Hypothesis& hypothesis,
                                                              const ParameterVector& parameters) {
  std::vector<element::ElementDescription> entries;
  if (hypothesis.law) {
    entries = hypothesis.law(parameters.scales);
  }
  try {
    std::for_each(entries.begin(), entries.end(), element::makeElement);
    return entries;
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

// Returns records with the displacement behind the elements of `path`, computed as the force of a spring of 1 N/m.
std::vector<gap::PreparedRecord> displacedBy(std::vector<element::ElementDescription> path,
                                             const std::vector<gap::PreparedRecord>& records) {
  path.push_back({"spring", {{"stiffness", {1.0}}}});
  gap::Forces displaced = gap::simulate(path, records);
  std::vector<gap::PreparedRecord> behind(records.size());
  for (std::size_t r = 0; r < behind.size(); ++r) {
    behind[r].dt = records[r].dt;
    behind[r].displacement = std::move(displaced[r]);
    behind[r].temperature = records[r].temperature;
    behind[r].across = records[r].across;
  }
  return behind;
}

}  // namespace

std::optional<std::vector<element::ElementDescription>> elementsOf(const ModelParameters& model,
                                                                   const Hypothesis& hypothesis,
                                                                   const ParameterVector& parameters) {
  auto result = model.elements(parameters.model);
  const auto law = lawOf(hypothesis, parameters);
  if (!result || !law) {
    return std::nullopt;
  }
  for (std::size_t t = 0; t < hypothesis.terms.size(); ++t) {
    if (scaleOf(parameters, t) != 0.0 && hypothesis.terms[t].at) {
      result->push_back(hypothesis.terms[t].at(scaleOf(parameters, t)));
    }
  }
  result->insert(result->end(), law->begin(), law->end());
  return result;
}

HypothesisForces::HypothesisForces(std::shared_ptr<const std::vector<gap::PreparedRecord>> records,
                                   const ModelParameters& model)
    : HypothesisForces([records](const auto& elements) { return gap::simulate(elements, *records); }, model) {
  records_ = std::move(records);
}

HypothesisForces::HypothesisForces(Motions motions, const ModelParameters& model)
    : motions_(std::move(motions)), model_(model) {
  if (const auto elements = model.elements(Eigen::VectorXd::Zero(model.size()))) {
    add(*elements, of_model_);
  }
}

void HypothesisForces::add(const std::vector<element::ElementDescription>& elements, Interaction& interaction) {
  for (const element::ElementDescription& description : elements) {
    const element::ElementPointer element = element::makeElement(description);
    if (const element::ParallelElement* parallel = element::parallelLaw(element)) {
      interaction.on_rig = interaction.on_rig || parallel->onRig();
    } else if (std::holds_alternative<std::shared_ptr<const element::ForceEffect>>(element)) {
      interaction.scales = true;
    } else {
      interaction.displaces = true;
    }
  }
}

HypothesisForces::Interaction HypothesisForces::interactionOf(const Hypothesis& hypothesis,
                                                              const ParameterVector& parameters) const {
  Interaction interaction = of_model_;
  if (const auto law = lawOf(hypothesis, parameters)) {
    add(*law, interaction);
  }
  for (std::size_t t = 0; t < hypothesis.terms.size(); ++t) {
    const BasisTerm& term = hypothesis.terms[t];
    const bool at_work = scaleOf(parameters, t) != 0.0;
    interaction.softens = interaction.softens || (at_work && term.softening);
    interaction.displaces = interaction.displaces || (at_work && !term.hasUnitEffect());
  }
  return interaction;
}

bool HypothesisForces::isKnown(const BasisTerm& term, const Interaction& interaction) {
  if (!term.unit_effect || term.on_rig) {
    return term.unit_effect != nullptr;
  }
  // A factor on the simulated force would also scale the forces of the rig.
  const bool factors_known = !interaction.on_rig || !(term.softening || interaction.softens);
  return !interaction.displaces && factors_known && (term.softening || !interaction.scales);
}

std::optional<gap::Forces> HypothesisForces::at(const Hypothesis& hypothesis, const ParameterVector& parameters) const {
  // Terms with a known unit effect are added or multiplied; all other terms are simulated.
  const Interaction interaction = interactionOf(hypothesis, parameters);
  ParameterVector rest = parameters;
  ParameterVector known = parameters;
  for (std::size_t t = 0; t < hypothesis.terms.size(); ++t) {
    (isKnown(hypothesis.terms[t], interaction) ? rest : known).scales[static_cast<Eigen::Index>(t)] = 0.0;
  }
  const auto elements = elementsOf(model_, hypothesis, rest);
  if (!elements) {
    return std::nullopt;
  }
  gap::Forces result = motions_(*elements);
  for (std::size_t r = 0; r < result.size(); ++r) {
    addForces(hypothesis, known, false, r, result[r]);
    soften(hypothesis, known, r, result[r]);
    addForces(hypothesis, known, true, r, result[r]);
  }
  return result;
}

gap::Forces HypothesisForces::moreThanWith(const Eigen::VectorXd& scales, const Hypothesis& hypothesis,
                                           const ParameterVector& parameters) const {
  const Interaction interaction = interactionOf(hypothesis, parameters);
  ParameterVector added = parameters;
  added.scales -= scales;
  bool linear = !interaction.softens;
  for (std::size_t t = 0; t < hypothesis.terms.size(); ++t) {
    const BasisTerm& term = hypothesis.terms[t];
    linear = linear && (scaleOf(added, t) == 0.0 || (!term.softening && isKnown(term, interaction)));
  }
  if (!linear) {
    auto forces = at(hypothesis, parameters);
    const auto others = at(hypothesis, {parameters.model, scales});
    if (!forces || !others) {
      throw std::invalid_argument("the model has no solution at the parameters that are compared");
    }
    for (std::size_t r = 0; r < forces->size(); ++r) {
      (*forces)[r] -= (*others)[r];
    }
    return *forces;
  }
  gap::Forces forces;
  for (std::size_t r = 0; r < records().size(); ++r) {
    forces.emplace_back(Eigen::VectorXd::Zero(records()[r].size()));
    addForces(hypothesis, added, false, r, forces.back());
    addForces(hypothesis, added, true, r, forces.back());
  }
  return forces;
}

ForceColumn HypothesisForces::moved(const Place& place, Eigen::VectorXd ParameterVector::* part, Eigen::Index parameter,
                                    double step) const {
  return columnOf(numerics::quotient(place.base, step, [&](double by) {
    ParameterVector there = place.parameters;
    (there.*part)[parameter] += by;
    return at(place.hypothesis, there);
  }));
}

// Returns the entries of the nonzero terms that act on the displacement if the effects of all other terms behind them
// are known. Returns an empty vector otherwise, and for excerpts, whose lead-in has its own time step.
std::vector<element::ElementDescription> HypothesisForces::pathOf(const Place& place) const {
  if (!records_ || place.hypothesis.law || !place.interaction.displaces || of_model_.displaces || of_model_.scales ||
      of_model_.on_rig || std::any_of(records().begin(), records().end(), [](const log::Record& record) {
        return !record.lead_in.displacement.empty();
      })) {
    return {};
  }
  std::vector<element::ElementDescription> path;
  for (std::size_t t = 0; t < place.hypothesis.terms.size(); ++t) {
    const BasisTerm& term = place.hypothesis.terms[t];
    const double scale = scaleOf(place.parameters, t);
    if (scale == 0.0) {
      continue;
    }
    if (term.on_rig && !term.unit_effect) {
      return {};
    }
    if (!term.hasUnitEffect()) {
      path.push_back(term.at(scale));
      if (!std::holds_alternative<std::shared_ptr<const element::DisplacementEffect>>(
              element::makeElement(path.back()))) {
        return {};
      }
    }
  }
  return path;
}

// Behind a delay or a free play, other terms follow again from unit effects, computed for the changed displacement.
std::vector<ForceColumn> HypothesisForces::columnsBehind(std::vector<element::ElementDescription> path,
                                                         const Place& place, const std::vector<bool>& active,
                                                         int threads) const {
  const std::vector<gap::PreparedRecord> behind = displacedBy(std::move(path), records());
  Hypothesis hypothesis = place.hypothesis;
  ParameterVector parameters = place.parameters;
  const auto atWork = [&](std::size_t t) { return scaleOf(place.parameters, t) != 0.0; };
  const auto isKnownBehind = [&](std::size_t t) {
    const BasisTerm& term = hypothesis.terms[t];
    return term.hasUnitEffect() && !term.on_rig;
  };
  parallelFor(hypothesis.terms.size(), threads, [&](std::size_t t) {
    if (atWork(t) && isKnownBehind(t)) {
      hypothesis.terms[t].unit_effect = columnOf(effectOfEntry(hypothesis.terms[t], behind));
    }
  });
  for (std::size_t t = 0; t < hypothesis.terms.size(); ++t) {
    const BasisTerm& term = hypothesis.terms[t];
    parameters.scales[static_cast<Eigen::Index>(t)] *= term.hasUnitEffect() ? 1.0 : 0.0;
  }
  const HypothesisForces forces(behind, model_);
  const auto base = forces.at(hypothesis, parameters);
  if (!base) {
    throw std::invalid_argument("the model has no solution at the parameters where derivatives are computed");
  }
  const Place there{hypothesis, parameters, *base, forces.interactionOf(hypothesis, parameters)};
  const auto size = static_cast<std::size_t>(model().size());
  std::vector<ForceColumn> columns(size + hypothesis.terms.size());
  parallelFor(size, threads, [&](std::size_t j) {
    columns[j] = forces.moved(there, &ParameterVector::model, static_cast<Eigen::Index>(j), kLogarithmStep);
  });
  parallelFor(hypothesis.terms.size(), threads, [&](std::size_t t) {
    BasisTerm& term = hypothesis.terms[t];
    if (!active.empty() && !active[t]) {
      return;
    }
    if (!isKnownBehind(t)) {
      columns[size + t] = termColumn(place, t);
    } else {
      // The unit effect of an additive term is not needed for other terms and would only use memory.
      ForceColumn effect = !atWork(t)       ? columnOf(effectOfEntry(term, behind))
                           : term.softening ? term.unit_effect
                                            : std::move(term.unit_effect);
      columns[size + t] = knownColumn(there, t, std::move(effect));
    }
  });
  return columns;
}

ForceColumn HypothesisForces::termColumn(const Place& place, std::size_t term) const {
  const BasisTerm& basis_term = place.hypothesis.terms[term];
  const double scale = scaleOf(place.parameters, term);
  if (isKnown(basis_term, place.interaction) || (basis_term.unit_effect && scale == 0.0)) {
    return knownColumn(place, term, basis_term.unit_effect);
  }
  const double reach = basis_term.at ? basis_term.typical : kLogarithmStep;
  const double step = basis_term.at && scale != 0.0 ? kScaleStep * reach : reach;
  return moved(place, &ParameterVector::scales, static_cast<Eigen::Index>(term),
               scale + reach > basis_term.upper ? -step : step);
}

std::vector<ForceColumn> HypothesisForces::columns(const Hypothesis& hypothesis, const ParameterVector& parameters,
                                                   const std::vector<bool>& active, const gap::Forces& base,
                                                   int threads) const {
  const Place place{hypothesis, parameters, base, interactionOf(hypothesis, parameters)};
  if (std::vector<element::ElementDescription> path = pathOf(place); !path.empty()) {
    return columnsBehind(std::move(path), place, active, threads);
  }
  const auto size = static_cast<std::size_t>(model().size());
  std::vector<ForceColumn> columns(size + hypothesis.terms.size());
  parallelFor(columns.size(), threads, [&](std::size_t j) {
    if (j < size) {
      columns[j] = moved(place, &ParameterVector::model, static_cast<Eigen::Index>(j), kLogarithmStep);
    } else if (active.empty() || active[j - size]) {
      columns[j] = termColumn(place, j - size);
    }
  });
  return columns;
}

// The force is linear in the scale of a term with a known unit effect. If other terms displace the component, this is
// an approximation, which suffices to decide whether a term of scale 0 is worth a step.
ForceColumn HypothesisForces::knownColumn(const Place& place, std::size_t term, ForceColumn unit_effect) {
  const BasisTerm& basis_term = place.hypothesis.terms[term];
  if (basis_term.on_rig || !(basis_term.softening || place.interaction.softens)) {
    return unit_effect;
  }
  gap::Forces column;
  for (std::size_t r = 0; r < place.base.size(); ++r) {
    column.emplace_back((*unit_effect)[r]);
  }
  unit_effect.reset();
  ParameterVector others = place.parameters;
  others.scales = -others.scales;
  for (std::size_t r = 0; r < place.base.size(); ++r) {
    if (basis_term.softening) {
      Eigen::VectorXd without_rig = place.base[r];
      addForces(place.hypothesis, others, true, r, without_rig);
      column[r].array() *= -without_rig.array() / (1.0 - scaleOf(place.parameters, term) * column[r].array());
    } else {
      soften(place.hypothesis, place.parameters, r, column[r]);
    }
  }
  return columnOf(column);
}

}  // namespace rubber_suspension::fit
