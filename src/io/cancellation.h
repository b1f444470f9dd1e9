// Cancellation of long work by the caller, in the same thread.
#pragma once

#include <functional>
#include <stdexcept>

namespace rubber_suspension::io {

class Cancelled : public std::runtime_error {
 public:
  Cancelled() : std::runtime_error("cancelled, because the process ends") {}
};

/// While an object exists, checkCancelled() in the same thread calls its `stop`. Of nested objects, it asks the
/// innermost.
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

/// Throws Cancelled if `stop` of this thread's innermost Cancellable returns true. Long work calls this regularly.
/// Without a Cancellable the call takes almost no time.
void checkCancelled();

}  // namespace rubber_suspension::io
