// One component of the node: its samples, its counters, its state.
#include "node/component_channel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace rubber_suspension::node {
namespace {

bool sameElements(const std::vector<element::ElementDescription>& a,
                  const std::vector<element::ElementDescription>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const auto& x, const auto& y) { return x.type == y.type && x.values == y.values; });
}

component::StreamCounters sum(const component::StreamCounters& a, const component::StreamCounters& b) {
  component::StreamCounters result = a;
  result.accepted += b.accepted;
  result.restarted += b.restarted;
  result.bridged += b.bridged;
  result.not_finite += b.not_finite;
  result.repeated += b.repeated;
  result.stepped_back += b.stepped_back;
  return result;
}

}  // namespace

// The stream refers to the component, so the two stay at one address.
class ComponentChannel::Model {
 public:
  Model(const io::ComponentDescription& description, double max_gap)
      : component(description.makeComponent()), stream(component, max_gap) {}
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;

  const component::Component component;
  component::SampleStream stream;
};

std::shared_ptr<ComponentChannel::Model> ComponentChannel::makeModel(const io::ComponentDescription& description,
                                                                     double max_gap) {
  return std::make_shared<Model>(description, max_gap);
}

ComponentChannel::ComponentChannel(const io::ComponentDescription& description, double max_gap)
    : name_(description.name), model_(makeModel(description, max_gap)) {}

bool ComponentChannel::push(std::int64_t stamp, double displacement, element::ComponentForce& force) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!enabled_) {
      ++disabled_;
      return false;
    }
    const component::StreamForce answer = model_->stream.push(stamp, displacement);
    if (!component::isAccepted(answer.acceptance)) {
      return false;
    }
    force = answer.force;
  }
  gap_.addSimulated(stamp, displacement, force.total);
  return true;
}

void ComponentChannel::countLatency(std::int64_t nanoseconds) {
  const std::lock_guard<std::mutex> lock(mutex_);
  latency_.add(nanoseconds);
}

void ComponentChannel::countLost(std::uint64_t samples) {
  const std::lock_guard<std::mutex> lock(mutex_);
  lost_ += samples;
}

void ComponentChannel::reset() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    model_->stream.reset();
  }
  gap_.clear();
}

void ComponentChannel::setEnabled(bool enabled) {
  const std::lock_guard<std::mutex> lock(mutex_);
  enabled_ = enabled;
}

SavedState ComponentChannel::save() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const component::SampleStream& stream = model_->stream;
  return {name_,
          model_->component.elements(),
          stream.started(),
          stream.lastStamp(),
          stream.state().displacement(),
          stream.state().memory()};
}

void ComponentChannel::checkState(const SavedState& state) const {
  std::shared_ptr<Model> model;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    model = model_;
  }
  if (state.component != name_) {
    throw std::invalid_argument(fmt::format("state of component {} does not belong to {}", state.component, name_));
  }
  if (!sameElements(state.elements, model->component.elements())) {
    throw std::invalid_argument(fmt::format("{}: the state was saved with other elements or parameters", name_));
  }
  try {
    model->component.makeState().deserialise(state.displacement, state.memory);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("{}: {}", name_, error.what()));
  }
}

void ComponentChannel::load(const SavedState& state) {
  checkState(state);
  gap_.clear();
  const std::lock_guard<std::mutex> lock(mutex_);
  if (state.started) {
    model_->stream.deserialise(state.stamp, state.displacement, state.memory);
  } else {
    model_->stream.reset();
  }
}

void ComponentChannel::exchange(const std::shared_ptr<Model>& model) {
  std::shared_ptr<Model> old = model;  // freed after the lock
  gap_.clear();
  const std::lock_guard<std::mutex> lock(mutex_);
  const component::SampleStream& stream = model_->stream;
  if (stream.started() && sameElements(model_->component.elements(), model->component.elements())) {
    model->stream.deserialise(stream.lastStamp(), stream.state().displacement(), stream.state().memory());
  }
  earlier_ = sum(earlier_, stream.counters());
  std::swap(model_, old);
}

ChannelReport ComponentChannel::report() {
  ChannelReport result;
  const std::lock_guard<std::mutex> lock(mutex_);
  const component::SampleStream& stream = model_->stream;
  result.counters = sum(earlier_, stream.counters());
  result.disabled = disabled_;
  result.lost = lost_;
  result.enabled = enabled_;
  result.started = stream.started();
  result.last_time = 1e-9 * static_cast<double>(stream.lastStamp());
  result.displacement = stream.state().displacement();
  result.latency = latency_;
  latency_.clear();
  return result;
}

}  // namespace rubber_suspension::node
