// Rows whose two sides leave series of forces, which have to be the same.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "benchmark/measurement.h"
#include "benchmark/test_signal.h"

namespace rubber_suspension::benchmark {

/// The two sides of a row work on a bench and leave forces [N] in its members `library` and `bare`; each step of the
/// row is one of them.
template <class Bench, class Library, class Bare>
Case forceCase(const std::shared_ptr<Bench>& bench, const std::string& name, Library library,
               const std::string& baseline, Bare bare) {
  Case result;
  result.name = name;
  result.baseline = baseline;
  result.unit = "step";
  result.count = result.baseline_count = static_cast<double>(bench->library.size());
  result.bare = [bench, bare] { std::invoke(bare, *bench); };
  result.library = [bench, library] { std::invoke(library, *bench); };
  result.error = [bench] { return relativeDifference(bench->bare, bench->library); };
  result.error_meaning = "of the largest force";
  // Both sum the same products in another order: some roundings per step, which relaxation and friction forget.
  result.tolerance = 1e-11;
  return result;
}

}  // namespace rubber_suspension::benchmark
