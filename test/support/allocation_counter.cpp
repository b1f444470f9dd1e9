// Replaces the global operators new and delete by operators that count.
#include "support/allocation_counter.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::size_t> counter{0};

}  // namespace

std::size_t rubber_suspension::test::allocations() { return counter; }

// Sanitizers have operators of their own, so allocations are not counted with sanitizers.
#if defined(__has_feature)
#if __has_feature(thread_sanitizer) || __has_feature(address_sanitizer)
#define RUBBER_SUSPENSION_UNCOUNTED
#endif
#endif

#ifndef RUBBER_SUSPENSION_UNCOUNTED
void* operator new(std::size_t size) {
  ++counter;
  if (void* block = std::malloc(size == 0 ? 1 : size)) {
    return block;
  }
  throw std::bad_alloc();
}
void* operator new[](std::size_t size) { return operator new(size); }
void operator delete(void* block) noexcept { std::free(block); }
void operator delete[](void* block) noexcept { std::free(block); }
void operator delete(void* block, std::size_t /*size*/) noexcept { std::free(block); }
void operator delete[](void* block, std::size_t /*size*/) noexcept { std::free(block); }
#endif
