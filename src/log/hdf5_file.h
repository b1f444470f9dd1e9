// Files of HDF5: opened, gone through, and refused where their data lie elsewhere.
#pragma once

#include <hdf5.h>

#include <functional>
#include <mutex>
#include <string>

namespace rubber_suspension::log {

/// One reader of HDF5 at a time: the library, on which files of MATLAB's level 7.3 rest too, is not safe for threads in
/// every build.
inline std::mutex& hdf5Mutex() {
  static std::mutex mutex;
  return mutex;
}

/// A handle of libhdf5, given back by the function that belongs to it.
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

/// Opens a file to read; throws std::runtime_error where that fails.
hid_t openHdf5(const std::string& path);

/// Throws std::runtime_error for a dataset whose data lie in other files (external storage, virtual datasets), which
/// may be any file of the machine, or were never written, which libhdf5 takes for zeros.
void requireOwnData(hid_t dataset, const std::string& name);

/// Checks all datasets of a file; does nothing for one that is no HDF5.
void requireOwnData(const std::string& path);

/// Calls `visit` with the path of each object of a file, and the object where it is a dataset, until it returns false.
/// Throws what `visit` throws, and std::runtime_error for groups that are nested too deep and a file that is damaged.
void visitObjects(hid_t file, const std::function<bool(const std::string& path, const Hdf5Handle* dataset)>& visit);

/// The datasets that are there, with their sizes, for errors: "'a' of 3 x 4 x 5, ...", or "no datasets".
std::string describeDatasets(hid_t file);

}  // namespace rubber_suspension::log
