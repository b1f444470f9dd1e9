// Steps of a component against its laws one by one: the same bits, whatever was done to the state in between.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "rubber_suspension/component/component.h"
#include "rubber_suspension/processor/instructions.h"

namespace rubber_suspension::test {
namespace {

/// Spring, dashpot, Maxwell elements and at most one element of friction, each on its own.
class LawsOneByOne {
 public:
  explicit LawsOneByOne(std::mt19937& random) {
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    stiffness_ = 3e6 * uniform(random);
    elements_ = {{"spring", {{"stiffness", {stiffness_}}}}};
    if (uniform(random) < 0.5) {
      damping_ = 1e4 * uniform(random);
      elements_.push_back({"dashpot", {{"damping", {damping_}}}});
    }
    const std::size_t maxwells = random() % 21;
    for (std::size_t i = 0; i < maxwells; ++i) {
      const double stiffness = 1e6 * uniform(random);
      const double break_frequency = 0.01 * std::pow(1e5, uniform(random));
      maxwells_.emplace_back(stiffness, break_frequency);
      elements_.push_back({"maxwell", {{"stiffness", {stiffness}}, {"break_frequency", {break_frequency}}}});
    }
    if (uniform(random) < 0.8) {
      const double maximum_force = 1e4 * uniform(random);
      const double displacement = 2e-3 * uniform(random);
      const double dead_band = uniform(random) < 0.5 ? 2e-4 * uniform(random) : 0.0;
      bergs_.emplace_back(maximum_force, displacement, dead_band);
      elements_.push_back(
          {"friction",
           {{"maximum_force", {maximum_force}}, {"displacement", {displacement}}, {"dead_band", {dead_band}}}});
    }
    memory_.resize(maxwells + bergs_.size() * element::BergFriction::kMemorySize);
  }

  const std::vector<element::ElementDescription>& elements() const { return elements_; }
  const std::vector<double>& memory() const { return memory_; }

  void deserialise(double displacement, const std::vector<double>& memory) {
    displacement_ = displacement;
    memory_ = memory;
  }

  double step(double dt, double displacement) {
    const double increment = displacement - displacement_;
    displacement_ = displacement;
    double viscous = damping_ / dt * increment;
    for (std::size_t i = 0; i < maxwells_.size(); ++i) {
      viscous += maxwells_[i].step({dt, displacement, increment}, &memory_[i]);
    }
    double friction = 0.0;
    for (const element::BergFriction& berg : bergs_) {
      friction += berg.advance(displacement, memory_.data() + maxwells_.size());
    }
    return stiffness_ * displacement + viscous + friction;
  }

 private:
  double stiffness_;
  double damping_ = 0.0;
  std::vector<element::Maxwell> maxwells_;
  std::vector<element::BergFriction> bergs_;
  std::vector<element::ElementDescription> elements_;
  std::vector<double> memory_;
  double displacement_ = 0.0;
};

/// A component and its laws, led along the same path.
class Pairing {
 public:
  explicit Pairing(std::mt19937& random)
      : random_(random), laws_(random), component_(laws_.elements()), state_(component_.makeState()) {}

  void run(int samples) {
    for (int i = 0; i < samples && !testing::Test::HasFatalFailure(); ++i) {
      disturb();
      changeStep();
      const double displacement = next();
      ASSERT_EQ(component_.step(state_, dt_, displacement).total, laws_.step(dt_, displacement)) << "sample " << i;
      ASSERT_EQ(state_.memory(), laws_.memory()) << "sample " << i;
    }
  }

 private:
  double uniform(double from, double to) { return std::uniform_real_distribution<double>(from, to)(random_); }

  // Now on, now back, now at rest; steps of relaxation from small to complete.
  double next() {
    const double turned = uniform(0.0, 1.0);
    velocity_ = turned < 0.1 ? -velocity_ : turned < 0.15 ? uniform(-1e-4, 1e-4) : velocity_;
    position_ += turned > 0.95 ? 0.0 : velocity_;
    return position_;
  }

  void changeStep() {
    if (uniform(0.0, 1.0) < 0.5) {
      dt_ = std::pow(10.0, uniform(-5.0, 1.0));
    }
  }

  // What a state may go through, each once in a while.
  void disturb() {
    switch (random_() % 60) {
      case 0:
        return restoreNumbers(state_.memory());
      case 1:
        return restoreNumbers(madeUpMemory());
      case 2: {
        const component::ComponentState copy = state_;
        component_.step(state_, dt_, uniform(-1e-3, 1e-3));
        return state_.copyFrom(copy);
      }
      case 3: {
        component::ComponentState other = component_.makeState();
        other.copyFrom(state_);
        std::swap(other, state_);
        return;
      }
      case 4:
        return simulate();
      default:
        return;
    }
  }

  void restoreNumbers(const std::vector<double>& memory) {
    component_.restore(state_, position_, memory);
    laws_.deserialise(position_, memory);
  }

  // Also such as no path leads to: a reference point of friction ahead of the motion.
  std::vector<double> madeUpMemory() {
    std::vector<double> memory = state_.memory();
    for (double& number : memory) {
      number *= uniform(-1.0, 1.0);
    }
    return memory;
  }

  void simulate() {
    std::array<double, 40> path{};
    std::array<double, 40> force{};
    for (double& displacement : path) {
      displacement = next();
    }
    component_.simulate(state_, dt_, path.data(), path.size(), force.data());
    for (std::size_t i = 0; i < path.size(); ++i) {
      ASSERT_EQ(force[i], laws_.step(dt_, path[i])) << "of the simulation";
    }
  }

  std::mt19937& random_;
  LawsOneByOne laws_;
  component::Component component_;
  component::ComponentState state_;
  double dt_ = 1e-3;
  double position_ = 0.0;
  double velocity_ = 1e-5;
};

/// All kinds of instructions that this processor has, one after the other.
class Step : public testing::TestWithParam<processor::Instructions> {
 protected:
  Step() { processor::useAtMost(GetParam()); }
  ~Step() override { processor::useAtMost(processor::Instructions::avx512); }
};

INSTANTIATE_TEST_SUITE_P(With, Step,
                         testing::Values(processor::Instructions::any, processor::Instructions::avx2,
                                         processor::Instructions::avx512));

TEST_P(Step, HasTheBitsOfTheLawsOneByOne) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 200 && !HasFatalFailure(); ++trial) {
    Pairing(random).run(300);
  }
}

}  // namespace
}  // namespace rubber_suspension::test
