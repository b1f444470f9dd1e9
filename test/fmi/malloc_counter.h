// Counts the calls of malloc and its kin in the whole process, those of libraries with an operator new of their own
// too.
#pragma once

#include <cstddef>

namespace rubber_suspension::fmi::test {

/// Calls since the start of the program; 0 at any time where sanitizers bring an allocator of their own.
std::size_t mallocCalls();

}  // namespace rubber_suspension::fmi::test
