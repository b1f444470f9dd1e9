// The node as a benchmark runs it: a process of its own, with components made for the purpose.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "benchmark/latency/round_trip.h"
#include "ros_interface/child_process.h"

namespace rubber_suspension::benchmark {

/// A component file with that number of components: by turns five Maxwell elements and Berg's model.
std::string benchmarkComponents(int count);

/// Names of these components, in the order of the file.
std::vector<std::string> benchmarkNames(int count);

/// A file with this text that goes with this object. Throws std::runtime_error where it cannot be written.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& text);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

/// `simulate` in the namespace /node, and what drives it. Needs a master.
class BenchmarkNode {
 public:
  /// Starts the program that lies beside the running one and waits until it serves. Throws std::runtime_error.
  BenchmarkNode(int components, bool bundled);

  RoundTripMeter& meter() { return meter_; }
  pid_t process() const { return process_.id(); }

 private:
  TemporaryFile file_;
  ros_interface::ChildProcess process_;
  RoundTripMeter meter_;
};

}  // namespace rubber_suspension::benchmark
