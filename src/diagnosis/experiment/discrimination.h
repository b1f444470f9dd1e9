// Computes how well a motion distinguishes explanations of the same logs after a refit of the wrong ones.
#pragma once

#include <limits>
#include <vector>

#include "diagnosis/experiment/explanation.h"
#include "diagnosis/experiment/played_motions.h"
#include "fit/fitter.h"
#include "fit/hypothesis_forces.h"

namespace rubber_suspension::diagnosis::experiment {

/// A motion with the outcome that is expected of it.
struct Discrimination {
  const Experiment* experiment = nullptr;
  /// if the first explanation is right: RMS force error of the nearest other explanation after a refit [N]
  double difference = 0.0;
  std::size_t nearest = 0;  ///< index of this explanation, which does not contain the first; 0 if there is none
  double open = std::numeric_limits<double>::infinity();  ///< expected entropy after the motion is recorded [bit]
  double probability = 0.0;  ///< expected probability that the right explanation is then the only likely one
};

/// Finds the motion that most lowers the expected entropy of the question which effects are at work (Lindley, Ann.
/// Math. Stat. 27, 1956). Each explanation is assumed to be right with its probability. All others are refitted by a
/// Gauss-Newton step to the logs and the motion together, with a free offset of the new log. Their errors and the sizes
/// of their effects are judged as in a diagnosis. An explanation that contains the right one can reproduce its force,
/// but only with a further effect of almost no force, which is improbable.
class Discriminator {
 public:
  /// All arguments have to outlive this object. Motions with predicted forces above `force_limit` [N] are excluded.
  Discriminator(const fit::Fitter& fitter, const hypotheses::Search& search,
                const std::vector<Explanation>& explanations, double force_limit, int threads);
  Discriminator(const Discriminator&) = delete;
  Discriminator& operator=(const Discriminator&) = delete;

  void setForceLimit(double force_limit) { force_limit_ = force_limit; }

  /// Returns the motion with the least expected entropy. Its `experiment` is null if every motion is excluded.
  Discrimination best(const std::vector<Experiment>& menu);

 private:
  struct Normal {
    Eigen::MatrixXd gram;     // normal matrix of the logs, including priors
    numerics::Limits bounds;  // limits of a step
    fit::PerLogNuisances free;
  };
  // Products of an explanation's derivatives C on a motion and, for each other explanation, the difference d of the
  // forces. The free parameters of a new log are eliminated.
  struct OnMotion {
    Eigen::MatrixXd gram;                 // C'C
    std::vector<Eigen::VectorXd> moment;  // C'd
    std::vector<double> square;           // d'd
  };
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
  double noise_;  // noise floor of the logs divided by the standard deviation of their force
  double force_;  // standard deviation of the force of the logs [N]
  double force_limit_;
  int threads_;
  PlayedMotions played_;
  fit::HypothesisForces forces_;  // evaluates forces on the motions
  std::vector<Normal> normal_;
  std::vector<Predictions> predictions_;
};

}  // namespace rubber_suspension::diagnosis::experiment
