// Counts the allocations of a program, those of the libraries that it loads too.
#pragma once

#include <cstddef>

namespace rubber_suspension::test {

/// Allocations by operator new since the start of the program.
std::size_t allocations();

/// Allocations since construction, by any thread.
class AllocationCounter {
 public:
  std::size_t count() const { return allocations() - start_; }

 private:
  std::size_t start_ = allocations();
};

}  // namespace rubber_suspension::test
