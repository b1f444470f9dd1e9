// Replacement of the configured model by a cross-fade.
#include "node/promotion.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace rubber_suspension::node {
namespace {

constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::min();
constexpr std::array<const char*, 5> kStages = {"configured", "shadow", "promoting", "promoted", "rolling_back"};

double secondsBetween(std::int64_t earlier, std::int64_t later) {
  return later > earlier ? 1e-9 * static_cast<double>(later - earlier) : 0.0;
}

}  // namespace

std::string toString(RunStage stage) { return kStages.at(static_cast<std::size_t>(stage)); }

RunStage runStageOf(const std::string& name) {
  const auto* const found = std::find(kStages.begin(), kStages.end(), name);
  if (found == kStages.end()) {
    throw std::invalid_argument(fmt::format("stage: '{}' is unknown; accepted: {}", name, fmt::join(kStages, ", ")));
  }
  return static_cast<RunStage>(found - kStages.begin());
}

void CrossFade::enter(RunStage stage) {
  stage_ = stage;
  since_ = last_ == kNever ? 0 : last_;
}

void CrossFade::advance(std::int64_t stamp) {
  const double dt = last_ == kNever ? 0.0 : secondsBetween(last_, stamp);
  if (last_ == kNever || stamp < last_) {
    since_ = stamp;
  }
  last_ = stamp;
  const double step = dt / settings_.fade;
  const bool fades_in = stage_ == RunStage::promoting;
  if (fades_in || stage_ == RunStage::rolling_back) {
    weight_ = std::clamp(weight_ + (fades_in ? step : -step), 0.0, 1.0);
    if (weight_ == (fades_in ? 1.0 : 0.0)) {
      enter(fades_in ? RunStage::promoted : RunStage::configured);
    }
  }
}

bool CrossFade::shadowIsOver() const {
  return stage_ == RunStage::shadow && last_ != kNever && secondsBetween(since_, last_) >= settings_.shadow;
}

void CrossFade::giveBack() { enter(weight_ > 0.0 ? RunStage::rolling_back : RunStage::configured); }

void CrossFade::end() {
  weight_ = 0.0;
  enter(RunStage::configured);
}

element::ComponentForce CrossFade::blend(const element::ComponentForce& configured,
                                         const element::ComponentForce& other) const {
  if (weight_ == 0.0 || weight_ == 1.0) {
    return weight_ == 0.0 ? configured : other;
  }
  using Force = element::ComponentForce;
  Force force = configured;
  for (const auto part : {&Force::total, &Force::elastic, &Force::viscous, &Force::friction}) {
    // Halving before subtraction prevents an overflow.
    force.*part = 2.0 * (0.5 * configured.*part + weight_ * (0.5 * other.*part - 0.5 * configured.*part));
  }
  return force;
}

std::string describeErrors(const PairedErrors& errors) {
  if (errors.samples == 0) {
    return "no force was measured while the model ran in the shadow";
  }
  const double count = static_cast<double>(errors.samples);
  return fmt::format("RMS error {:.4g} N, configured model {:.4g} N, over {} samples", std::sqrt(errors.other / count),
                     std::sqrt(errors.published / count), errors.samples);
}

}  // namespace rubber_suspension::node
