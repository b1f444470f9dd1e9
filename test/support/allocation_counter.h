// Counts the allocations of a program, including those in its libraries.
#pragma once

#include <cstddef>

namespace rubber_suspension::test {

/// Returns the number of allocations by operator new since the start of the program.
std::size_t allocations();

/// Counts the allocations of all threads since the counter was constructed.
class AllocationCounter {
 public:
  std::size_t count() const { return allocations() - start_; }

 private:
  std::size_t start_ = allocations();
};

}  // namespace rubber_suspension::test
