// Replacement of the configured model by a second model: in parallel, then by a cross-fade. Independent of ROS.
#pragma once

#include <cstdint>
#include <limits>
#include <string>

#include "rubber_suspension/element/element.h"

namespace rubber_suspension::node {

/// The model from which the published force is computed.
enum class RunStage {
  configured,    ///< the configured model alone
  shadow,        ///< the configured model, while the other model is computed in parallel
  promoting,     ///< a cross-fade to the other model
  promoted,      ///< the other model, while the configured model is computed in parallel
  rolling_back,  ///< a cross-fade to the configured model, after which the stage is `configured`
};

std::string toString(RunStage stage);

/// Returns the stage with this name. Throws std::invalid_argument for any other text.
RunStage runStageOf(const std::string& name);

struct PromotionSettings {
  double shadow = 5.0;  ///< time for which a model is computed in parallel before the cross-fade [s]
  double fade = 1.0;    ///< duration of a cross-fade [s]
};

/// Sums of the squared errors of two models at the same samples [N^2].
struct PairedErrors {
  std::uint64_t samples = 0;  ///< number of samples with a measured force
  double published = 0.0;     ///< sum for the published force
  double other = 0.0;         ///< sum for the force of the second model
};

/// Controls the weight w of the other model in the published force
///   F = F_configured + w (F_other - F_configured),  where w changes from 0 to 1 or back with the slope 1/fade.
/// From one sample to the next, this changes F by at most dt/fade |F_other - F_configured|. So F does not jump, unless
/// the force of the other model is not finite; then the configured force is published at once.
class CrossFade {
 public:
  CrossFade(const PromotionSettings& settings, RunStage stage, double weight)
      : settings_(settings), stage_(stage), weight_(weight) {}

  RunStage stage() const { return stage_; }
  double weight() const { return weight_; }
  std::int64_t since() const { return since_; }  ///< stamp of the stage's first sample [ns]

  /// Advances to a sample with this stamp [ns]. A stamp that steps back does not advance the cross-fade.
  void advance(std::int64_t stamp);

  /// Continues a saved stage, whose last sample had this stamp [ns]. The time of the stage begins again.
  void resume(std::int64_t stamp) {
    last_ = stamp;
    since_ = stamp;
  }

  /// Returns true once the time of the shadow stage is over. The caller then has to call take() or end().
  bool shadowIsOver() const;

  /// Begins the cross-fade from the configured model to the other model.
  void take() { enter(RunStage::promoting); }
  void giveBack();  ///< begins the cross-fade to the configured model, which is immediate at weight 0

  void end();

  /// Returns the published force, which is the weighted mean of the forces of both models.
  element::ComponentForce blend(const element::ComponentForce& configured, const element::ComponentForce& other) const;

 private:
  void enter(RunStage stage);

  PromotionSettings settings_;
  RunStage stage_;
  double weight_;
  std::int64_t since_ = 0;
  std::int64_t last_ = std::numeric_limits<std::int64_t>::min();
};

std::string describeErrors(const PairedErrors& errors);

}  // namespace rubber_suspension::node
