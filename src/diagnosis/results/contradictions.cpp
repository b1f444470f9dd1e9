// The statements of a report held against each other.
#include "diagnosis/results/contradictions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "diagnosis/judge/criteria.h"
#include "rubber_suspension/gap/gap.h"

namespace rubber_suspension::diagnosis {
namespace {

constexpr double kRounding = 1e-9;

class Check {
 public:
  explicit Check(const Diagnosis& diagnosis) : d_(diagnosis) {}

  std::vector<std::string> run() {
    const bool names = d_.verdict == "named" || d_.verdict == "confounded" || d_.verdict == "partly";
    require(d_.effects.empty() != names, fmt::format("{} with {} effects", d_.verdict, d_.effects.size()));
    require(d_.confounded.size() == d_.effects.size(), "not one set for each effect");
    for (std::size_t i = 0; i < std::min(d_.confounded.size(), d_.effects.size()); ++i) {
      const std::vector<std::string>& set = d_.confounded[i];
      require(std::find(set.begin(), set.end(), d_.effects[i]) != set.end(), d_.effects[i] + " is not in its own set");
    }
    if (d_.verdict == "check_bench") {
      return found_;
    }
    checkPosterior();
    checkFloor();
    checkClosed();
    if (names) {
      checkNamed();
    } else if (d_.verdict != "unknown") {
      checkThatNothingIsMissing();
    }
    return found_;
  }

 private:
  void require(bool holds, const std::string& otherwise) {
    if (!holds) {
      found_.push_back(otherwise);
    }
  }

  double verdictsProbability() const {
    const Posterior& p = d_.posterior;
    return d_.verdict == "none"              ? p.none
           : d_.verdict == "parameter_error" ? p.parameter_error
           : d_.verdict == "unknown"         ? p.none_of_these
                                             : p.effects;
  }

  void checkPosterior() {
    const Posterior& p = d_.posterior;
    require(std::abs(p.none + p.parameter_error + p.effects + p.none_of_these - 1.0) < kRounding,
            "the probabilities of the answers do not add up to 1");
    const double likeliest = std::max({p.none, p.parameter_error, p.effects, p.none_of_these});
    require(verdictsProbability() >= likeliest - kRounding,
            fmt::format("{} at {:.2f}, another answer at {:.2f}", d_.verdict, verdictsProbability(), likeliest));
    for (const CandidateResult& candidate : d_.candidates) {
      require(candidate.probability <= p.effects + kRounding,
              fmt::format("{} at {:.2f}, any effect at {:.2f}", candidate.effect, candidate.probability, p.effects));
    }
  }

  void checkFloor() {
    double least = std::min({d_.gap.as_configured, d_.gap.re_estimated, d_.gap.augmented});
    for (const CandidateResult& candidate : d_.candidates) {
      least = std::min(least, candidate.gap);
    }
    require(d_.gap.noise_floor <= least + kRounding,
            fmt::format("a floor of {:.4f}, a model that leaves {:.4f}", d_.gap.noise_floor, least));
  }

  void checkClosed() {
    const double expected =
        std::min(1.0, gap::closedFraction(d_.gap.re_estimated, d_.gap.augmented, d_.gap.noise_floor));
    require(std::abs(d_.closed - expected) < kRounding,
            fmt::format("closes {:.3f}, its gaps say {:.3f}", d_.closed, expected));
  }

  bool isBeyondNoise(double gap) const {
    return gap::residualAboveFloor(gap, d_.gap.noise_floor) > Criteria().beyondNoise(d_.gap.noise_floor);
  }

  void checkNamed() {
    const bool beside_values =
        !d_.confounded.empty() && !d_.confounded.front().empty() && d_.confounded.front().back() == "parameter_error";
    require(
        beside_values || d_.gap.augmented < d_.gap.re_estimated,
        fmt::format("{}, and the gap grows from {:.4f} to {:.4f}", d_.verdict, d_.gap.re_estimated, d_.gap.augmented));
    require(beside_values || d_.closed_interval[0] > 0.0,
            fmt::format("{}, and the interval of what is closed holds 0", d_.verdict));
    require(
        d_.verdict == "partly" || !isBeyondNoise(d_.gap.augmented),
        fmt::format("{} with {:.4f} left over a floor of {:.4f}", d_.verdict, d_.gap.augmented, d_.gap.noise_floor));
  }

  // Only a gain that is worth speaking of counts.
  void checkThatNothingIsMissing() {
    const double left = d_.verdict == "none" ? d_.gap.as_configured : d_.gap.re_estimated;
    require(!isBeyondNoise(left),
            fmt::format("{} with {:.4f} left over a floor of {:.4f}", d_.verdict, left, d_.gap.noise_floor));
    for (const CandidateResult& candidate : d_.candidates) {
      const double gain = std::sqrt(std::max(0.0, left * left - candidate.gap * candidate.gap));
      require(candidate.interval[0] <= 0.0 || !isBeyondNoise(std::hypot(gain, d_.gap.noise_floor)),
              fmt::format("{} with {:.4f} left, where {} leaves {:.4f}", d_.verdict, left, candidate.effect,
                          candidate.gap));
    }
  }

  const Diagnosis& d_;
  std::vector<std::string> found_;
};

}  // namespace

std::vector<std::string> contradictions(const Diagnosis& diagnosis) { return Check(diagnosis).run(); }

}  // namespace rubber_suspension::diagnosis
