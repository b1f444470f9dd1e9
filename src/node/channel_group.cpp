// All components of the node.
#include "node/channel_group.h"

namespace rubber_suspension::node {
namespace {

using Alone = std::unique_lock<std::shared_mutex>;

}  // namespace

std::vector<SavedState> ChannelGroup::save() const {
  std::vector<SavedState> states;
  states.reserve(channels_.size());
  const Alone lock(mutex_);
  for (const ComponentChannel* channel : channels_) {
    states.push_back(channel->save());
  }
  return states;
}

void ChannelGroup::reset() {
  const Alone lock(mutex_);
  for (ComponentChannel* channel : channels_) {
    channel->reset();
  }
}

void ChannelGroup::setEnabled(bool enabled) {
  const Alone lock(mutex_);
  for (ComponentChannel* channel : channels_) {
    channel->setEnabled(enabled);
  }
}

void ChannelGroup::load(const std::vector<const SavedState*>& states) {
  const Alone lock(mutex_);
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    channels_[i]->checkState(*states[i]);
  }
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    channels_[i]->load(*states[i]);
  }
}

void ChannelGroup::exchange(const std::vector<std::shared_ptr<ComponentChannel::Model>>& models) {
  const Alone lock(mutex_);
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    channels_[i]->exchange(models[i]);
  }
}

}  // namespace rubber_suspension::node
