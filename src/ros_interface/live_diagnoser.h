// The live diagnosis as the node knows it: loaded where it is asked for, since nothing else in the node needs its fits.
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/node_handle.h>

#include <string>
#include <vector>

#include "node/component_channel.h"

namespace rubber_suspension::ros_interface {

struct LiveDiagnoserSettings {
  int memory = 300000;  ///< samples with a measured force that are kept per component
  int nice = 19;        ///< niceness of the thread
};

/// Looks at the samples that the channels keep, in a thread of its own. Nothing waits for it.
class LiveDiagnoser {
 public:
  virtual ~LiveDiagnoser() = default;

  /// End the thread: a look that runs is cancelled. What was found last can still be asked for.
  virtual void stop() = 0;

  /// The model that closes what was found of a component. Throws std::invalid_argument that says why there is none.
  virtual io::ComponentDescription found(const std::string& component) const = 0;

  /// The findings on a component, as of the last round of the thread.
  virtual void fillStatus(const std::string& component, diagnostic_updater::DiagnosticStatusWrapper& status) const = 0;
};

/// The function of that name in the library of the diagnosis; the channels must outlive what it makes. Throws
/// std::invalid_argument where a component has no solution.
using MakeLiveDiagnoser = LiveDiagnoser*(ros::NodeHandle&, const std::vector<node::ComponentChannel*>&,
                                         const LiveDiagnoserSettings&);
constexpr const char* kLiveDiagnoserMaker = "rubber_suspension_make_live_diagnoser";

}  // namespace rubber_suspension::ros_interface
