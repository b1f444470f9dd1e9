// The list of candidate effects.
#include "diagnosis/hypotheses/candidate/registry.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "element/each.h"

namespace rubber_suspension::diagnosis::hypotheses::candidate {
namespace {

using Entry = std::pair<int, CandidateFactory>;

// Made when the first effect enters itself, whatever the order in which the files' static objects are made.
std::vector<Entry>& entries() {
  static std::vector<Entry> list;
  return list;
}

std::vector<Entry> inOrder() {
  std::vector<Entry> list = entries();
  std::sort(list.begin(), list.end(), [](const Entry& a, const Entry& b) { return a.first < b.first; });
  const auto twice =
      std::adjacent_find(list.begin(), list.end(), [](const Entry& a, const Entry& b) { return a.first == b.first; });
  if (twice != list.end()) {
    throw std::logic_error("two candidate effects claim place " + std::to_string(twice->first));
  }
  return list;
}

}  // namespace

CandidateEntry::CandidateEntry(int place, CandidateFactory factory) { entries().emplace_back(place, factory); }

std::vector<fit::Candidate> candidates(const fit::Excitation& excitation) {
  return element::each(inOrder(), [&](const Entry& entry) { return entry.second(excitation); });
}

}  // namespace rubber_suspension::diagnosis::hypotheses::candidate
