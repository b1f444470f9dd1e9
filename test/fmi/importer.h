// Imports an FMU for tests: unpacks it, loads its binary with dlopen, and calls the functions of the standard.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fmi/export.h"

namespace rubber_suspension::fmi::test {

/// Value references of a component with one direction.
namespace reference {
using namespace fmi::reference;
constexpr Reference kElastic = 3;
constexpr Reference kViscous = 4;
constexpr Reference kFriction = 5;
}  // namespace reference

/// Status codes of the functions in both versions of the standard.
enum Result { kOk = 0, kWarning = 1, kDiscard = 2, kError = 3, kFatal = 4 };

/// An unpacked FMU in a folder of its own. The binary is deleted after loading, so that it cannot read other files.
class LoadedFmu {
 public:
  LoadedFmu(const io::ComponentDescription& description, Version version);
  ~LoadedFmu();
  LoadedFmu(const LoadedFmu&) = delete;
  LoadedFmu& operator=(const LoadedFmu&) = delete;

  Version version() const { return version_; }
  const std::string& guid() const { return guid_; }

  /// Returns the function with this name. Throws if the binary has no such function.
  template <class Function>
  Function* function(const char* name) const {
    return reinterpret_cast<Function*>(symbol(name));
  }

  /// Returns the value reference of a variable by its name in modelDescription.xml.
  Reference reference(const std::string& name) const { return references_.at(name); }
  const std::map<std::string, Reference>& references() const { return references_; }

 private:
  void* symbol(const char* name) const;

  Version version_;
  std::string guid_;
  std::map<std::string, Reference> references_;
  void* library_ = nullptr;
};

/// An instance of an FMU of either version. Its log messages are stored.
class Importer {
 public:
  struct Message {
    int status;
    std::string category;
    std::string text;
  };

  static std::unique_ptr<Importer> make(const LoadedFmu& fmu, const std::string& token, bool logging = false);
  virtual ~Importer() = default;

  virtual bool valid() const = 0;
  virtual int enterInitialisation(double start, std::optional<double> stop = std::nullopt) = 0;
  virtual int exitInitialisation() = 0;
  virtual int terminate() = 0;
  virtual int reset() = 0;
  virtual int set(const Reference* references, std::size_t count, const double* values) = 0;
  virtual int get(const Reference* references, std::size_t count, double* values) = 0;
  virtual int step(double time, double size) = 0;
  virtual int save(void** state) = 0;
  virtual int restore(void* state) = 0;
  virtual int free(void** state) = 0;
  virtual int serialisedSize(void* state, std::size_t* size) = 0;
  virtual int serialise(void* state, char* bytes, std::size_t size) = 0;
  virtual int deserialise(const char* bytes, std::size_t size, void** state) = 0;
  virtual int setLogging(bool on, const std::vector<const char*>& categories) = 0;

  int set(Reference reference, double value) { return set(&reference, 1, &value); }
  double value(Reference reference);  ///< fails the test if the value is not available

  /// Enters and exits initialisation at a displacement [m].
  void start(double displacement, double time = 0.0);

  std::vector<Message> messages;
};

}  // namespace rubber_suspension::fmi::test
