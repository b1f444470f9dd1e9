// Writes drive files for rigs in the format RPC III of MTS. The reader is declared in file_readers.h.
#pragma once

#include <string>
#include <vector>

namespace rubber_suspension::log {

struct RpcChannel {
  std::string name;  ///< at most 95 bytes are written
  std::string unit;  ///< at most 95 bytes are written
  std::vector<double> values;
};

/// Returns the content of an RPC III file: a time history in single precision with these channels, which must have the
/// same length, at time steps of `dt` [s]. Rigs play whole frames, so the last value of a channel is repeated to the
/// end of its last frame. Throws std::invalid_argument if there are no samples or the lengths differ.
std::string rpcFile(double dt, const std::vector<RpcChannel>& channels);

}  // namespace rubber_suspension::log
