// A loop whose iterations several threads share.
#include "fit/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#include "io/cancellation.h"

namespace rubber_suspension::fit {

void parallelFor(std::size_t count, int threads, const std::function<void(std::size_t)>& body) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::size_t failed = count;
  std::mutex failure_mutex;
  const auto work = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      try {
        io::checkCancelled();
        body(i);
      } catch (...) {
        const std::lock_guard<std::mutex> lock(failure_mutex);
        if (i < failed) {
          failed = i;
          failure = std::current_exception();
        }
      }
    }
  };
  std::vector<std::thread> workers;
  try {
    for (std::size_t t = 1; t < std::min(count, static_cast<std::size_t>(threads)); ++t) {
      workers.emplace_back(work);
    }
  } catch (const std::system_error&) {
    // If no further thread can be started, the running threads take over its iterations.
  }
  work();
  for (std::thread& worker : workers) {
    worker.join();
  }
  if (failure) {
    std::rethrow_exception(failure);
  }
}

}  // namespace rubber_suspension::fit
