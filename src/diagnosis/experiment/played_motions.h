// Forces over motions that a component goes through after the logs of a diagnosis.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "diagnosis/experiment/menu.h"
#include "rubber_suspension/element/parameter.h"
#include "rubber_suspension/gap/prepared_record.h"

namespace rubber_suspension::diagnosis::experiment {

/// Motions on the component of the logs: relaxed and cooled, but softened by where it was. Each motion is played on its
/// own, right after the logs.
class PlayedMotions {
 public:
  explicit PlayedMotions(const std::vector<gap::PreparedRecord>& logs);

  /// Replace the motions. The menu has to outlive this.
  void play(std::vector<const Experiment*> motions) { motions_ = std::move(motions); }

  const std::vector<const Experiment*>& motions() const { return motions_; }

  /// Force of a component over each motion [N], at one in `stride` of its samples.
  std::vector<Eigen::VectorXd> forces(const std::vector<element::ElementDescription>& elements) const;

 private:
  // Where the logs turned round, and how long after the turn before: softening remembers displacement and path.
  struct Turn {
    double after;  // [s]; 0: a log begins
    double displacement;
  };

  std::vector<Turn> turns_;
  std::vector<const Experiment*> motions_;
};

}  // namespace rubber_suspension::diagnosis::experiment
