// A loop shared by some threads.
#pragma once

#include <cstddef>
#include <functional>

namespace rubber_suspension::fit {

/// Run body(i) for i in [0, count) on some threads; of several exceptions that of the least i is thrown on, as a plain
/// loop would. Throws io::Cancelled where the calling thread is told to end.
void parallelFor(std::size_t count, int threads, const std::function<void(std::size_t)>& body);

}  // namespace rubber_suspension::fit
