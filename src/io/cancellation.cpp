// Cancellation of long work.
#include "io/cancellation.h"

#include <utility>

namespace rubber_suspension::io {
namespace {

thread_local const Cancellable* innermost = nullptr;

}  // namespace

Cancellable::Cancellable(std::function<bool()> stop) : stop_(std::move(stop)), outer_(innermost) { innermost = this; }

Cancellable::~Cancellable() { innermost = outer_; }

void checkCancelled() {
  if (innermost != nullptr && innermost->stop_ && innermost->stop_()) {
    throw Cancelled();
  }
}

}  // namespace rubber_suspension::io
