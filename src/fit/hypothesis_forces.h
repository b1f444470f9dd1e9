// Forces of hypotheses over logs, simulated only where they do not follow from unit effects.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "fit/hypothesis.h"
#include "fit/model_parameters.h"
#include "fit/normal_equations.h"
#include "rubber_suspension/gap/prepared_record.h"

namespace rubber_suspension::fit {

/// Elements of a model with the effects of a hypothesis; nullopt if the model parameters have no solution, or a law
/// refuses its numbers.
std::optional<std::vector<element::ElementDescription>> elementsOf(const ModelParameters& model,
                                                                   const Hypothesis& hypothesis,
                                                                   const ParameterVector& parameters);

/// Force of elements over each of some motions [N].
using Motions = std::function<gap::Forces(const std::vector<element::ElementDescription>& elements)>;

/// The forces of hypotheses about one model on some logs, or over other motions. Thread-safe once constructed; the
/// model has to outlive it.
class HypothesisForces {
 public:
  /// Over motions that are no logs: there are no records, and unit effects of terms are those over the motions.
  HypothesisForces(Motions motions, const ModelParameters& model);
  HypothesisForces(std::shared_ptr<const std::vector<gap::PreparedRecord>> records, const ModelParameters& model);
  HypothesisForces(std::vector<gap::PreparedRecord> records, const ModelParameters& model)
      : HypothesisForces(std::make_shared<const std::vector<gap::PreparedRecord>>(std::move(records)), model) {}

  const std::vector<gap::PreparedRecord>& records() const { return *records_; }
  const ModelParameters& model() const { return model_; }

  /// True where the force of the model is the sum of those of its elements.
  bool isAdditive() const { return !of_model_.displaces && !of_model_.scales; }

  /// Force of each log [N]; nothing where elementsOf() has none.
  std::optional<gap::Forces> at(const Hypothesis& hypothesis, const ParameterVector& parameters) const;

  /// The force of each log beyond that with other scales of the same terms [N]. Throws std::invalid_argument
  /// where there is no model.
  gap::Forces moreThanWith(const Eigen::VectorXd& scales, const Hypothesis& hypothesis,
                           const ParameterVector& parameters) const;

  /// Derivatives by all model parameters, then by all terms; null for terms that are not `active`, which all are where
  /// the list is empty. `base`: the forces there.
  std::vector<ForceColumn> columns(const Hypothesis& hypothesis, const ParameterVector& parameters,
                                   const std::vector<bool>& active, const gap::Forces& base, int threads) const;

 private:
  /// Effects at work besides elements of the component that add up.
  struct Interaction {
    bool displaces = false;  ///< what acts on the displacement, or in a way that has to be simulated
    bool scales = false;     ///< force effects of the model itself
    bool softens = false;    ///< softening terms
    bool on_rig = false;     ///< elements of the model that sit on the rig
  };
  /// Where derivatives are taken.
  struct Place {
    const Hypothesis& hypothesis;
    const ParameterVector& parameters;
    const gap::Forces& base;
    Interaction interaction;
  };
  static void add(const std::vector<element::ElementDescription>& elements, Interaction& interaction);
  Interaction interactionOf(const Hypothesis& hypothesis, const ParameterVector& parameters) const;

  /// True where the effect of a term on the force follows from its unit effect, without simulation.
  static bool isKnown(const BasisTerm& term, const Interaction& interaction);

  /// Derivative by the scale of a basis term; about, where it is at nothing and others displace the component.
  ForceColumn termColumn(const Place& place, std::size_t term) const;
  /// Quotient where one of the parameters is moved.
  ForceColumn moved(const Place& place, Eigen::VectorXd ParameterVector::* part, Eigen::Index parameter,
                    double step) const;
  static ForceColumn knownColumn(const Place& place, std::size_t term, ForceColumn unit_effect);

  std::vector<element::ElementDescription> pathOf(const Place& place) const;
  std::vector<ForceColumn> columnsBehind(std::vector<element::ElementDescription> path, const Place& place,
                                         const std::vector<bool>& active, int threads) const;

  std::shared_ptr<const std::vector<gap::PreparedRecord>> records_;
  Motions motions_;
  const ModelParameters& model_;
  Interaction of_model_;
};

}  // namespace rubber_suspension::fit
