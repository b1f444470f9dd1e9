// Opens and traverses files of HDF5, and refuses those whose data lie elsewhere.
#pragma once

#include <hdf5.h>

#include <functional>
#include <mutex>
#include <string>

namespace rubber_suspension::log {

/// Returns the mutex of all readers of HDF5, and of MATLAB's level 7.3, which is HDF5: the library is not safe for
/// threads in every build.
inline std::mutex& hdf5Mutex() {
  static std::mutex mutex;
  return mutex;
}

/// Owns a handle of libhdf5 and closes it by the function that belongs to it.
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

/// Opens a file to read. Throws std::runtime_error if that fails.
hid_t openHdf5(const std::string& path);

/// Throws std::runtime_error for a dataset whose data lie in other files (external storage, virtual datasets), which
/// may be any file of the machine, or were never written, which libhdf5 reads as zeros.
void requireOwnData(hid_t dataset, const std::string& name);

/// Checks all datasets of a file; does nothing for one that is no HDF5.
void requireOwnData(const std::string& path);

/// Calls `visit` with the path of each object of a file, and its handle if it is a dataset, until `visit` returns
/// false. Throws what `visit` throws, and std::runtime_error for groups that are nested too deep and a file that is
/// damaged.
void visitObjects(hid_t file, const std::function<bool(const std::string& path, const Hdf5Handle* dataset)>& visit);

/// Returns the datasets of a file with their sizes, for errors: "'a' of 3 x 4 x 5, ...", or "no datasets".
std::string describeDatasets(hid_t file);

}  // namespace rubber_suspension::log
