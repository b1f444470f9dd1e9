// A loop whose iterations several threads share.
#pragma once

#include <cstddef>
#include <functional>

namespace rubber_suspension::fit {

/// Runs body(i) for i in [0, count) on several threads. Rethrows the exception of the smallest i, as a plain loop
/// would. Throws io::Cancelled if the calling thread was asked to end.
void parallelFor(std::size_t count, int threads, const std::function<void(std::size_t)>& body);

}  // namespace rubber_suspension::fit
