// Writes drive files of rigs in RPC III of MTS; file_readers.h has their reader.
#pragma once

#include <string>
#include <vector>

namespace rubber_suspension::log {

/// A channel of a drive file.
struct RpcChannel {
  std::string name;  ///< at most 95 bytes of it are written
  std::string unit;  ///< likewise
  std::vector<double> values;
};

/// Returns the content of a file: a time history of single precision with these channels, all of one length, at steps
/// of `dt` [s]. Rigs play whole frames, so each channel repeats its last value up to the end of its last frame. Throws
/// std::invalid_argument for no samples or lengths that differ.
std::string rpcFile(double dt, const std::vector<RpcChannel>& channels);

}  // namespace rubber_suspension::log
