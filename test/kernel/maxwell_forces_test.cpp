// Maxwell elements in vectors give the same bits as the separate laws, on any processor.
#include "kernel/maxwell_forces.h"

#include "rubber_suspension/element/maxwell.h"
#include "rubber_suspension/processor/instructions.h"
#include "support/test.h"

namespace rubber_suspension::test {
namespace {

TEST(MaxwellForces, AreTheBitsOfTheLawOnAnyProcessor) {
  constexpr double kStep = 1e-3;   // [s]
  constexpr double kStart = 2e-4;  // [m]
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (const std::size_t samples : {std::size_t{1}, std::size_t{64}, std::size_t{333}}) {
    std::vector<double> displacement(samples);
    for (double& z : displacement) {
      z = 1e-3 * uniform(random);
    }
    for (std::size_t count = 0; count <= 18; ++count) {  // more than two vectors of eight
      element::BasicLaws laws;
      std::vector<element::Maxwell> elements;
      for (std::size_t e = 0; e < count; ++e) {
        elements.emplace_back(1e6 * uniform(random), 0.01 * std::pow(1e6, uniform(random)));
        elements.back().addTo(laws);
      }
      for (const auto instructions :
           {processor::Instructions::any, processor::Instructions::avx2, processor::Instructions::avx512}) {
        processor::useAtMost(instructions);
        std::vector<std::vector<double>> forces(count, std::vector<double>(samples));
        std::vector<double*> to;
        for (std::vector<double>& force : forces) {
          to.push_back(force.data());
        }
        kernel::maxwellForces(laws.maxwells, kStep, kStart, displacement.data(), samples, to);
        for (std::size_t e = 0; e < count; ++e) {
          double memory = 0.0;
          double last = kStart;
          for (std::size_t i = 0; i < samples; ++i) {
            const double increment = displacement[i] - last;
            last = displacement[i];
            ASSERT_EQ(forces[e][i], elements[e].step({kStep, last, increment}, &memory)) << e << " " << i;
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace rubber_suspension::test
