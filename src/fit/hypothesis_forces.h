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

/// Returns the elements of a model with the effects of a hypothesis; nullopt if the model parameters have no solution
/// or a law rejects its parameters.
std::optional<std::vector<element::ElementDescription>> elementsOf(const ModelParameters& model,
                                                                   const Hypothesis& hypothesis,
                                                                   const ParameterVector& parameters);

/// Returns the force of elements over each of several motions [N].
using Motions = std::function<gap::Forces(const std::vector<element::ElementDescription>& elements)>;

/// Simulates hypotheses about one model over logs or over other motions. Thread-safe once constructed; the model has to
/// outlive it.
class HypothesisForces {
 public:
  /// For motions that are not logs, without records(). Terms have to contain their unit effects for these motions.
  HypothesisForces(Motions motions, const ModelParameters& model);
  HypothesisForces(std::shared_ptr<const std::vector<gap::PreparedRecord>> records, const ModelParameters& model);
  HypothesisForces(std::vector<gap::PreparedRecord> records, const ModelParameters& model)
      : HypothesisForces(std::make_shared<const std::vector<gap::PreparedRecord>>(std::move(records)), model) {}

  const std::vector<gap::PreparedRecord>& records() const { return *records_; }
  const ModelParameters& model() const { return model_; }

  /// Returns true if the force of the model is the sum of the forces of its elements.
  bool isAdditive() const { return !of_model_.displaces && !of_model_.scales; }

  /// Returns the force of each log [N], or nullopt if no elements have these parameters (elementsOf()).
  std::optional<gap::Forces> at(const Hypothesis& hypothesis, const ParameterVector& parameters) const;

  /// Returns the force of each log minus its force with other scales of the same terms [N]. Throws
  /// std::invalid_argument if the model has no solution.
  gap::Forces moreThanWith(const Eigen::VectorXd& scales, const Hypothesis& hypothesis,
                           const ParameterVector& parameters) const;

  /// Returns the derivatives with respect to all model parameters, then to all terms. They are null for terms that are
  /// not `active` (empty: all are active). `base`: the forces at the parameters.
  std::vector<ForceColumn> columns(const Hypothesis& hypothesis, const ParameterVector& parameters,
                                   const std::vector<bool>& active, const gap::Forces& base, int threads) const;

 private:
  /// Effects that make the force differ from the sum of the forces of the elements.
  struct Interaction {
    bool displaces = false;  ///< elements that change the displacement, and terms that have to be simulated
    bool scales = false;     ///< force effects of the model itself
    bool softens = false;    ///< softening terms
    bool on_rig = false;     ///< elements of the model that are on the rig
  };
  /// A point where derivatives are computed.
  struct Place {
    const Hypothesis& hypothesis;
    const ParameterVector& parameters;
    const gap::Forces& base;
    Interaction interaction;
  };
  static void add(const std::vector<element::ElementDescription>& elements, Interaction& interaction);
  Interaction interactionOf(const Hypothesis& hypothesis, const ParameterVector& parameters) const;

  /// Returns true if the effect of a term on the force follows from its unit effect, without simulation.
  static bool isKnown(const BasisTerm& term, const Interaction& interaction);

  /// Returns the derivative with respect to a term's scale; approximate at scale 0 if others displace the component.
  ForceColumn termColumn(const Place& place, std::size_t term) const;
  /// Returns the difference quotient with respect to one of the parameters.
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
