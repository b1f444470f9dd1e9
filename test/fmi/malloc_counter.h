// Counts the calls of malloc, calloc and realloc in the whole process, with those of libraries that have their own
// operator new.
#pragma once

#include <cstddef>

namespace rubber_suspension::fmi::test {

/// Returns the calls since the start of the program; always 0 if sanitizers replace the allocator.
std::size_t mallocCalls();

}  // namespace rubber_suspension::fmi::test
