// Long work that may be told to end early, by whoever began it in the same thread.
#pragma once

#include <functional>
#include <stdexcept>

namespace rubber_suspension::io {

/// Work that was told to end.
class Cancelled : public std::runtime_error {
 public:
  Cancelled() : std::runtime_error("cancelled, because the process ends") {}
};

/// While it exists, checkCancelled() of this thread asks `stop`. One within another takes its place.
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

/// To be called now and then by long work: throws Cancelled where it is to end. Costs next to nothing where nobody
/// asks.
void checkCancelled();

}  // namespace rubber_suspension::io
