// Forces of hypotheses and their derivatives.
#include "fit/hypothesis_forces.h"

#include <stdexcept>

#include "fit/parallel.h"
#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension::fit {
namespace {

constexpr double kModelStep = 1e-4;  // of a logarithm, for difference quotients
constexpr double kTermStep = 0.02;   // of the typical scale

double scaleOf(const ParameterVector& parameters, std::size_t term) {
  return parameters.scales[static_cast<Eigen::Index>(term)];
}

// Adds the forces of the terms that sit on the rig, or of those that do not, to that of a log.
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

ForceColumn quotient(gap::Forces moved, const gap::Forces& base, double step) {
  for (std::size_t r = 0; r < base.size(); ++r) {
    moved[r] = (moved[r] - base[r]) / step;
  }
  return columnOf(std::move(moved));
}

}  // namespace

std::optional<std::vector<element::ElementDescription>> elementsOf(const ModelParameters& model,
                                                                   const Hypothesis& hypothesis,
                                                                   const ParameterVector& parameters) {
  auto result = model.elements(parameters.model);
  for (std::size_t t = 0; result && t < hypothesis.terms.size(); ++t) {
    if (scaleOf(parameters, t) != 0.0) {
      result->push_back(hypothesis.terms[t].at(scaleOf(parameters, t)));
    }
  }
  return result;
}

HypothesisForces::HypothesisForces(std::shared_ptr<const std::vector<log::Record>> records,
                                   const ModelParameters& model)
    : records_(std::move(records)), model_(model) {
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

HypothesisForces::Interaction HypothesisForces::interactionOf(
    const Hypothesis& hypothesis, const ParameterVector& parameters,
    const std::vector<element::ElementDescription>& further) const {
  Interaction interaction = of_model_;
  add(further, interaction);
  for (std::size_t t = 0; t < hypothesis.terms.size(); ++t) {
    const BasisTerm& term = hypothesis.terms[t];
    const bool at_work = scaleOf(parameters, t) != 0.0;
    interaction.softens = interaction.softens || (at_work && term.softening);
    interaction.displaces = interaction.displaces || (at_work && !term.softening && !term.additive);
  }
  return interaction;
}

bool HypothesisForces::isKnown(const BasisTerm& term, const Interaction& interaction) {
  if (!term.unit_effect || term.on_rig) {
    return term.unit_effect != nullptr;
  }
  // A factor on the simulated force would scale what sits on the rig, too.
  const bool factors_known = !interaction.on_rig || !(term.softening || interaction.softens);
  return !interaction.displaces && factors_known && (term.softening || !interaction.scales);
}

std::optional<gap::Forces> HypothesisForces::at(const Hypothesis& hypothesis, const ParameterVector& parameters,
                                                const std::vector<element::ElementDescription>& further) const {
  // Terms known by their unit effect are added or multiplied; the others have to be simulated.
  const Interaction interaction = interactionOf(hypothesis, parameters, further);
  ParameterVector rest = parameters;
  ParameterVector known = parameters;
  for (std::size_t t = 0; t < hypothesis.terms.size(); ++t) {
    (isKnown(hypothesis.terms[t], interaction) ? rest : known).scales[static_cast<Eigen::Index>(t)] = 0.0;
  }
  auto elements = elementsOf(model_, hypothesis, rest);
  if (!elements) {
    return std::nullopt;
  }
  elements->insert(elements->end(), further.begin(), further.end());
  auto result = gap::simulate(*elements, records());
  for (std::size_t r = 0; r < records().size(); ++r) {
    addForces(hypothesis, known, false, r, result[r]);
    soften(hypothesis, known, r, result[r]);
    addForces(hypothesis, known, true, r, result[r]);
  }
  return result;
}

gap::Forces HypothesisForces::moreThanWith(const Eigen::VectorXd& scales, const Hypothesis& hypothesis,
                                           const ParameterVector& parameters) const {
  const Interaction interaction = interactionOf(hypothesis, parameters, {});
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
      throw std::invalid_argument("the model has no solution at the parameters to be compared");
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

ForceColumn HypothesisForces::modelColumn(const Place& place, Eigen::Index parameter) const {
  ParameterVector moved = place.parameters;
  double step = kModelStep;
  moved.model[parameter] += step;
  auto column = at(place.hypothesis, moved, place.further);
  if (!column) {
    step = -kModelStep;
    moved.model[parameter] = place.parameters.model[parameter] + step;
    column = at(place.hypothesis, moved, place.further);
  }
  // Without a model on either side the parameter cannot move.
  return quotient(std::move(column).value_or(place.base), place.base, step);
}

ForceColumn HypothesisForces::termColumn(const Place& place, std::size_t term) const {
  const BasisTerm& basis_term = place.hypothesis.terms[term];
  const double scale = scaleOf(place.parameters, term);
  if (isKnown(basis_term, place.interaction) || (basis_term.unit_effect && scale == 0.0)) {
    return knownColumn(place, term);
  }
  const double direction = scale + basis_term.typical > basis_term.upper ? -1.0 : 1.0;
  const double step = (scale == 0.0 ? 1.0 : kTermStep) * basis_term.typical * direction;
  ParameterVector moved = place.parameters;
  moved.scales[static_cast<Eigen::Index>(term)] += step;
  return quotient(*at(place.hypothesis, moved, place.further), place.base, step);
}

std::vector<ForceColumn> HypothesisForces::columns(const Hypothesis& hypothesis, const ParameterVector& parameters,
                                                   const std::vector<bool>& active, const gap::Forces& base,
                                                   int threads,
                                                   const std::vector<element::ElementDescription>& further) const {
  const Place place{hypothesis, parameters, further, base, interactionOf(hypothesis, parameters, further)};
  const auto size = static_cast<std::size_t>(model().size());
  std::vector<ForceColumn> columns(size + hypothesis.terms.size());
  parallelFor(columns.size(), threads, [&](std::size_t j) {
    if (j < size) {
      columns[j] = modelColumn(place, static_cast<Eigen::Index>(j));
    } else if (active.empty() || active[j - size]) {
      columns[j] = termColumn(place, j - size);
    }
  });
  return columns;
}

// Where a term's effect is known the force is linear in its scale. Where others displace the component, that is about
// so, and enough to tell whether a term at nothing is worth a step.
ForceColumn HypothesisForces::knownColumn(const Place& place, std::size_t term) {
  const BasisTerm& basis_term = place.hypothesis.terms[term];
  if (basis_term.on_rig || !(basis_term.softening || place.interaction.softens)) {
    return basis_term.unit_effect;
  }
  gap::Forces column = *basis_term.unit_effect;
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
  return columnOf(std::move(column));
}

}  // namespace rubber_suspension::fit
