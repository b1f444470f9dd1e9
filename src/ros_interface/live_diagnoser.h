// Interface of the live diagnosis. The node loads its library on request only, because only the diagnosis needs fits.
#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/node_handle.h>

#include <string>
#include <vector>

#include "node/component_channel.h"

namespace rubber_suspension::ros_interface {

struct LiveDiagnoserSettings {
  int memory = 300000;  ///< samples with a measured force that are stored per component
  int nice = 19;        ///< niceness of the thread
};

/// Diagnoses the samples that the channels store, in a separate thread, for which no other thread waits.
class LiveDiagnoser {
 public:
  virtual ~LiveDiagnoser() = default;

  /// Ends the thread and cancels a running diagnosis. The last findings remain available.
  virtual void stop() = 0;

  /// Returns a component's model with the effects that were found. Throws std::invalid_argument, which states the
  /// reason, if there is no such model.
  virtual io::ComponentDescription found(const std::string& component) const = 0;

  /// Writes the latest findings on a component.
  virtual void fillStatus(const std::string& component, diagnostic_updater::DiagnosticStatusWrapper& status) const = 0;
};

/// Type of the function kLiveDiagnoserMaker in the library of the diagnosis. The channels must outlive the object that
/// the function returns. It throws std::invalid_argument if the specification of a component has no solution.
using MakeLiveDiagnoser = LiveDiagnoser*(ros::NodeHandle&, const std::vector<node::ComponentChannel*>&,
                                         const LiveDiagnoserSettings&);
constexpr const char* kLiveDiagnoserMaker = "rubber_suspension_make_live_diagnoser";

}  // namespace rubber_suspension::ros_interface
