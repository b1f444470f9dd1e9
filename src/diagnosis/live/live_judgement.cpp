// Judges a component while its bench runs.
#include "diagnosis/live/live_judgement.h"

#include <algorithm>
#include <cmath>

#include "element/each.h"

namespace rubber_suspension::diagnosis::live {
namespace {

constexpr std::size_t kMostPoints = 3600;  // an hour of blocks of one second
constexpr double kStill = 0.1;             // the component hardly moves below this share of the usual force
constexpr double kSlow = 0.02;             // weight of a new block in the running mean of the force
constexpr double kLeastRise = 0.1;         // least increase of the logarithmic error that is an onset: 10 %

constexpr std::size_t kShortest = 4;
// Least standard deviation of a stretch. The RMS of n = 100 samples of noise scatters by 1/sqrt(2 n) = 7 %.
constexpr double kLeastDeviation = 0.05;
// A change needs a log-likelihood ratio of at least 6 + 3 ln n for n possible positions. By chance, the best of n
// positions gains about 3/2 ln n in addition to the gain from three more parameters. Twice this value is safe.
constexpr double kLeastGain = 6.0;
constexpr double kGainPerPlace = 3.0;

/// Cumulative sums of values and of their squares.
class Sums {
 public:
  explicit Sums(const std::vector<double>& values) : sum_(values.size() + 1), square_(values.size() + 1) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      sum_[i + 1] = sum_[i] + values[i];
      square_[i + 1] = square_[i] + values[i] * values[i];
    }
  }

  double mean(std::size_t first, std::size_t last) const {
    return (sum_[last] - sum_[first]) / static_cast<double>(last - first);
  }

  // Returns the largest log-likelihood of normal values in a stretch, up to a constant.
  double likelihood(std::size_t first, std::size_t last) const {
    const double count = static_cast<double>(last - first);
    const double middle = mean(first, last);
    const double variance = (square_[last] - square_[first]) / count - middle * middle;
    return -0.5 * count * std::log(std::max(variance, kLeastDeviation * kLeastDeviation));
  }

 private:
  std::vector<double> sum_;
  std::vector<double> square_;
};

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

std::optional<ChangePoint> mostLikelyChange(const std::vector<double>& values) {
  const std::size_t count = values.size();
  if (count < 2 * kShortest) {
    return {};
  }
  const Sums sums(values);
  const double whole = sums.likelihood(0, count);
  ChangePoint best;
  for (std::size_t place = kShortest; place + kShortest <= count; ++place) {
    const double gain = sums.likelihood(0, place) + sums.likelihood(place, count) - whole;
    if (gain > best.likelihood) {
      best = {place, gain, sums.mean(0, place), sums.mean(place, count)};
    }
  }
  if (best.likelihood < kLeastGain + kGainPerPlace * std::log(static_cast<double>(count))) {
    return {};
  }
  return best;
}

std::optional<ChangePoint> lastChange(const std::vector<double>& values) {
  std::optional<ChangePoint> last;
  std::vector<double> rest = values;
  std::size_t offset = 0;
  while (auto change = mostLikelyChange(rest)) {
    rest.erase(rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(change->first));
    offset += change->first;
    last = change;
    last->first = offset;
  }
  return last;
}

}  // namespace rubber_suspension::diagnosis::live
