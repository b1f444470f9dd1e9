// All components of the node, for operations that act on all components at one instant. Independent of ROS.
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <shared_mutex>
#include <vector>

#include "node/component_channel.h"

namespace rubber_suspension::node {

/// Bundles of samples and operations on all components exclude each other. So no saved state contains half a bundle,
/// and no bundle is answered partly before and partly after a change. Single samples need only the lock of their
/// component.
class ChannelGroup {
 public:
  /// The channels must outlive the group.
  explicit ChannelGroup(std::vector<ComponentChannel*> channels) : channels_(std::move(channels)) {
    for (ComponentChannel* channel : channels_) {
      by_kind_[channel->hasSixDirections() ? 1 : 0].push_back(channel);
    }
  }

  const std::vector<ComponentChannel*>& channels() const { return channels_; }

  /// Returns the channels of components of six directions, or of components of one direction.
  const std::vector<ComponentChannel*>& channels(bool six_directions) const { return by_kind_[six_directions ? 1 : 0]; }

  /// Returns the lock that the caller must hold while it answers a bundle.
  std::shared_lock<std::shared_mutex> bundle() const { return std::shared_lock<std::shared_mutex>(mutex_); }

  std::vector<SavedState> save() const {
    std::vector<SavedState> states;
    states.reserve(channels_.size());
    const Alone lock(mutex_);
    for (const ComponentChannel* channel : channels_) {
      states.push_back(channel->save());
    }
    return states;
  }

  void reset() {
    const Alone lock(mutex_);
    std::for_each(channels_.begin(), channels_.end(), [](ComponentChannel* channel) { channel->reset(); });
  }

  void setEnabled(bool enabled) {
    const Alone lock(mutex_);
    std::for_each(channels_.begin(), channels_.end(), [=](ComponentChannel* channel) { channel->setEnabled(enabled); });
  }

  /// Loads one state for each channel, in the order of the channels. If a state is refused, throws as
  /// ComponentChannel::checkState() and changes nothing.
  void load(const std::vector<const SavedState*>& states) {
    const Alone lock(mutex_);
    for (std::size_t i = 0; i < channels_.size(); ++i) {
      channels_[i]->checkState(*states[i]);
    }
    for (std::size_t i = 0; i < channels_.size(); ++i) {
      channels_[i]->load(*states[i]);
    }
  }

  /// Replaces the model of each channel. `models` is in the order of the channels.
  void exchange(const std::vector<std::shared_ptr<ComponentChannel::Model>>& models) {
    const Alone lock(mutex_);
    for (std::size_t i = 0; i < channels_.size(); ++i) {
      channels_[i]->exchange(models[i]);
    }
  }

 private:
  using Alone = std::unique_lock<std::shared_mutex>;

  std::vector<ComponentChannel*> channels_;
  std::array<std::vector<ComponentChannel*>, 2> by_kind_;
  mutable std::shared_mutex mutex_;
};

}  // namespace rubber_suspension::node
