// Basic laws with random parameters, stepped separately through the common interface of laws, and random paths.
#pragma once

#include "element/driver.h"
#include "support/test.h"

namespace rubber_suspension::test {

/// A spring, at most one dashpot, up to 20 Maxwell elements (more than two blocks of 8), and some friction elements.
class LawsOneByOne {
 public:
  LawsOneByOne(std::mt19937& random, unsigned most_frictions) {
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    add(spring(3e6 * uniform(random)));
    if (uniform(random) < 0.5) {
      add(dashpot(1e4 * uniform(random)));
    }
    for (std::size_t count = random() % 21; count > 0; --count) {
      const double stiffness = 1e6 * uniform(random);
      add(maxwell(stiffness, 0.01 * std::pow(1e5, uniform(random))));
    }
    for (std::size_t count = random() % (most_frictions + 1); count > 0; --count) {
      const double dead_band = uniform(random) < 0.5 ? 2e-4 * uniform(random) : 0.0;
      const double maximum_force = 1e4 * uniform(random);
      add(friction(maximum_force, 2e-3 * uniform(random), dead_band));
    }
  }

  const Entries& entries() const { return entries_; }
  const std::vector<double>& memory() const { return memory_; }
  void setMemory(const std::vector<double>& memory) { memory_ = memory; }

  element::BasicLaws numbers() const {
    element::BasicLaws sum;
    for (const Law& law : laws_) {
      EXPECT_TRUE(law->addTo(sum));
    }
    return sum;
  }

  element::ComponentForce initialise(double displacement) {
    return sumOf(
        [&](const element::ParallelElement& law, double* memory) { return law.initialise(displacement, memory); });
  }

  element::ComponentForce step(const element::Motion& motion) {
    return sumOf([&](const element::ParallelElement& law, double* memory) { return law.step(motion, memory); },
                 &motion);
  }

 private:
  void add(const element::ElementDescription& description) {
    entries_.push_back(description);
    laws_.push_back(lawOf(description));
    memory_.resize(memory_.size() + laws_.back()->memorySize());
  }

  template <class Action>
  element::ComponentForce sumOf(const Action& action, const element::Motion* motion = nullptr) {
    element::ComponentForce force;
    double* memory = memory_.data();
    for (std::size_t i = 0; i < laws_.size(); ++i) {
      // The kernel multiplies the gain c/dt by the increment. This may differ in the last bit from c times the rate.
      const bool is_gain = motion != nullptr && entries_[i].type == "dashpot";
      const double own =
          is_gain ? entries_[i].value("damping") / motion->dt * motion->increment : action(*laws_[i], memory);
      memory += laws_[i]->memorySize();
      (laws_[i]->part() == element::Part::elastic   ? force.elastic
       : laws_[i]->part() == element::Part::viscous ? force.viscous
                                                    : force.friction) += own;
    }
    force.total = force.elastic + force.viscous + force.friction;
    return force;
  }

  Entries entries_;
  std::vector<Law> laws_;
  std::vector<double> memory_;
};

/// A path that continues, reverses, rests and jitters. Time steps range from short ones to far more than all relaxation
/// times, and are often equal.
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

/// Returns a memory that no path leads to, for example with a reference point of friction ahead of the motion.
inline std::vector<double> madeUp(std::vector<double> memory, RandomPath& path) {
  for (double& number : memory) {
    number *= path.uniform(-1.0, 1.0);
  }
  return memory;
}

}  // namespace rubber_suspension::test
