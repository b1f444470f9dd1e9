// Forces over motions that a component performs after the logs of a diagnosis.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "diagnosis/experiment/menu.h"
#include "rubber_suspension/element/parameter.h"
#include "rubber_suspension/gap/prepared_record.h"

namespace rubber_suspension::diagnosis::experiment {

/// Motions of the component of the logs, which is relaxed and cooled, but softened by the logs. Each motion is played
/// directly after the logs.
class PlayedMotions {
 public:
  explicit PlayedMotions(const std::vector<gap::PreparedRecord>& logs);

  /// Replaces the motions. The menu has to outlive this object.
  void play(std::vector<const Experiment*> motions) { motions_ = std::move(motions); }

  const std::vector<const Experiment*>& motions() const { return motions_; }

  /// Returns the force of a component over each motion [N], at every stride-th sample.
  std::vector<Eigen::VectorXd> forces(const std::vector<element::ElementDescription>& elements) const;

 private:
  // A turning point of the logs, and the time since the one before: softening depends on displacement and path.
  struct Turn {
    double after;  // [s]; 0: a log begins
    double displacement;
  };

  std::vector<Turn> turns_;
  std::vector<const Experiment*> motions_;
};

}  // namespace rubber_suspension::diagnosis::experiment
