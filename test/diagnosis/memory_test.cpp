// Logs that need more memory than the computer has are refused before the search.
#include "diagnosis/prepare/memory.h"

#include "rig.h"
#include "rubber_suspension/diagnosis/diagnosis.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

constexpr std::uint64_t kGibibyte = std::uint64_t{1} << 30U;

constexpr std::size_t kRecorded = 20000000;

std::string refusal(std::size_t samples, std::uint64_t available) {
  return messageOf<log::LogError>([&] { diagnosis::prepare::requireMemory({samples, 5}, kRecorded, 2, available); });
}

TEST(MemoryOfADiagnosis, IsRefusedOnceItIsMoreThanThereIs) {
  constexpr std::size_t kSamples = 1000000;
  const std::uint64_t needed = diagnosis::prepare::memoryNeeded({kSamples, 5}, 2);
  EXPECT_EQ(refusal(kSamples, needed), "");
  EXPECT_NE(refusal(kSamples, needed - 1), "");
  EXPECT_NE(refusal(kSamples + 1, needed), "");
  EXPECT_NE(refusal(1, 0), "");
  EXPECT_GT(diagnosis::prepare::memoryNeeded({kSamples, 5}, 8), needed);
  EXPECT_GT(diagnosis::prepare::memoryNeeded({kSamples, 1000}, 2), needed);
}

TEST(MemoryOfADiagnosis, TheRefusalSaysHowMuchIsNeededAndWhatIsAccepted) {
  const std::string text = refusal(12000000, 16 * kGibibyte);
  EXPECT_THAT(text, testing::HasSubstr("12000000 of 20000000 samples"));
  EXPECT_THAT(text, testing::HasSubstr("40.9 GiB"));
  EXPECT_THAT(text, testing::HasSubstr("16.0 GiB are available"));
  EXPECT_THAT(text, testing::HasSubstr("accepted: at most 4665768 samples"));
  EXPECT_EQ(text.find('\n'), std::string::npos);
  EXPECT_EQ(refusal(4665768, 16 * kGibibyte), "");
}

TEST(MemoryOfADiagnosis, IsAskedForBeforeTheSearch) {
  const std::vector<log::Log> logs = {runRig("a", 1, nothing)};
  const std::size_t both = 2 * logs.front().size();  // one of the two is held out
  diagnosis::DiagnosisOptions options;
  options.available_memory = diagnosis::prepare::memoryNeeded({both, 1}, options.threads) - 1;
  options.progress = [](const std::string&, double) { FAIL() << "the search has begun"; };
  EXPECT_THROW(diagnosis::diagnose(rigComponent(), logs, logs, options), log::LogError);
}

}  // namespace
}  // namespace rubber_suspension
