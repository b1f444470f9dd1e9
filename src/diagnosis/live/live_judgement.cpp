// The judgement of a component while its bench runs.
#include "diagnosis/live/live_judgement.h"

#include <algorithm>
#include <cmath>

#include "diagnosis/live/onset.h"
#include "element/each.h"

namespace rubber_suspension::diagnosis::live {
namespace {

constexpr std::size_t kMostPoints = 3600;  // an hour of blocks of a second
constexpr double kStill = 0.1;             // of the usual force: hardly any motion
constexpr double kSlow = 0.02;             // weight of a new block in what is usual
constexpr double kLeastRise = 0.1;         // in the logarithm: 10 % more error

}  // namespace

std::string toString(const LiveVerdict& verdict) { return verdict.verdict ? toString(*verdict.verdict) : "watching"; }

LiveJudgement::LiveJudgement(const LiveCriteria& criteria) : criteria_(criteria), evidence_(criteria.threshold()) {}

bool LiveJudgement::moves(const BlockErrors& block) {
  const bool moves = block.force > kStill * usual_force_;
  usual_force_ = usual_force_ == 0.0 ? block.force : (1.0 - kSlow) * usual_force_ + kSlow * block.force;
  return moves && block.force > 0.0;
}

void LiveJudgement::addBlock(const BlockErrors& block) {
  if (!moves(block)) {
    return;
  }
  if (block.configured > 0.0) {
    points_.push_back({block.begin, std::log(block.configured)});
  }
  if (points_.size() > kMostPoints) {
    points_.pop_front();
  }
  const bool bet = claim_ && !std::isnan(block.augmented) && block.augmented != block.configured;
  if (bet) {
    const double other =
        std::isnan(block.re_estimated) ? block.configured : std::min(block.configured, block.re_estimated);
    evidence_.add(block.augmented < other);
    named_ = named_ || evidence_.isReached();
  }
}

void LiveJudgement::addLook(const Look& look) {
  if (!look.effects.empty()) {
    claim_ = look;
    agreeing_ = 0;
    last_verdict_.reset();
    if (!named_) {
      said_.reset();
    }
    return;
  }
  agreeing_ = look.verdict == last_verdict_ ? agreeing_ + 1 : 1;
  last_verdict_ = look.verdict;
  if (agreeing_ >= kAgreeing || (look.verdict == Verdict::none && !named_)) {
    said_ = look.verdict;
    claim_.reset();
    named_ = false;
    evidence_.forget();
  }
}

std::vector<double> LiveJudgement::logErrors() const { return element::each(points_, &Point::log_error); }

std::optional<std::int64_t> LiveJudgement::regimeBegin() const {
  const auto change = lastChange(logErrors());
  return change ? std::optional<std::int64_t>(points_[change->first].begin) : std::nullopt;
}

LiveVerdict LiveJudgement::now() const {
  LiveVerdict verdict;
  verdict.evidence = evidence_.value();
  verdict.threshold = evidence_.threshold();
  verdict.verdict = said_;
  if (named_) {
    verdict.verdict = claim_->verdict;
    verdict.effects = claim_->effects;
  }
  const auto change = verdict.isGap() ? lastChange(logErrors()) : std::nullopt;
  if (change && change->after > change->before + kLeastRise) {
    verdict.since = points_[change->first].begin;
  }
  return verdict;
}

}  // namespace rubber_suspension::diagnosis::live
