// Counts the calls of malloc, calloc and realloc in the process, including calls by libraries with an operator new of
// their own.
#pragma once

#include <cstddef>

namespace rubber_suspension::fmi::test {

/// Returns the number of calls since the start of the program. Always returns 0 if sanitizers replace the allocator.
std::size_t mallocCalls();

}  // namespace rubber_suspension::fmi::test
