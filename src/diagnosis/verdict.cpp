// Converts verdicts to words and words to verdicts.
#include "rubber_suspension/diagnosis/verdict.h"

#include <algorithm>
#include <array>
#include <ostream>
#include <stdexcept>

namespace rubber_suspension::diagnosis {
namespace {

constexpr std::array kWords = {"none",    "parameter_error", "named",       "confounded",
                               "unknown", "partly",          "check_bench", "defect"};

}  // namespace

std::string toString(Verdict verdict) { return kWords.at(static_cast<std::size_t>(verdict)); }

Verdict verdictOf(const std::string& word) {
  const auto* const found = std::find(kWords.begin(), kWords.end(), word);
  if (found == kWords.end()) {
    throw std::invalid_argument("unknown verdict: " + word);
  }
  return static_cast<Verdict>(found - kWords.begin());
}

std::ostream& operator<<(std::ostream& stream, Verdict verdict) { return stream << toString(verdict); }

bool namesEffects(Verdict verdict) {
  return verdict == Verdict::named || verdict == Verdict::confounded || verdict == Verdict::partly;
}

bool leavesRest(Verdict verdict) { return verdict == Verdict::unknown || verdict == Verdict::partly; }

}  // namespace rubber_suspension::diagnosis
