// Opens and traverses HDF5 files, and refuses files that keep their data in other files.
#pragma once

#include <hdf5.h>

#include <functional>
#include <mutex>
#include <string>

namespace rubber_suspension::log {

/// Returns the mutex that readers of HDF5 and of MATLAB level 7.3 must lock: not all builds of libhdf5 are thread-safe.
inline std::mutex& hdf5Mutex() {
  static std::mutex mutex;
  return mutex;
}

/// Owns a handle of libhdf5 and closes it with the given function.
class Hdf5Handle {
 public:
  Hdf5Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  Hdf5Handle(const Hdf5Handle&) = delete;
  Hdf5Handle& operator=(const Hdf5Handle&) = delete;
  ~Hdf5Handle() {
    if (id_ >= 0) {
      close_(id_);
    }
  }

  explicit operator bool() const { return id_ >= 0; }
  hid_t get() const { return id_; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

/// Opens a file for reading. Throws std::runtime_error if that fails.
hid_t openHdf5(const std::string& path);

/// Throws std::runtime_error if the data of a dataset were never written, because libhdf5 would read zeros, or if they
/// lie in other files (external storage, virtual datasets), because these could be any files of the computer.
void requireOwnData(hid_t dataset, const std::string& name);

/// Checks all datasets of a file with the function above. Does nothing if the file is not HDF5.
void requireOwnData(const std::string& path);

/// Calls `visit` for each object of a file until `visit` returns false. Its arguments are the path of the object and,
/// for a dataset, the handle, otherwise null. Throws what `visit` throws, and std::runtime_error for a damaged file.
void visitObjects(hid_t file, const std::function<bool(const std::string& path, const Hdf5Handle* dataset)>& visit);

/// Returns the names and sizes of the datasets in a file, for errors: "'a' of 3 x 4 x 5, ...", or "no datasets".
std::string describeDatasets(hid_t file);

}  // namespace rubber_suspension::log
