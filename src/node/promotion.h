// Replacement of the configured model: first in its shadow, then by a cross-fade, and back. Independent of ROS.
#pragma once

#include <cstdint>
#include <limits>
#include <string>

#include "rubber_suspension/element/element.h"

namespace rubber_suspension::node {

/// The source of a component's force.
enum class RunStage {
  configured,    ///< the configured model alone
  shadow,        ///< the configured model, while the other is computed beside it
  promoting,     ///< a cross-fade to the other model
  promoted,      ///< the other model, while the configured one is computed beside it
  rolling_back,  ///< a cross-fade to the configured model; `configured` follows
};

std::string toString(RunStage stage);

/// The stage of that name; throws std::invalid_argument.
RunStage runStageOf(const std::string& name);

struct PromotionSettings {
  double shadow = 5.0;  ///< time that a model is computed beside the configured one before the cross-fade [s]
  double fade = 1.0;    ///< time of a cross-fade [s]
};

/// Squared errors of two models at the same samples [N^2], summed up.
struct PairedErrors {
  std::uint64_t samples = 0;  ///< with a measured force
  double published = 0.0;     ///< of the force that was published
  double other = 0.0;         ///< of the force of the model beside it
};

/// The weight of the other model in the published force, as the stamps go on. Published is
///   F = F_configured + w (F_other - F_configured),  w from 0 to 1 or back with the slope 1/fade.
/// From one sample to the next the change of w alone changes F by at most dt/fade |F_other - F_configured|: there is no
/// other jump than that, unless the other model's force is not finite; then the configured one is published at once.
class CrossFade {
 public:
  CrossFade(const PromotionSettings& settings, RunStage stage, double weight)
      : settings_(settings), stage_(stage), weight_(weight) {}

  RunStage stage() const { return stage_; }
  double weight() const { return weight_; }
  std::int64_t since() const { return since_; }  ///< stamp of the stage's first sample [ns]

  /// Advances to a sample at that stamp [ns]. A stamp that steps back counts as no time.
  void advance(std::int64_t stamp);

  /// Begins the stage with the last sample, at that stamp.
  void resume(std::int64_t stamp) {
    last_ = stamp;
    since_ = stamp;
  }

  /// True once the shadow is over; then call take() or end().
  bool shadowIsOver() const;

  /// Begins the cross-fade from the configured model to the other one, or reverses a fade back.
  void take() { enter(RunStage::promoting); }
  void giveBack();

  /// Returns to the configured model at once.
  void end();

  /// The published force from those of both models.
  element::ComponentForce blend(const element::ComponentForce& configured, const element::ComponentForce& other) const;

 private:
  void enter(RunStage stage);

  PromotionSettings settings_;
  RunStage stage_;
  double weight_;
  std::int64_t since_ = 0;
  std::int64_t last_ = std::numeric_limits<std::int64_t>::min();
};

/// The two errors in words, as RMS.
std::string describeErrors(const PairedErrors& errors);

}  // namespace rubber_suspension::node
