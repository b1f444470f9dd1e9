// Compiles the file RUBBER_SUSPENSION_KERNELS once for each kind of processor, each time in its own namespace within
// that of RUBBER_SUSPENSION_LAYER. The portable binary contains all versions and chooses one at run time. Fast parts of
// this file must not call inline functions from other headers, which are compiled for any processor.
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#include "rubber_suspension/processor/instructions.h"

namespace rubber_suspension::RUBBER_SUSPENSION_LAYER::any {
constexpr std::size_t kWidth = 2;
#include RUBBER_SUSPENSION_KERNELS
}  // namespace rubber_suspension::RUBBER_SUSPENSION_LAYER::any

#ifdef __x86_64__

#ifdef __clang__
#pragma clang attribute push(__attribute__((target("avx2"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2")
#endif
namespace rubber_suspension::RUBBER_SUSPENSION_LAYER::avx2 {
constexpr std::size_t kWidth = 4;
#include RUBBER_SUSPENSION_KERNELS
}  // namespace rubber_suspension::RUBBER_SUSPENSION_LAYER::avx2
#ifdef __clang__
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif

#ifdef __clang__
#pragma clang attribute push(__attribute__((target("avx512f"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx512f")
#endif
namespace rubber_suspension::RUBBER_SUSPENSION_LAYER::avx512 {
constexpr std::size_t kWidth = 8;
#include RUBBER_SUSPENSION_KERNELS
}  // namespace rubber_suspension::RUBBER_SUSPENSION_LAYER::avx512
#ifdef __clang__
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif

namespace rubber_suspension::processor {

template <class Kernel>
Kernel* chosen(Kernel* any, Kernel* avx2, Kernel* avx512) {
  const Instructions instructions = instructionsInUse();
  return instructions == Instructions::avx512 ? avx512 : instructions == Instructions::avx2 ? avx2 : any;
}

}  // namespace rubber_suspension::processor

/// The version of a kernel for the instructions in use.
#define RUBBER_SUSPENSION_KERNEL(name) ::rubber_suspension::processor::chosen(any::name, avx2::name, avx512::name)
#else
#define RUBBER_SUSPENSION_KERNEL(name) any::name
#endif
