// A short soak test: 400,000 samples as fast as the node answers, with one force each and constant memory.
#include "bench.h"
#include "benchmark/latency/latency_benchmark.h"

namespace rubber_suspension {
namespace {

TEST(Soak, EverySampleHasItsForceAndMemoryStays) {
  constexpr std::uint64_t kSamples = 400000;
  const benchmark::SoakResult result = benchmark::soak(kSamples, 4, [](const std::string&) {});
  EXPECT_EQ(result.sent, kSamples);
  EXPECT_EQ(result.answered, result.sent);
  EXPECT_EQ(result.surplus, 0U);
  // Buffers and queues reach their final size in the first tenth. A leak of eight bytes per later sample is 2.9 MB.
  ASSERT_EQ(result.memory.size(), 100U);
  ASSERT_GT(result.memory[9], 0);
  EXPECT_LT(result.memory.back() - result.memory[9], 1500000);
}

}  // namespace
}  // namespace rubber_suspension

int main(int argc, char** argv) { return rubber_suspension::runAsNode(argc, argv, "soak"); }
