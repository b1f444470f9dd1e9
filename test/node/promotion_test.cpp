// A promoted model replaces the configured one: shadow, cross-fade without a jump, rollback, refusals.
#include "node/promotion.h"

#include "node/component_channel.h"
#include "node/state_file.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

using node::RunStage;

constexpr std::int64_t kMillisecond = 1000000;
constexpr double kStep = 1e-3;  // [s]
const node::PromotionSettings kSettings{2.0, 0.5};

io::ComponentDescription configured() {
  return {"bush",
          {{"spring", {{"stiffness", {3e6}}}}, {"maxwell", {{"stiffness", {1.2e6}}, {"break_frequency", {2.0}}}}}};
}

io::ComponentDescription withFriction() {
  io::ComponentDescription description = configured();
  description.add = {{"friction", {{"maximum_force", {1500.0}}, {"displacement", {0.0008}}}}};
  return description;
}

double wave(int i) { return 2e-3 * std::sin(0.025 * i) + 1e-4 * std::cos(0.3 * i); }

/// Steps a model alone on the same samples.
class Alone {
 public:
  explicit Alone(const io::ComponentDescription& description)
      : component_(description.makeComponent()), stream_(component_) {}

  double force(int i) { return stream_.push(i * kMillisecond, wave(i)).force.total; }

 private:
  component::Component component_;
  component::SampleStream stream_;
};

double force(node::ComponentChannel& channel, int i) {
  element::ComponentForce result;
  EXPECT_TRUE(channel.push(i * kMillisecond, wave(i), result));
  return result.total;
}

void run(node::ComponentChannel& channel, int first, int last) {
  for (int i = first; i < last; ++i) {
    force(channel, i);
  }
}

std::string refusalOf(const std::function<void()>& action) {
  return messageOf<std::invalid_argument>([&] { action(); });
}

TEST(Promotion, TakesTheForceOverWithinItsBoundAndGivesItBack) {
  node::ComponentChannel channel(configured(), 0.5, kSettings);
  Alone ours(configured());
  Alone other(withFriction());
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(force(channel, i), ours.force(i));
  }
  channel.promote(withFriction());
  double weight = 0.0;  // weight of the promoted model in the published force, where it is known
  for (int i = 100; i < 6000; ++i) {
    if (i == 4000) {
      EXPECT_EQ(channel.running().stage, RunStage::promoted);
      EXPECT_EQ(weight, 1.0);
      channel.rollBack();
    }
    const double a = ours.force(i);
    const double b = other.force(i);
    const double published = force(channel, i);
    // The published force changes with the weight at most as documented, up to rounding.
    EXPECT_LE(std::abs(published - (a + weight * (b - a))),
              kStep / kSettings.fade * std::abs(b - a) * (1.0 + 1e-6) + 1e-9)
        << i;
    if (published == a || published == b) {
      weight = published == b ? 1.0 : 0.0;
    } else {
      weight = (published - a) / (b - a);
    }
    if (i < 2000) {
      EXPECT_EQ(published, a) << "in the shadow";
    }
  }
  EXPECT_EQ(weight, 0.0);
  EXPECT_EQ(channel.running().stage, RunStage::configured);
  EXPECT_EQ(force(channel, 6000), ours.force(6000));
  EXPECT_TRUE(channel.running().other_sha256.empty());
}

// The difference of two forces near the largest double would overflow.
TEST(Promotion, ACrossFadeDoesNotOverflow) {
  element::ComponentForce low;
  element::ComponentForce high;
  low.total = low.elastic = -1e308;
  high.total = high.elastic = 1e308;
  for (const double weight : {0.0, 0.25, 0.5, 1.0}) {
    const double blended = node::CrossFade(kSettings, RunStage::promoting, weight).blend(low, high).total;
    EXPECT_NEAR(blended, (2.0 * weight - 1.0) * 1e308, 1e293);
  }
}

TEST(Promotion, TellsWhatRuns) {
  node::ComponentChannel channel(configured(), 0.5, kSettings);
  run(channel, 0, 10);
  const std::string hash = channel.running().configured_sha256;
  EXPECT_EQ(hash.size(), 64U);
  channel.promote(withFriction());
  EXPECT_EQ(channel.running().stage, RunStage::shadow);
  run(channel, 10, 5000);
  const node::RunningModel running = channel.running();
  EXPECT_EQ(running.stage, RunStage::promoted);
  EXPECT_EQ(running.configured_sha256, hash);
  EXPECT_NE(running.other_sha256, hash);
  EXPECT_THAT(running.added, testing::ElementsAre("friction"));
  EXPECT_EQ(running.since, (10 + 2000 + 500) * kMillisecond);
  EXPECT_THAT(running.note, HasSubstr("no force was measured"));
}

// The measured force equals that of the configured model, so the promoted model would increase the gap.
TEST(Promotion, AWorseModelStaysInTheShadow) {
  node::ComponentChannel channel(configured(), 0.5, kSettings);
  Alone measured(configured());
  channel.gap().addMeasured(0, measured.force(0));
  force(channel, 0);
  channel.promote(withFriction());
  for (int i = 1; i < 4000; ++i) {
    force(channel, i);
    channel.gap().addMeasured(i * kMillisecond, measured.force(i));
  }
  const node::RunningModel running = channel.running();
  EXPECT_EQ(running.stage, RunStage::configured);
  EXPECT_THAT(running.note, HasSubstr("the model was not promoted because it was worse: RMS error"));
}

TEST(Promotion, ABetterModelIsPromotedAndStaysWhenTheMeasuredForceIsLost) {
  node::ComponentChannel channel(configured(), 0.5, kSettings);
  Alone measured(withFriction());
  channel.gap().addMeasured(0, measured.force(0));
  force(channel, 0);
  channel.promote(withFriction());
  for (int i = 1; i < 3000; ++i) {
    force(channel, i);
    channel.gap().addMeasured(i * kMillisecond, measured.force(i));
  }
  EXPECT_EQ(channel.running().stage, RunStage::promoted);
  run(channel, 3000, 6000);
  EXPECT_EQ(channel.running().stage, RunStage::promoted);
}

TEST(Promotion, RefusesWhatCannotBe) {
  node::ComponentChannel channel(configured(), 0.5, kSettings);
  EXPECT_THAT(refusalOf([&] { channel.rollBack(); }), HasSubstr("no model is promoted"));
  channel.promote(withFriction());
  EXPECT_THAT(refusalOf([&] { channel.promote(withFriction()); }), HasSubstr("after a rollback"));
  channel.rollBack();  // from the shadow, without waiting for a sample
  EXPECT_THAT(refusalOf([&] { channel.rollBack(); }), HasSubstr("no model is promoted"));
  channel.promote(withFriction());
  EXPECT_EQ(channel.running().stage, RunStage::shadow);
}

TEST(Promotion, AForceThatIsNotFiniteEndsItAtOnce) {
  io::ComponentDescription wild = configured();
  wild.add = {
      {"bump_stop", {{"gap", {1.0}}, {"stiffness", {1e30}}, {"exponent", {3.0}}, {"reference_depth", {1e-99}}}}};
  node::ComponentChannel channel(configured(), 0.5, kSettings);
  channel.promote(wild);
  run(channel, 0, 3000);
  ASSERT_EQ(channel.running().stage, RunStage::promoted);
  element::ComponentForce result;
  ASSERT_TRUE(channel.push(3000 * kMillisecond, 1e30, result));  // its power overflows
  EXPECT_TRUE(std::isfinite(result.total));
  EXPECT_EQ(channel.running().stage, RunStage::configured);
  EXPECT_THAT(channel.running().note, HasSubstr("not finite"));
}

// At every stage, the state file contains the promoted model, so the node can continue without another file.
TEST(Promotion, ASavedStateGoesOnBitByBit) {
  for (const int saved_at : {500, 2200, 4000, 5100}) {
    node::ComponentChannel whole(configured(), 0.5, kSettings);
    whole.promote(withFriction());
    run(whole, 0, std::min(saved_at, 5000));
    if (saved_at > 5000) {
      whole.rollBack();
      run(whole, 5000, saved_at);
    }
    const std::string text = node::stateText({whole.save()});
    node::ComponentChannel after(configured(), 0.5, kSettings);
    after.load(node::parseStates(text, "state.json").front());
    EXPECT_EQ(after.running().stage, whole.running().stage);
    EXPECT_EQ(after.running().other_sha256, whole.running().other_sha256);
    // After loading, the shadow phase starts again. So the comparison ends where the original shadow phase ends.
    const int last = saved_at == 500 ? 2000 : saved_at + 2000;
    for (int i = saved_at; i < last; ++i) {
      ASSERT_EQ(force(after, i), force(whole, i)) << "saved at " << saved_at << ", sample " << i;
    }
  }
}

TEST(Promotion, AStateThatWasTamperedWithIsRefused) {
  node::ComponentChannel channel(configured(), 0.5, kSettings);
  channel.promote(withFriction());
  run(channel, 0, 3000);
  const std::string text = node::stateText({channel.save()});
  const auto replaced = [&](const std::string& from, const std::string& to) {
    std::string result = text;
    const std::size_t place = result.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    return result.replace(place, from.size(), to);
  };
  for (const std::string& bad :
       {replaced("maximum_force: 1500", "maximum_force: 1600"), replaced("\"promoted\"", "\"configured\""),
        replaced("\"promoted\"", "\"sideways\""), replaced("\"weight\": 1.0", "\"weight\": 0.5")}) {
    EXPECT_THROW(node::parseStates(bad, "state.json"), node::FileError);
  }
}

TEST(Promotion, EndsWhereTheComponentFileHasAnotherModel) {
  node::ComponentChannel channel(configured(), 0.5, kSettings);
  channel.promote(withFriction());
  run(channel, 0, 3000);
  channel.exchange(node::ComponentChannel::makeModel(configured(), 0.5));
  EXPECT_EQ(channel.running().stage, RunStage::promoted) << "the same model";
  io::ComponentDescription stiffer("bush", {{"spring", {{"stiffness", {4e6}}}}});
  channel.exchange(node::ComponentChannel::makeModel(stiffer, 0.5));
  EXPECT_EQ(channel.running().stage, RunStage::configured);
  EXPECT_THAT(channel.running().note, HasSubstr("another model"));
}

TEST(Promotion, AResetPutsBothModelsAtRest) {
  node::ComponentChannel channel(configured(), 0.5, kSettings);
  channel.promote(withFriction());
  run(channel, 0, 3000);
  channel.reset();
  Alone other(withFriction());
  for (int i = 3000; i < 3500; ++i) {
    EXPECT_EQ(force(channel, i), other.force(i));
  }
}

}  // namespace
}  // namespace rubber_suspension
