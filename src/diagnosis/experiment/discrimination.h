// Differences of explanations of the same logs over a motion, after the wrong ones have been fitted to it.
#pragma once

#include <limits>
#include <vector>

#include "diagnosis/experiment/explanation.h"
#include "diagnosis/experiment/played_motions.h"
#include "fit/fitter.h"
#include "fit/hypothesis_forces.h"

namespace rubber_suspension::diagnosis::experiment {

/// A motion and what it is expected to decide.
struct Discrimination {
  const Experiment* experiment = nullptr;
  double difference = 0.0;  ///< were the first right: RMS force by which the nearest other would still be off [N]
  std::size_t nearest = 0;  ///< that explanation, none that can do all that the first can; 0: there is none
  double open = std::numeric_limits<double>::infinity();  ///< names, expected once the motion is among the logs [bit]
  double probability = 0.0;                               ///< that the right explanation stands alone then
};

/// The motion that most lowers the expected entropy of the names (Lindley, Ann. Math. Stat. 27, 1956): of each effect,
/// whether it is at work. Each explanation is taken for right with its probability; each other one gives way by a
/// Gauss-Newton step on the normal equations of the logs and of the motion together. What it is still off by counts, on
/// the motion and on the logs, as the judgement does, and so does a member that the step leaves next to no force: of
/// sets that hold one another the larger one can follow the smaller one, but not keep its name. The zero of the force
/// is free in a new log.
class Discriminator {
 public:
  /// All have to outlive it. `force_limit`: motions that any explanation says need more are out [N].
  Discriminator(const fit::Fitter& fitter, const hypotheses::Search& search,
                const std::vector<Explanation>& explanations, double force_limit, int threads);
  Discriminator(const Discriminator&) = delete;
  Discriminator& operator=(const Discriminator&) = delete;

  void setForceLimit(double force_limit) { force_limit_ = force_limit; }

  /// Returns the motion of a menu with the least expected entropy; without an experiment if none can be played.
  Discrimination best(const std::vector<Experiment>& menu);

 private:
  struct Normal {
    Eigen::MatrixXd gram;     // of the logs, priors included
    numerics::Limits bounds;  // of a step
    fit::PerLogNuisances free;
  };
  // Products of the derivatives C of an explanation on a motion and of its difference d to each of the others, all
  // without what is free in a new log.
  struct OnMotion {
    Eigen::MatrixXd gram;                 // C'C
    std::vector<Eigen::VectorXd> moment;  // C'd
    std::vector<double> square;           // d'd
  };
  // The forces of an explanation on the motions.
  struct Predictions {
    std::vector<Eigen::VectorXd> force;
    std::vector<OnMotion> on_motion;
  };

  void predictForces();
  std::vector<std::size_t> playable() const;
  std::vector<std::size_t> promising(const std::vector<std::size_t>& motions) const;
  void findNormalEquations();
  bool addsUp(std::size_t explanation) const;
  bool isPlayedAlone(std::size_t explanation, Eigen::Index term) const;
  std::vector<bool> movable(std::size_t explanation) const;
  fit::Hypothesis played(std::size_t explanation) const;
  std::vector<Eigen::MatrixXd> derivatives(std::size_t explanation, const std::vector<Eigen::VectorXd>& whole) const;
  void project(std::size_t wrong, const std::vector<std::size_t>& motions);
  double moreNoise(const Eigen::VectorXd& force) const;
  double unrefitted(std::size_t motion) const;
  Refitted refitted(std::size_t right, std::size_t wrong, std::size_t motion) const;
  double priorOfSizes(std::size_t explanation, const Eigen::MatrixXd& gram, const Eigen::VectorXd& scales) const;
  void setNearest(const std::vector<Refitted>& refitted, Discrimination& result) const;
  Discrimination weigh(const Experiment& experiment, std::size_t motion) const;

  const fit::Fitter& fitter_;
  const std::vector<Explanation>& explanations_;
  const std::vector<fit::Candidate>& candidates_;
  double noise_;  // of the logs, over the deviation of their force
  double force_;  // that deviation [N]
  double force_limit_;
  int threads_;
  PlayedMotions played_;
  fit::HypothesisForces forces_;  // over the motions
  std::vector<Normal> normal_;
  std::vector<Predictions> predictions_;
};

}  // namespace rubber_suspension::diagnosis::experiment
