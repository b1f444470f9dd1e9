// The importer of the tests.
#include "fmi/importer.h"

#include <dlfcn.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <tinyxml2.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "fmi/runtime/fmi.h"

namespace rubber_suspension::fmi::test {
namespace {

bool endsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

std::map<std::string, Reference> referencesOf(const std::string& xml) {
  tinyxml2::XMLDocument document;
  document.Parse(xml.c_str());
  std::map<std::string, Reference> references;
  const auto* variables = document.RootElement()->FirstChildElement("ModelVariables");
  for (const auto* variable = variables->FirstChildElement(); variable != nullptr;
       variable = variable->NextSiblingElement()) {
    references[variable->Attribute("name")] = variable->UnsignedAttribute("valueReference");
  }
  return references;
}

// Writes the binary to a file, loads it, and deletes the file.
void* load(const ArchiveEntry& binary) {
  std::string folder = (std::filesystem::temp_directory_path() / "fmu.XXXXXX").string();
  if (mkdtemp(folder.data()) == nullptr) {
    throw std::runtime_error(folder + ": cannot be made");
  }
  const std::string path = folder + "/" + std::filesystem::path(binary.path).filename().string();
  std::ofstream(path, std::ios::binary) << binary.content;
  void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  const std::string reason = library == nullptr ? dlerror() : "";
  std::filesystem::remove_all(folder);
  if (library == nullptr) {
    throw std::runtime_error(reason);
  }
  return library;
}

void keepMessage(void* environment, fmiString /*instance*/, fmi2Status status, fmiString category, fmiString message,
                 ...) {
  static_cast<Importer*>(environment)->messages.push_back({status, category, message});
}

class Importer2 : public Importer {
 public:
  Importer2(const LoadedFmu& fmu, const std::string& token, bool logging) : fmu_(fmu) {
    callbacks_.logger = keepMessage;
    callbacks_.componentEnvironment = static_cast<Importer*>(this);
    instance_ = call<decltype(fmi2Instantiate)>("fmi2Instantiate")("test", fmi2CoSimulation, token.c_str(),
                                                                   "file:///nowhere", &callbacks_, 0, logging ? 1 : 0);
  }
  ~Importer2() override { call<decltype(fmi2FreeInstance)>("fmi2FreeInstance")(instance_); }

  bool valid() const override { return instance_ != nullptr; }
  int enterInitialisation(double start, std::optional<double> stop) override {
    const int status = call<decltype(fmi2SetupExperiment)>("fmi2SetupExperiment")(instance_, 0, 0.0, start,
                                                                                  stop ? 1 : 0, stop.value_or(0.0));
    return status != kOk ? status
                         : call<decltype(fmi2EnterInitializationMode)>("fmi2EnterInitializationMode")(instance_);
  }
  int exitInitialisation() override {
    return call<decltype(fmi2ExitInitializationMode)>("fmi2ExitInitializationMode")(instance_);
  }
  int terminate() override { return call<decltype(fmi2Terminate)>("fmi2Terminate")(instance_); }
  int reset() override { return call<decltype(fmi2Reset)>("fmi2Reset")(instance_); }
  int set(const Reference* references, std::size_t count, const double* values) override {
    return set_(instance_, references, count, values);
  }
  int get(const Reference* references, std::size_t count, double* values) override {
    return get_(instance_, references, count, values);
  }
  int step(double time, double size) override { return step_(instance_, time, size, 1); }
  int save(void** state) override { return save_(instance_, state); }
  int restore(void* state) override { return restore_(instance_, state); }
  int free(void** state) override { return call<decltype(fmi2FreeFMUstate)>("fmi2FreeFMUstate")(instance_, state); }
  int serialisedSize(void* state, std::size_t* size) override {
    return call<decltype(fmi2SerializedFMUstateSize)>("fmi2SerializedFMUstateSize")(instance_, state, size);
  }
  int serialise(void* state, char* bytes, std::size_t size) override {
    return call<decltype(fmi2SerializeFMUstate)>("fmi2SerializeFMUstate")(instance_, state, bytes, size);
  }
  int deserialise(const char* bytes, std::size_t size, void** state) override {
    return call<decltype(fmi2DeSerializeFMUstate)>("fmi2DeSerializeFMUstate")(instance_, bytes, size, state);
  }
  int setLogging(bool on, const std::vector<const char*>& categories) override {
    return call<decltype(fmi2SetDebugLogging)>("fmi2SetDebugLogging")(instance_, on ? 1 : 0, categories.size(),
                                                                      categories.data());
  }

 private:
  template <class Function>
  Function* call(const char* name) const {
    return fmu_.function<Function>(name);
  }

  const LoadedFmu& fmu_;
  fmi2CallbackFunctions callbacks_{};
  void* instance_;
  decltype(fmi2SetReal)* set_ = call<decltype(fmi2SetReal)>("fmi2SetReal");
  decltype(fmi2GetReal)* get_ = call<decltype(fmi2GetReal)>("fmi2GetReal");
  decltype(fmi2DoStep)* step_ = call<decltype(fmi2DoStep)>("fmi2DoStep");
  decltype(fmi2GetFMUstate)* save_ = call<decltype(fmi2GetFMUstate)>("fmi2GetFMUstate");
  decltype(fmi2SetFMUstate)* restore_ = call<decltype(fmi2SetFMUstate)>("fmi2SetFMUstate");
};

class Importer3 : public Importer {
 public:
  Importer3(const LoadedFmu& fmu, const std::string& token, bool logging) : fmu_(fmu) {
    const auto log = [](void* environment, fmi3Status status, fmiString category, fmiString message) {
      static_cast<Importer3*>(environment)->messages.push_back({status, category, message});
    };
    instance_ = call<decltype(fmi3InstantiateCoSimulation)>("fmi3InstantiateCoSimulation")(
        "test", token.c_str(), "/nowhere/", false, logging, false, false, nullptr, 0, this, log, nullptr);
  }
  ~Importer3() override { call<decltype(fmi3FreeInstance)>("fmi3FreeInstance")(instance_); }

  bool valid() const override { return instance_ != nullptr; }
  int enterInitialisation(double start, std::optional<double> stop) override {
    return call<decltype(fmi3EnterInitializationMode)>("fmi3EnterInitializationMode")(
        instance_, false, 0.0, start, stop.has_value(), stop.value_or(0.0));
  }
  int exitInitialisation() override {
    return call<decltype(fmi3ExitInitializationMode)>("fmi3ExitInitializationMode")(instance_);
  }
  int terminate() override { return call<decltype(fmi3Terminate)>("fmi3Terminate")(instance_); }
  int reset() override { return call<decltype(fmi3Reset)>("fmi3Reset")(instance_); }
  int set(const Reference* references, std::size_t count, const double* values) override {
    return set_(instance_, references, count, values, count);
  }
  int get(const Reference* references, std::size_t count, double* values) override {
    return get_(instance_, references, count, values, count);
  }
  int step(double time, double size) override {
    bool event = true;
    bool end = true;
    bool early = true;
    double reached = 0.0;
    const int status = step_(instance_, time, size, true, &event, &end, &early, &reached);
    EXPECT_FALSE(valid() && (event || end || early));
    if (status == kOk) {
      EXPECT_EQ(reached, time + size);
    }
    return status;
  }
  int save(void** state) override { return save_(instance_, state); }
  int restore(void* state) override { return restore_(instance_, state); }
  int free(void** state) override { return call<decltype(fmi3FreeFMUState)>("fmi3FreeFMUState")(instance_, state); }
  int serialisedSize(void* state, std::size_t* size) override {
    return call<decltype(fmi3SerializedFMUStateSize)>("fmi3SerializedFMUStateSize")(instance_, state, size);
  }
  int serialise(void* state, char* bytes, std::size_t size) override {
    return call<decltype(fmi3SerializeFMUState)>("fmi3SerializeFMUState")(instance_, state,
                                                                          reinterpret_cast<std::uint8_t*>(bytes), size);
  }
  int deserialise(const char* bytes, std::size_t size, void** state) override {
    return call<decltype(fmi3DeserializeFMUState)>("fmi3DeserializeFMUState")(
        instance_, reinterpret_cast<const std::uint8_t*>(bytes), size, state);
  }
  int setLogging(bool on, const std::vector<const char*>& categories) override {
    return call<decltype(fmi3SetDebugLogging)>("fmi3SetDebugLogging")(instance_, on, categories.size(),
                                                                      categories.data());
  }

 private:
  template <class Function>
  Function* call(const char* name) const {
    return fmu_.function<Function>(name);
  }

  const LoadedFmu& fmu_;
  void* instance_;
  decltype(fmi3SetFloat64)* set_ = call<decltype(fmi3SetFloat64)>("fmi3SetFloat64");
  decltype(fmi3GetFloat64)* get_ = call<decltype(fmi3GetFloat64)>("fmi3GetFloat64");
  decltype(fmi3DoStep)* step_ = call<decltype(fmi3DoStep)>("fmi3DoStep");
  decltype(fmi3GetFMUState)* save_ = call<decltype(fmi3GetFMUState)>("fmi3GetFMUState");
  decltype(fmi3SetFMUState)* restore_ = call<decltype(fmi3SetFMUState)>("fmi3SetFMUState");
};

}  // namespace

LoadedFmu::LoadedFmu(const io::ComponentDescription& description, Version version)
    : version_(version), guid_(dataOf(description).guid) {
  for (const ArchiveEntry& entry : fmuFiles(description, version, {FMU_BINARY, FMU_SOURCES})) {
    if (entry.path == "modelDescription.xml") {
      references_ = referencesOf(entry.content);
    } else if (endsWith(entry.path, "/" + description.name + ".so")) {
      library_ = load(entry);
    }
  }
}

LoadedFmu::~LoadedFmu() { dlclose(library_); }

void* LoadedFmu::symbol(const char* name) const {
  if (void* address = dlsym(library_, name)) {
    return address;
  }
  throw std::runtime_error(std::string(name) + ": not in the binary");
}

std::unique_ptr<Importer> Importer::make(const LoadedFmu& fmu, const std::string& token, bool logging) {
  if (fmu.version() == Version::fmi2) {
    return std::make_unique<Importer2>(fmu, token, logging);
  }
  return std::make_unique<Importer3>(fmu, token, logging);
}

double Importer::value(Reference reference) {
  double value = 0.0;
  EXPECT_EQ(get(&reference, 1, &value), kOk) << "reference " << reference;
  return value;
}

void Importer::start(double displacement, double time) {
  ASSERT_EQ(enterInitialisation(time), kOk);
  ASSERT_EQ(set(reference::kDisplacement, displacement), kOk);
  ASSERT_EQ(exitInitialisation(), kOk);
}

}  // namespace rubber_suspension::fmi::test
