// The kernel of springs, dashpots, Maxwell elements and Berg friction gives the same bits as the separate laws.
#include "rubber_suspension/kernel/basic_laws_kernel.h"

#include "kernel/laws_one_by_one.h"
#include "rubber_suspension/element/berg_friction.h"
#include "support/allocation_counter.h"
#include "support/on_any_processor.h"
#include "support/test.h"

namespace rubber_suspension::test {
namespace {

void expectSame(const element::ComponentForce& one, const element::ComponentForce& other) {
  ASSERT_EQ(one.total, other.total);
  ASSERT_EQ(one.elastic, other.elastic);
  ASSERT_EQ(one.viscous, other.viscous);
  ASSERT_EQ(one.friction, other.friction);
}

/// Separate laws and their kernel, moved along the same path.
class Pair {
 public:
  explicit Pair(std::mt19937& random) : laws_(random, 3), path_(random), kernel_(laws_.numbers()) {
    memory_.resize(kernel_.memorySize());
    prepared_ = kernel_.makePreparedStep();
    expectSame(kernel_.initialise(0.0, memory_.data()), laws_.initialise(0.0));
  }

  void step() {
    const element::Motion motion = path_.next();
    expectSame(kernel_.step(motion.dt, motion.displacement, motion.increment, memory_.data(), prepared_),
               laws_.step(motion));
    ASSERT_EQ(memory_, laws_.memory());
  }

  void stepWithoutBranch() {
    const element::Motion motion = path_.next();
    kernel_.prepare(motion.dt, prepared_);
    expectSame(kernel_.stepWithoutBranch(motion, memory_.data(), prepared_), laws_.step(motion));
    ASSERT_EQ(memory_, laws_.memory());
    prepared_.branch = {};
  }

  void simulate(std::size_t samples) {
    const double start = path_.displacement();
    std::vector<double> displacement(samples);
    std::vector<double> force(samples);
    for (double& z : displacement) {
      z = path_.nextDisplacement();
    }
    kernel_.simulate(path_.dt(), start, displacement.data(), samples, force.data(), memory_.data(), prepared_);
    double before = start;
    for (std::size_t i = 0; i < samples; ++i) {
      ASSERT_EQ(force[i], laws_.step({path_.dt(), displacement[i], displacement[i] - before}).total)
          << "sample " << i << " of " << samples;
      before = displacement[i];
    }
    ASSERT_EQ(memory_, laws_.memory());
  }

  void makeUpMemory() {
    memory_ = madeUp(memory_, path_);
    laws_.setMemory(memory_);
    prepared_.branch = {};
  }

 private:
  LawsOneByOne laws_;
  RandomPath path_;
  kernel::BasicLawsKernel kernel_;
  std::vector<double> memory_;
  kernel::PreparedStep prepared_;
};

class BasicLawsKernel : public OnAnyProcessor {};
INSTANTIATE_TEST_SUITE_P(With, BasicLawsKernel, anyInstructions());

TEST_P(BasicLawsKernel, HasTheBitsOfItsLawsStepByStep) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 200 && !HasFatalFailure(); ++trial) {
    Pair pair(random);
    for (int i = 0; i < 300 && !HasFatalFailure(); ++i) {
      if (random() % 60 == 0) {
        pair.makeUpMemory();
      }
      random() % 40 == 0 ? pair.stepWithoutBranch() : pair.step();
    }
  }
}

TEST_P(BasicLawsKernel, HasTheBitsOfItsLawsOverLogs) {
  std::mt19937 random(2);
  for (int trial = 0; trial < 100 && !HasFatalFailure(); ++trial) {
    Pair pair(random);
    for (int i = 0; i < 6 && !HasFatalFailure(); ++i) {
      pair.step();
      pair.simulate(random() % (i % 2 == 0 ? 70 : 1500));  // lengths around blocks of 32 and around portions of 512
    }
  }
}

// The solver for components in series uses these forces of trial steps. The linear part is summed in another order, so
// it may differ by some roundings of its largest term.
TEST_P(BasicLawsKernel, SplitsTheForceIntoALinearPartAndFriction) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 200; ++trial) {
    LawsOneByOne laws(random, 3);
    RandomPath path(random);
    const kernel::BasicLawsKernel kernel(laws.numbers());
    kernel::PreparedStep prepared = kernel.makePreparedStep();
    laws.initialise(0.0);
    for (int i = 0; i < 20; ++i) {
      laws.step(path.next());
    }
    const double start = path.displacement();
    const element::Motion motion = path.next();
    kernel.prepare(motion.dt, prepared);
    const kernel::LinearForce linear = kernel.withoutFriction(start, laws.memory().data(), prepared);
    const double friction = kernel.frictionAt(motion.displacement, laws.memory().data());
    const element::ComponentForce force = laws.step(motion);
    const double largest = std::abs(linear.slope) * (std::abs(start) + std::abs(motion.displacement)) +
                           std::abs(force.elastic) + std::abs(force.viscous);
    EXPECT_EQ(friction, force.friction) << trial;
    EXPECT_NEAR(linear.at(motion.displacement), force.elastic + force.viscous, 1e-14 * largest) << trial;
  }
}

TEST_P(BasicLawsKernel, BalancesInClosedForm) {
  constexpr double kSlope = 1.3;        // [-]
  constexpr double kCompliance = 1e-7;  // [m/N]
  const kernel::BasicLawsKernel kernel({0.0, 0.0, {}, {{5e3, 1e-3, 0.0}}});
  kernel::PreparedStep prepared = kernel.makePreparedStep();
  std::array<double, element::BergFriction::kMemorySize> memory{};
  kernel.initialise(0.0, memory.data());
  kernel.step(1e-3, 1e-3, 1e-3, memory.data(), prepared);
  // Continuing along the branch has a closed form. A reversal begins another branch, so the kernel returns no solution.
  const auto on = kernel.balance(kSlope, -3e-3, kCompliance, memory.data());
  ASSERT_TRUE(on);
  EXPECT_NEAR(kSlope * *on - 3e-3 + kCompliance * kernel.frictionAt(*on, memory.data()), 0.0, 1e-17);
  EXPECT_FALSE(kernel.balance(kSlope, 3e-3, kCompliance, memory.data()));
}

TEST_P(BasicLawsKernel, AllocatesNothing) {
  std::mt19937 random(4);
  const LawsOneByOne laws(random, 3);
  const kernel::BasicLawsKernel kernel(laws.numbers());
  kernel::PreparedStep prepared = kernel.makePreparedStep();
  std::vector<double> memory(kernel.memorySize());
  std::vector<double> displacement(1000, 1e-3);
  std::vector<double> force(1000);
  const AllocationCounter counter;
  kernel.initialise(0.0, memory.data());
  kernel.step(1e-3, 1e-3, 1e-3, memory.data(), prepared);
  kernel.step(1e-3, -1e-3, -2e-3, memory.data(), prepared);
  kernel.simulate(2e-3, -1e-3, displacement.data(), displacement.size(), force.data(), memory.data(), prepared);
  EXPECT_EQ(counter.count(), 0U);
}

TEST(BasicLawsKernelStiffness, IsTheSumOfThoseOfItsLaws) {
  constexpr double kOmega = 2.0 * element::kPi * 4.0;
  element::BasicLaws sum;
  std::complex<double> expected = 0.0;
  for (const auto& description : {spring(3e6), dashpot(1e4), maxwell(1.3e6, 1.43)}) {
    const Law law = lawOf(description);
    ASSERT_TRUE(law->addTo(sum));
    expected += *law->complexStiffness(kOmega);
  }
  EXPECT_LE(std::abs(*kernel::BasicLawsKernel(sum).complexStiffness(kOmega) / expected - 1.0), 1e-15);
  sum.frictions.push_back({5e3, 1e-3, 0.0});
  EXPECT_FALSE(kernel::BasicLawsKernel(sum).complexStiffness(kOmega));
}

}  // namespace
}  // namespace rubber_suspension::test
