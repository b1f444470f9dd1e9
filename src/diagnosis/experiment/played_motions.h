// Simulates motions that a component performs after the logs of a diagnosis.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "diagnosis/experiment/menu.h"
#include "rubber_suspension/element/parameter.h"
#include "rubber_suspension/gap/prepared_record.h"

namespace rubber_suspension::diagnosis::experiment {

/// Motions that a component performs directly after the logs: it is relaxed and cooled, but softened by the logs.
class PlayedMotions {
 public:
  explicit PlayedMotions(const std::vector<gap::PreparedRecord>& logs);

  /// Replaces the motions. The menu has to outlive this object.
  void play(std::vector<const Experiment*> motions) { motions_ = std::move(motions); }

  const std::vector<const Experiment*>& motions() const { return motions_; }

  /// Returns the force of a component with these elements on each motion [N], at every stride-th sample.
  std::vector<Eigen::VectorXd> forces(const std::vector<element::ElementDescription>& elements) const;

 private:
  // A turning point of the logs, and the time since the previous one. Softening depends on the turning points alone.
  struct Turn {
    double after;  // time since the previous turning point [s]; 0 for the first sample of a log
    double displacement;
  };

  std::vector<Turn> turns_;
  std::vector<const Experiment*> motions_;
};

}  // namespace rubber_suspension::diagnosis::experiment
