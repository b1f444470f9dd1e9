// Where the data of an HDF5 file lie: in the file itself, or it is refused.
#pragma once

#include <hdf5.h>

#include <string>

namespace rubber_suspension::log {

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

/// The same for all datasets of a file; nothing for one that is no HDF5. Groups are nested kDeepestGroup deep at most.
void requireOwnData(const std::string& path);

constexpr int kDeepestGroup = 32;

/// Throws std::runtime_error for a path within a file that is deeper.
void requireShallow(const std::string& name);

}  // namespace rubber_suspension::log
