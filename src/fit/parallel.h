// A loop shared by some threads.
#pragma once

#include <cstddef>
#include <functional>

namespace rubber_suspension::fit {

/// Runs body(i) for i in [0, count) on some threads. Rethrows the exception of the least i, as a plain loop would.
/// Throws io::Cancelled if the calling thread is to end.
void parallelFor(std::size_t count, int threads, const std::function<void(std::size_t)>& body);

}  // namespace rubber_suspension::fit
