// Simulating several laws of stress softening at once agrees with the separate laws.
#include "kernel/softening_bank.h"

#include "rubber_suspension/element/catalogue.h"
#include "rubber_suspension/processor/instructions.h"
#include "support/kit.h"

namespace rubber_suspension::test {
namespace {

using Effect = std::shared_ptr<const element::ForceEffect>;

element::ElementDescription randomLaw(std::mt19937& random) {
  const auto between = [&](double low, double high) {
    return low * std::pow(high / low, std::uniform_real_distribution<double>(0.0, 1.0)(random));
  };
  element::ElementDescription law{"stress_softening",
                                  {{"reduction", {between(0.01, 0.9)}},
                                   {"width", {between(0.01, 10.0)}},
                                   {"reach_exponent", {static_cast<double>(random() % 3)}},
                                   {"full_reach", {between(1e-3, 1e-2)}},
                                   {"ratio_power", {static_cast<double>(1 + random() % 2)}},
                                   {"side", {static_cast<double>(random() % 3) - 1.0}}}};
  if (random() % 2 == 0) {
    law.values["path"] = {between(1e-6, 1.0)};
  }
  if (random() % 2 == 0) {
    law.values["recovery_time"] = {between(1e-5, 1e3)};
  }
  return element::complete(law);
}

// Computes the product of the factors over a random walk with rests, with the bank and with its laws.
void walk(unsigned seed, std::vector<double>& by_bank, std::vector<double>& by_laws) {
  std::mt19937 random(seed);
  kernel::SofteningBank bank;
  std::vector<Effect> laws;
  for (std::size_t count = 1 + random() % 20; laws.size() < count;) {
    const element::ElementDescription law = randomLaw(random);
    laws.push_back(std::get<Effect>(element::makeElement(law)));
    ASSERT_TRUE(kernel::SofteningBank::takes(law));
    bank.add(law, laws.back());
  }
  std::vector<double> of_bank(bank.memorySize());
  std::vector<double> of_laws(of_bank.size());
  bank.initialise(0.0, of_bank.data());
  bank.initialise(0.0, of_laws.data());
  std::normal_distribution<double> normal;
  double last = 0.0;
  for (int i = 0; i < 300; ++i) {
    const double increment = i % 50 == 0 ? -last : 5e-4 * normal(random);
    last += increment;
    const element::Motion motion{i % 70 == 0 ? 100.0 : 1e-3, last, increment};
    by_bank.push_back(bank.step(motion, {}, of_bank.data()));
    by_laws.push_back(1.0);
    for (std::size_t j = 0; j < laws.size(); ++j) {
      by_laws.back() *= laws[j]->step(motion, {}, of_laws.data() + 2 * j);
    }
  }
}

TEST(SofteningBank, IsItsLawsButForRoundingOnAnyProcessor) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    std::vector<double> of_any;
    for (const auto most :
         {processor::Instructions::any, processor::Instructions::avx2, processor::Instructions::avx512}) {
      processor::useAtMost(most);
      std::vector<double> by_bank;
      std::vector<double> by_laws;
      walk(seed, by_bank, by_laws);
      of_any = of_any.empty() ? by_bank : of_any;
      EXPECT_EQ(by_bank, of_any) << seed << ": the same bits";
      for (std::size_t i = 0; i < by_laws.size(); ++i) {
        ASSERT_NEAR(by_bank[i], by_laws[i], 1e-13) << seed << ", step " << i;
      }
    }
  }
}

TEST(SofteningBank, LeavesOtherLawsAlone) {
  element::ElementDescription law = entry("stress_softening reduction=0.3 ratio_power=3");
  EXPECT_FALSE(kernel::SofteningBank::takes(element::complete(law)));
  EXPECT_FALSE(
      kernel::SofteningBank::takes(element::complete(entry("self_heating energy_sensitivity=1e-3 time_constant=40"))));
}

}  // namespace
}  // namespace rubber_suspension::test
