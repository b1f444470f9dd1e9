// The live diagnosis on simulated benches: an effect is named in time with its onset, and none is named in hours
// without a gap. RUBBER_SUSPENSION_LIVE_HOURS=100 replays 100 h instead of a few minutes.
#include "diagnosis/live/live_diagnosis.h"

#include <iostream>

#include "io/cancellation.h"
#include "rubber_suspension/component/sample_stream.h"
#include "rubber_suspension/element/constants.h"
#include "support/kit.h"

namespace rubber_suspension {
namespace {

using diagnosis::live::LiveDiagnosis;
using diagnosis::live::LiveSample;

constexpr double kRate = 200.0;  // [Hz]
constexpr std::int64_t kStart = 1700000000LL * 1000000000LL;

io::ComponentDescription configured() { return {"bush", {spring(3e6), maxwell(1.2e6, 2.0), maxwell(0.7e6, 12.0)}}; }

io::ComponentDescription withFriction() {
  io::ComponentDescription description = configured();
  // Friction of 350 N at typical amplitudes is 5 % of the standard deviation of 7 kN under the motion below.
  description.add = {friction(400.0, 0.0003)};
  return description;
}

/// Motion as on a track: 40 sines from 0.3 to 8 Hz. Amplitudes fall with frequency, and the standard deviation is 2 mm.
class Track {
 public:
  explicit Track(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    double square = 0.0;
    for (int i = 0; i < kLines; ++i) {
      const double frequency = 0.3 * std::pow(8.0 / 0.3, (i + uniform(random)) / kLines);
      lines_.push_back({2.0 * element::kPi * frequency, 1.0 / frequency, 2.0 * element::kPi * uniform(random)});
      square += 0.5 / (frequency * frequency);
    }
    scale_ = 2e-3 / std::sqrt(square);
  }

  double operator()(double t) const {
    double sum = 0.0;
    for (const Line& line : lines_) {
      sum += line.amplitude * std::sin(line.omega * t + line.phase);
    }
    return scale_ * sum;
  }

 private:
  struct Line {
    double omega;
    double amplitude;
    double phase;
  };
  static constexpr int kLines = 40;
  std::vector<Line> lines_;
  double scale_ = 1.0;
};

/// A bench with the true component on a track, white noise of 1 %, and a wandering offset of the force sensor.
class VirtualBench {
 public:
  VirtualBench(const io::ComponentDescription& truth, unsigned seed)
      : track_(seed), random_(seed), component_(truth.makeComponent()), stream_(component_) {}

  LiveSample next() {
    const double t = static_cast<double>(count_) / kRate;
    const std::int64_t stamp = kStart + std::llround(1e9 * t);
    ++count_;
    const double displacement = track_(t);
    zero_ += 0.05 * noise_(random_);
    return {stamp, displacement, stream_.push(stamp, displacement).force.total + zero_ + 70.0 * noise_(random_)};
  }

  double time() const { return static_cast<double>(count_) / kRate; }

 private:
  Track track_;
  std::mt19937 random_;
  std::normal_distribution<double> noise_;
  component::Component component_;
  component::SampleStream stream_;
  double zero_ = 0.0;
  std::int64_t count_ = 0;
};

void feed(LiveDiagnosis& live, const LiveSample& sample) {
  live.add(sample);
  if (live.lookIsDue()) {
    live.look();
  }
}

TEST(LiveDiagnosis, AnEffectThatSetsInIsNamedWithItsOnset) {
  constexpr double kOnset = 120.0;
  VirtualBench before(configured(), 5);
  VirtualBench after(withFriction(), 5);  // the same motion and noise
  LiveDiagnosis live(configured());
  double named = 0.0;
  while (before.time() < kOnset + 120.0 && named == 0.0) {
    const LiveSample old_one = before.next();
    const LiveSample new_one = after.next();
    feed(live, before.time() < kOnset ? old_one : new_one);
    if (before.time() < kOnset) {
      ASSERT_TRUE(live.findings().now.effects.empty()) << before.time();
    } else if (!live.findings().now.effects.empty()) {
      named = before.time();
    }
  }
  const diagnosis::live::LiveFindings findings = live.findings();
  std::cout << "named after " << named - kOnset << " s: " << findings.sentence << '\n';
  ASSERT_GT(named, 0.0) << "within two minutes of motion: " << findings.sentence;
  EXPECT_EQ(findings.now.effects.front(), "friction");
  ASSERT_TRUE(findings.now.since);
  EXPECT_NEAR(1e-9 * static_cast<double>(*findings.now.since - kStart), kOnset, 10.0);
  EXPECT_LT(findings.gap.augmented, findings.gap.as_configured);
  EXPECT_EQ(findings.probabilities.size(), findings.now.effects.size());
  EXPECT_FALSE(findings.where.empty());
  const auto found = live.found();
  ASSERT_TRUE(found);
  EXPECT_FALSE(found->add.empty());
}

// The measured force differs from the model by noise and by the offset of the force sensor only.
TEST(LiveDiagnosis, HoursWithoutAGapBringNoName) {
  const char* asked = std::getenv("RUBBER_SUSPENSION_LIVE_HOURS");
  const double hours = asked != nullptr ? std::atof(asked) : 0.15;
  constexpr double kStretch = 0.5;  // duration with the same motion [h]
  double done = 0.0;
  int names = 0;
  std::size_t looks = 0;
  std::size_t claims = 0;
  double most = 0.0;
  for (unsigned seed = 1; done < hours; ++seed) {
    VirtualBench bench(configured(), seed);
    LiveDiagnosis live(configured());
    const double length = std::min(kStretch, hours - done);
    bool named = false;
    std::size_t seen = 0;
    while (bench.time() < 3600.0 * length) {
      feed(live, bench.next());
      const bool new_look = live.looks() != seen;
      if (new_look) {
        seen = live.looks();
        const diagnosis::live::LiveFindings findings = live.findings();
        claims += !findings.now.verdict ? 1 : 0;
        most = std::max(most, findings.now.evidence);
        named = named || !findings.now.effects.empty();
      }
    }
    named = named || !live.findings().now.effects.empty();
    looks += seen;
    names += named ? 1 : 0;
    done += length;
    if (asked != nullptr) {
      std::cout << done << " h, " << looks << " looks, " << claims << " with a claim, evidence at most " << most << ", "
                << names << " false names" << std::endl;
    }
  }
  // One name in 100 h is accepted, so no name in a few minutes.
  EXPECT_LE(names, static_cast<int>(hours / 100.0));
  EXPECT_GE(looks, static_cast<std::size_t>(hours * 3600.0 / 90.0)) << "it has to have looked";
}

TEST(LiveDiagnosis, ANewRecordingForgetsTheOldOne) {
  VirtualBench bench(withFriction(), 2);
  LiveDiagnosis live(configured());
  LiveSample sample = bench.next();
  while (bench.time() < 30.0) {
    feed(live, sample = bench.next());
  }
  EXPECT_GE(live.looks(), 1U);
  live.add({sample.stamp - 1000, 0.0, 0.0});  // dropped, because time steps back
  EXPECT_GE(live.looks(), 1U);
  live.add({kStart, 0.0, 0.0});
  EXPECT_EQ(live.looks(), 0U);
  EXPECT_FALSE(live.found());
}

TEST(LiveDiagnosis, ALookCanBeCancelledAndOneThatCannotBeSaysWhy) {
  VirtualBench bench(withFriction(), 2);
  LiveDiagnosis live(configured());
  while (!live.lookIsDue()) {
    live.add(bench.next());
  }
  EXPECT_THROW(live.look([] { return true; }), io::Cancelled);
  LiveDiagnosis still(configured());
  for (int i = 0; i < 6000; ++i) {
    feed(still, {kStart + i * 5000000LL, 1e-3, 3e3});
  }
  EXPECT_EQ(still.findings().now.verdict, std::nullopt);
  EXPECT_FALSE(still.findings().sentence.empty());
  LiveDiagnosis tiny(configured());  // for a motion of 0.1 um, a coefficient of z^5 is out of range
  for (int i = 0; i < 6000; ++i) {
    const double z = std::sin(0.05 * i);
    feed(tiny, {kStart + i * 5000000LL, 1e-7 * z, 0.33 * z + 0.1 * z * z * z});
  }
  EXPECT_THAT(tiny.findings().sentence, testing::HasSubstr("progressive stiffness"));
}

}  // namespace
}  // namespace rubber_suspension
