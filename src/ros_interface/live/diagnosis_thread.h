// The live diagnosis of all components in a thread of its own, with its topics. The node loads this code as a library.
#pragma once

#include <ros/node_handle.h>

#include <atomic>
#include <cstdint>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "diagnosis/live/live_diagnosis.h"
#include "ros_interface/live_diagnoser.h"

namespace rubber_suspension::ros_interface {

/// Diagnoses all components, one after the other, in one thread. To read the samples that a channel stores, it locks
/// the channel only for a short time.
class DiagnosisThread final : public LiveDiagnoser {
 public:
  /// The channels must outlive the object.
  DiagnosisThread(ros::NodeHandle& handle, const std::vector<node::ComponentChannel*>& channels,
                  const LiveDiagnoserSettings& settings);
  ~DiagnosisThread() override;

  void stop() override;
  io::ComponentDescription found(const std::string& component) const override;
  void fillStatus(const std::string& component, diagnostic_updater::DiagnosticStatusWrapper& status) const override;

 private:
  struct Watched {
    node::ComponentChannel* channel = nullptr;
    std::shared_ptr<const io::ComponentDescription> configured;
    std::unique_ptr<diagnosis::live::LiveDiagnosis> live;
    std::uint64_t next = 0;  // number of the next sample
    ros::Publisher publisher;
    diagnosis::live::LiveFindings findings{};         // guarded by mutex_
    std::optional<io::ComponentDescription> found{};  // guarded by mutex_
  };

  void run();
  void serve(Watched& watched);
  void tell(Watched& watched);

  LiveDiagnoserSettings settings_;
  std::map<std::string, Watched> watched_;  // by name of the component
  mutable std::mutex mutex_;
  std::promise<void> wake_;
  std::atomic<bool> stopping_{false};
  std::thread thread_;
};

}  // namespace rubber_suspension::ros_interface
