// The kernel of springs, dashpots, Maxwell elements and Berg friction against their laws one by one: the same bits.
#include "rubber_suspension/kernel/basic_laws_kernel.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "rubber_suspension/element/berg_friction.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/element/dashpot.h"
#include "rubber_suspension/element/maxwell.h"
#include "rubber_suspension/element/spring.h"
#include "rubber_suspension/processor/instructions.h"
#include "support/allocation_counter.h"

namespace rubber_suspension::test {
namespace {

/// The laws, each stepped by itself through the interface that all laws have.
class LawsOneByOne {
 public:
  explicit LawsOneByOne(std::mt19937& random) {
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    spring_ = std::make_unique<element::Spring>(3e6 * uniform(random));
    if (uniform(random) < 0.5) {
      dashpot_ = std::make_unique<element::Dashpot>(1e4 * uniform(random));
    }
    const std::size_t maxwells = random() % 21;  // up to two blocks of eight, and some
    for (std::size_t i = 0; i < maxwells; ++i) {
      maxwells_.emplace_back(1e6 * uniform(random), 0.01 * std::pow(1e5, uniform(random)));
    }
    const std::size_t frictions = random() % 4;
    for (std::size_t i = 0; i < frictions; ++i) {
      const double dead_band = uniform(random) < 0.5 ? 2e-4 * uniform(random) : 0.0;
      frictions_.emplace_back(1e4 * uniform(random), 2e-3 * uniform(random), dead_band);
    }
    memory_.resize(maxwells + frictions * element::BergFriction::kMemorySize);
  }

  element::BasicLaws numbers() const {
    element::BasicLaws sum;
    EXPECT_TRUE(spring_->addTo(sum));
    EXPECT_TRUE(dashpot_ == nullptr || dashpot_->addTo(sum));
    for (const element::Maxwell& maxwell : maxwells_) {
      EXPECT_TRUE(maxwell.addTo(sum));
    }
    for (const element::BergFriction& friction : frictions_) {
      EXPECT_TRUE(friction.addTo(sum));
    }
    return sum;
  }

  const std::vector<double>& memory() const { return memory_; }
  void setMemory(const std::vector<double>& memory) { memory_ = memory; }

  element::ComponentForce initialise(double displacement) {
    element::ComponentForce force;
    force.elastic = force.total = spring_->initialise(displacement, nullptr);
    double* memory = memory_.data();
    for (const element::Maxwell& maxwell : maxwells_) {
      force.viscous += maxwell.initialise(displacement, memory++);
    }
    for (const element::BergFriction& friction : frictions_) {
      force.friction += friction.initialise(displacement, memory);
      memory += element::BergFriction::kMemorySize;
    }
    return force;
  }

  element::ComponentForce step(const element::Motion& motion) {
    element::ComponentForce force;
    force.elastic = spring_->step(motion, nullptr);
    // The gain c/dt times the increment, as the sum has it, and not c times the rate: the last bit may differ.
    force.viscous = dashpot_ == nullptr ? 0.0 : dashpot_->damping() / motion.dt * motion.increment;
    double* memory = memory_.data();
    for (const element::Maxwell& maxwell : maxwells_) {
      force.viscous += maxwell.step(motion, memory++);
    }
    for (const element::BergFriction& friction : frictions_) {
      force.friction += friction.step(motion, memory);
      memory += element::BergFriction::kMemorySize;
    }
    force.total = force.elastic + force.viscous + force.friction;
    return force;
  }

 private:
  std::unique_ptr<element::Spring> spring_;
  std::unique_ptr<element::Dashpot> dashpot_;
  std::vector<element::Maxwell> maxwells_;
  std::vector<element::BergFriction> frictions_;
  std::vector<double> memory_;
};

void expectSame(const element::ComponentForce& one, const element::ComponentForce& other) {
  ASSERT_EQ(one.total, other.total);
  ASSERT_EQ(one.elastic, other.elastic);
  ASSERT_EQ(one.viscous, other.viscous);
  ASSERT_EQ(one.friction, other.friction);
}

/// A path that goes on for a while, reverses, rests and jitters; steps from small to far beyond all relaxation times,
/// often alike.
class RandomPath {
 public:
  explicit RandomPath(std::mt19937& random) : random_(random) {}

  double uniform(double from, double to) { return std::uniform_real_distribution<double>(from, to)(random_); }

  double nextDisplacement() {
    const double kind = uniform(0.0, 1.0);
    velocity_ = kind < 0.1 ? -velocity_ : kind < 0.15 ? uniform(-1e-4, 1e-4) : velocity_;
    displacement_ += kind > 0.95 ? 0.0 : velocity_ + (kind > 0.9 ? uniform(-2e-5, 2e-5) : 0.0);
    return displacement_;
  }

  element::Motion next() {
    if (uniform(0.0, 1.0) < 0.3) {
      dt_ = std::pow(10.0, uniform(-5.0, 1.0));
    }
    const double before = displacement_;
    const double displacement = nextDisplacement();
    return {dt_, displacement, displacement - before};
  }

  double dt() const { return dt_; }
  double displacement() const { return displacement_; }

 private:
  std::mt19937& random_;
  double dt_ = 1e-3;
  double displacement_ = 0.0;
  double velocity_ = 1e-5;
};

/// Laws and their kernel, led along the same path.
class Pair {
 public:
  explicit Pair(std::mt19937& random) : laws_(random), path_(random), kernel_(laws_.numbers()) {
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

  /// A memory that no path leads to, such as a reference point of friction ahead of the motion.
  void makeUpMemory() {
    for (double& number : memory_) {
      number *= path_.uniform(-1.0, 1.0);
    }
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

/// All kinds of instructions that this processor has, one after the other.
class BasicLawsKernel : public testing::TestWithParam<processor::Instructions> {
 protected:
  BasicLawsKernel() { processor::useAtMost(GetParam()); }
  ~BasicLawsKernel() override { processor::useAtMost(processor::Instructions::avx512); }
};

INSTANTIATE_TEST_SUITE_P(With, BasicLawsKernel,
                         testing::Values(processor::Instructions::any, processor::Instructions::avx2,
                                         processor::Instructions::avx512));

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
      pair.simulate(random() % (i % 2 == 0 ? 70 : 1500));  // about blocks of 32, and about their portions of 512
    }
  }
}

// Forces of trial steps, which the series balance is solved with: the linear part is summed in another order, so that
// some roundings of its largest term may differ.
TEST_P(BasicLawsKernel, SplitsTheForceIntoALinearPartAndFriction) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 200; ++trial) {
    LawsOneByOne laws(random);
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
  // On along the branch: the closed form; back: none, as the branch would be another.
  const auto on = kernel.balance(kSlope, -3e-3, kCompliance, memory.data());
  ASSERT_TRUE(on);
  EXPECT_NEAR(kSlope * *on - 3e-3 + kCompliance * kernel.frictionAt(*on, memory.data()), 0.0, 1e-17);
  EXPECT_FALSE(kernel.balance(kSlope, 3e-3, kCompliance, memory.data()));
}

TEST_P(BasicLawsKernel, AllocatesNothing) {
  std::mt19937 random(4);
  const LawsOneByOne laws(random);
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
  const element::Spring spring(3e6);
  const element::Dashpot dashpot(1e4);
  const element::Maxwell maxwell(1.3e6, 1.43);
  ASSERT_TRUE(spring.addTo(sum) && dashpot.addTo(sum) && maxwell.addTo(sum));
  const std::complex<double> expected =
      *spring.complexStiffness(kOmega) + *dashpot.complexStiffness(kOmega) + *maxwell.complexStiffness(kOmega);
  EXPECT_LE(std::abs(*kernel::BasicLawsKernel(sum).complexStiffness(kOmega) / expected - 1.0), 1e-15);
  sum.frictions.push_back({5e3, 1e-3, 0.0});
  EXPECT_FALSE(kernel::BasicLawsKernel(sum).complexStiffness(kOmega));
}

}  // namespace
}  // namespace rubber_suspension::test
