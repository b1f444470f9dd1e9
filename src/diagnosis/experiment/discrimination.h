// How far explanations of the same logs differ over a motion, once the wrong ones have been fitted to it.
#pragma once

#include <vector>

#include "diagnosis/experiment/explanation.h"
#include "diagnosis/experiment/played_motions.h"
#include "fit/fitter.h"

namespace rubber_suspension::diagnosis::experiment {

/// A motion and what it is expected to decide.
struct Discrimination {
  const Experiment* experiment = nullptr;
  double difference = 0.0;   ///< were the first right: RMS force by which the nearest other would still be off [N]
  double floors = 0.0;       ///< expected over what may be right, in noise floors of which ten count at most
  double probability = 0.0;  ///< that the right explanation stands alone once the motion is among the logs
  std::size_t nearest = 0;   ///< the explanation nearest to the first
};

/// T-optimality (Atkinson and Fedorov, Biometrika 62, 1975) for several explanations: each is taken for right with its
/// probability; each other one gives way by a Gauss-Newton step on the normal equations of the logs and of the motion
/// together, and what it is still off by counts, on the motion and on the logs. The zero of the force is free in a new
/// log. About what each of the others fits as well, the least one counts.
class Discriminator {
 public:
  /// All have to outlive it. `force_limit`: motions that any explanation says need more are out [N].
  Discriminator(const fit::Fitter& fitter, const hypotheses::Search& search,
                const std::vector<Explanation>& explanations, double force_limit, int threads);

  void setForceLimit(double force_limit) { force_limit_ = force_limit; }

  /// Of a menu, the motion that tells most in noise floors; without experiment where none can be played that may tell
  /// as much as is needed.
  Discrimination best(const std::vector<Experiment>& menu, double needed = 0.0);

 private:
  struct Normal {
    Eigen::MatrixXd gram;     // of the logs, priors included
    numerics::Limits bounds;  // of a step
    fit::FreeInLog free;
  };
  // Products of the derivatives C of an explanation on a motion and of its difference d to each of the others, all
  // without what is free in a new log.
  struct OnMotion {
    Eigen::MatrixXd gram;                 // C'C
    std::vector<Eigen::VectorXd> moment;  // C'd
    std::vector<double> square;           // d'd
  };
  // The forces of an explanation on the motions.
  struct Says {
    std::vector<Eigen::VectorXd> force;
    std::vector<OnMotion> on_motion;
  };
  // What a derivative is a difference of.
  enum class Base { nothing, model_alone, whole };
  struct Derivative {
    std::vector<element::ElementDescription> elements;  // with one parameter moved; none where it cannot move
    double step = 1.0;
    Base base = Base::nothing;
  };

  // The most that a motion can tell, in noise floors.
  struct Bounded {
    double most;
    std::size_t motion;
  };

  void sayForces();
  std::vector<std::size_t> playable() const;
  std::vector<Bounded> promising(const std::vector<std::size_t>& motions, double needed) const;
  void findNormalEquations();
  bool addsUp(std::size_t explanation) const;
  bool isPlayedAlone(std::size_t explanation, Eigen::Index term) const;
  bool isMovable(std::size_t explanation, Eigen::Index term) const;
  std::vector<bool> movable(std::size_t explanation) const;
  Derivative derivativeBy(std::size_t explanation, Eigen::Index unknown) const;
  std::vector<Eigen::MatrixXd> derivatives(std::size_t explanation, const std::vector<Eigen::VectorXd>& whole) const;
  void project(std::size_t wrong, const std::vector<std::size_t>& motions);
  double floorOf(double force_deviation) const;
  double unrefitted(std::size_t motion) const;
  double leftAfterRefit(std::size_t right, std::size_t wrong, std::size_t motion) const;
  Discrimination weigh(const Experiment& experiment, std::size_t motion) const;
  std::vector<element::ElementDescription> elementsOf(std::size_t explanation, const fit::ParameterVector& at) const;

  const fit::Fitter& fitter_;
  const std::vector<Explanation>& explanations_;
  double noise_;     // of a new log [N]
  double accepted_;  // of the force's standard deviation: less is within the accuracy of models
  double force_limit_;
  int threads_;
  PlayedMotions played_;
  std::vector<Normal> normal_;
  std::vector<Says> says_;
};

}  // namespace rubber_suspension::diagnosis::experiment
