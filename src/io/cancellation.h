// Cancellation of long work by the caller, in the same thread.
#pragma once

#include <functional>
#include <stdexcept>

namespace rubber_suspension::io {

/// The work was cancelled.
class Cancelled : public std::runtime_error {
 public:
  Cancelled() : std::runtime_error("cancelled, because the process ends") {}
};

/// While an object exists, checkCancelled() in the same thread calls its `stop`. A nested object hides the outer one.
class Cancellable {
 public:
  explicit Cancellable(std::function<bool()> stop);
  ~Cancellable();
  Cancellable(const Cancellable&) = delete;
  Cancellable& operator=(const Cancellable&) = delete;

 private:
  friend void checkCancelled();

  const std::function<bool()> stop_;
  const Cancellable* const outer_;
};

/// Throws Cancelled if `stop` of this thread's innermost Cancellable returns true. Long work calls this regularly;
/// without a Cancellable it costs next to nothing.
void checkCancelled();

}  // namespace rubber_suspension::io
