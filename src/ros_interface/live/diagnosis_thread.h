// The live diagnosis of all components in a thread of its own, and its topics.
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/node_handle.h>
#include <rubber_suspension/Diagnosis.h>

#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "diagnosis/live/live_diagnosis.h"
#include "node/component_channel.h"

namespace rubber_suspension::ros_interface {

struct LiveDiagnoserSettings {
  int memory = 300000;  ///< samples with a measured force that are kept per component
  int nice = 19;        ///< niceness of the thread
};

/// What is said as a message, and as a diagnostic status.
Diagnosis diagnosisMessage(const diagnosis::LiveFindings& findings);
void fillDiagnosisStatus(const diagnosis::LiveFindings& findings, diagnostic_updater::DiagnosticStatusWrapper& status);

/// One thread for all components: it reads the samples that the channels keep, under the short locks that these have
/// anyhow, and looks at one component after the other. Nothing waits for it.
class LiveDiagnoser {
 public:
  /// The channels must outlive the object.
  LiveDiagnoser(ros::NodeHandle& handle, const std::vector<node::ComponentChannel*>& channels,
                const LiveDiagnoserSettings& settings);
  ~LiveDiagnoser() { stop(); }
  LiveDiagnoser(const LiveDiagnoser&) = delete;
  LiveDiagnoser& operator=(const LiveDiagnoser&) = delete;

  /// End the thread: a look that runs is cancelled. What was found last can still be asked for.
  void stop();

  /// The model that closes what was found of a component. Throws std::invalid_argument that says why there is none.
  io::ComponentDescription found(const std::string& component) const;

  /// As of the last round of the thread.
  diagnosis::LiveFindings findings(const std::string& component) const;

 private:
  struct Watched {
    node::ComponentChannel* channel;
    std::shared_ptr<const io::ComponentDescription> configured;
    std::unique_ptr<diagnosis::LiveDiagnosis> live;
    std::uint64_t next = 0;  // number of the next sample
    ros::Publisher publisher;
    diagnosis::LiveFindings findings;               // under the mutex
    std::optional<io::ComponentDescription> found;  // under the mutex
  };

  void run();
  void serve(Watched& watched);
  void tell(Watched& watched);
  bool isStopping() const;
  const Watched& at(const std::string& component) const;

  LiveDiagnoserSettings settings_;
  std::vector<Watched> watched_;
  mutable std::mutex mutex_;
  std::condition_variable wake_;
  bool stopping_ = false;
  std::thread thread_;
};

}  // namespace rubber_suspension::ros_interface
