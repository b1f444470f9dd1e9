// A step of a component gives the same bits as separate steps of its laws, however the state changes in between.
#include "kernel/laws_one_by_one.h"
#include "support/on_any_processor.h"
#include "support/test.h"

namespace rubber_suspension::test {
namespace {

/// Steps a component and its separate laws along the same path.
class Pairing {
 public:
  explicit Pairing(std::mt19937& random)
      : random_(random), laws_(random, 1), path_(random), component_(laws_.entries()), state_(component_.makeState()) {}

  void run(int samples) {
    for (int i = 0; i < samples && !testing::Test::HasFatalFailure(); ++i) {
      disturb();
      const element::Motion motion = path_.next();
      ASSERT_EQ(component_.step(state_, motion.dt, motion.displacement).total, laws_.step(motion).total)
          << "sample " << i;
      ASSERT_EQ(state_.memory(), laws_.memory()) << "sample " << i;
    }
  }

 private:
  // Disturbs the state at random.
  void disturb() {
    switch (random_() % 60) {
      case 0:
        return restoreNumbers(state_.memory());
      case 1:
        return restoreNumbers(madeUp(state_.memory(), path_));
      case 2: {
        const component::ComponentState copy = state_;
        component_.step(state_, path_.dt(), path_.uniform(-1e-3, 1e-3));
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
    component_.restore(state_, path_.displacement(), memory);
    laws_.setMemory(memory);
  }

  void simulate() {
    std::array<double, 40> path{};
    std::array<double, 40> force{};
    for (double& displacement : path) {
      displacement = path_.nextDisplacement();
    }
    double before = state_.displacement();
    component_.simulate(state_, path_.dt(), path.data(), path.size(), force.data());
    for (std::size_t i = 0; i < path.size(); ++i) {
      ASSERT_EQ(force[i], laws_.step({path_.dt(), path[i], path[i] - before}).total) << "of the simulation";
      before = path[i];
    }
  }

  std::mt19937& random_;
  LawsOneByOne laws_;
  RandomPath path_;
  component::Component component_;
  component::ComponentState state_;
};

class Step : public OnAnyProcessor {};
INSTANTIATE_TEST_SUITE_P(With, Step, anyInstructions());

TEST_P(Step, HasTheBitsOfTheLawsOneByOne) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 200 && !HasFatalFailure(); ++trial) {
    Pairing(random).run(300);
  }
}

}  // namespace
}  // namespace rubber_suspension::test
