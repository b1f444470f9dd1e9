// One reader of HDF5 at a time: the library, on which files of MATLAB's level 7.3 rest too, is not safe for threads in
// every build.
#pragma once

#include <mutex>

namespace rubber_suspension::log {

inline std::mutex& hdf5Mutex() {
  static std::mutex mutex;
  return mutex;
}

}  // namespace rubber_suspension::log
