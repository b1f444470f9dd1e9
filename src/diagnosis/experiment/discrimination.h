// Differences between explanations of the same logs on a motion, after a refit of the wrong ones to it.
#pragma once

#include <limits>
#include <vector>

#include "diagnosis/experiment/explanation.h"
#include "diagnosis/experiment/played_motions.h"
#include "fit/fitter.h"
#include "fit/hypothesis_forces.h"

namespace rubber_suspension::diagnosis::experiment {

/// A motion with its expected outcome.
struct Discrimination {
  const Experiment* experiment = nullptr;
  double difference = 0.0;  ///< if the first explanation is right: RMS error of the nearest other after a refit [N]
  std::size_t nearest = 0;  ///< that explanation, which does not contain the first; 0: there is none
  double open = std::numeric_limits<double>::infinity();  ///< expected entropy of names after it [bit]
  double probability = 0.0;  ///< expected, that the right explanation stands alone after it
};

/// Finds the motion that most lowers the expected entropy of the names (Lindley, Ann. Math. Stat. 27, 1956): for each
/// effect, whether it is at work. Each explanation is assumed right with its probability, and all others are refitted
/// by a Gauss-Newton step on the normal equations of the logs and the motion together. Their remaining errors are
/// judged as in a diagnosis, and so are the sizes of their members: a set that contains the right one can reproduce its
/// force, but only with a further member of almost no force, which is improbable. The offset of a new log is free.
class Discriminator {
 public:
  /// All arguments have to outlive this object. `force_limit`: largest force that an explanation may predict for a
  /// motion; other motions are excluded [N].
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
  // Products of the derivatives C of an explanation on a motion and of its difference d to each of the others, after
  // elimination of the unknowns of a new log.
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
  double noise_;  // floor of the logs over the standard deviation of their force
  double force_;  // standard deviation of the force of the logs [N]
  double force_limit_;
  int threads_;
  PlayedMotions played_;
  fit::HypothesisForces forces_;  // over the motions
  std::vector<Normal> normal_;
  std::vector<Predictions> predictions_;
};

}  // namespace rubber_suspension::diagnosis::experiment
