// One component of the node: its samples, its counters, its state.
#include "node/component_channel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "io/sha256.h"

namespace rubber_suspension::node {
namespace {

bool sameElements(const std::vector<element::ElementDescription>& a,
                  const std::vector<element::ElementDescription>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const auto& x, const auto& y) { return x.type == y.type && x.values == y.values; });
}

void add(const component::StreamCounters& news, component::StreamCounters& sum) {
  using Counters = component::StreamCounters;
  for (const auto counter :
       {&Counters::accepted, &Counters::restarted, &Counters::bridged, &Counters::not_finite, &Counters::repeated,
        &Counters::stepped_back, &Counters::force_not_finite, &Counters::not_a_rotation, &Counters::beyond_measure}) {
    sum.*counter += news.*counter;
  }
}

SavedStream savedStream(const component::SampleStream& stream) {
  return {stream.started(), stream.lastStamp(), stream.state().displacement(), stream.state().memory()};
}

void restore(component::SampleStream& stream, const SavedStream& saved) {
  if (saved.started) {
    stream.deserialise(saved.stamp, saved.displacement, saved.memory);
  } else {
    stream.reset();
  }
}

}  // namespace

// The stream refers to the component, so the two stay at one address.
class ComponentChannel::Model {
 public:
  Model(const io::ComponentDescription& description, double max_gap)
      : described(std::make_shared<const io::ComponentDescription>(description)),
        sha256(io::sha256(io::toYaml({description}))),
        valid(description.validDisplacement()),
        component(description.makeComponent()),
        stream(component, max_gap) {}
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;

  const std::shared_ptr<const io::ComponentDescription> described;
  const std::string sha256;
  const std::optional<element::Range> valid;  // [m]
  const component::Component component;
  component::SampleStream stream;
};

// The model beside the configured one. It is fed with the samples that this one accepts.
class ComponentChannel::Promotion {
 public:
  Promotion(io::ComponentDescription of, double max_gap, const PromotionSettings& settings, RunStage stage,
            double weight)
      : description(std::move(of)), model(makeModel(description, max_gap)), fade(settings, stage, weight) {}

  // Take a sample that the configured model answered; returns the published force, and in `beside` the total of the
  // model that does not give it.
  element::ComponentForce push(std::int64_t stamp, double displacement, const element::ComponentForce& configured,
                               double& beside) {
    fade.advance(stamp);
    const component::StreamForce answer = model->stream.push(stamp, displacement);
    if (!component::isAccepted(answer.acceptance)) {
      fade.end();
      note = "its force was not finite";
      return configured;
    }
    const bool in_place = fade.stage() == RunStage::promoting || fade.stage() == RunStage::promoted;
    beside = in_place ? configured.total : answer.force.total;
    return fade.blend(configured, answer.force);
  }

  // Out of the shadow, by what was measured meanwhile.
  void judgeShadow(const PairedErrors& errors) {
    const bool is_no_worse = errors.samples == 0 || errors.other <= errors.published;
    note = (is_no_worse ? "" : "not promoted: in the shadow ") + describeErrors(errors);
    is_no_worse ? fade.take() : fade.end();
  }

  const io::ComponentDescription description;
  const std::shared_ptr<Model> model;
  CrossFade fade;
  std::string note;
};

std::shared_ptr<ComponentChannel::Model> ComponentChannel::makeModel(const io::ComponentDescription& description,
                                                                     double max_gap) {
  return std::make_shared<Model>(description, max_gap);
}

ComponentChannel::ComponentChannel(const io::ComponentDescription& description, double max_gap,
                                   const PromotionSettings& promotion_settings, std::size_t samples_kept)
    : name_(description.name),
      max_gap_(max_gap),
      promotion_settings_(promotion_settings),
      model_(makeModel(description, max_gap)),
      gap_(samples_kept) {}

bool ComponentChannel::push(std::int64_t stamp, double displacement, element::ComponentForce& force) {
  double beside = std::numeric_limits<double>::quiet_NaN();
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!counts_.enabled) {
      ++counts_.disabled;
      return false;
    }
    if (std::isfinite(displacement) && temperatures_.take(stamp)) {
      keepTemperature();
    }
    const component::StreamForce answer = model_->stream.push(stamp, displacement);
    if (!component::isAccepted(answer.acceptance)) {
      return false;
    }
    counts_.beyond_valid += model_->valid && !model_->valid->contains(displacement) ? 1 : 0;
    force = answer.force;
    if (isBeside()) {
      force = promotion_->push(stamp, displacement, answer.force, beside);
      if (promotion_->fade.shadowIsOver()) {
        promotion_->judgeShadow(gap_.pairedErrors());
      }
    }
  }
  gap_.addSimulated(stamp, displacement, force.total, beside);
  return true;
}

bool ComponentChannel::setTemperature(std::int64_t stamp, double temperature) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!std::isfinite(temperature) || !model_->component.temperatures().contains(temperature)) {
    ++counts_.refused_temperatures;
    return false;
  }
  temperatures_.add(stamp, temperature);
  return true;
}

// The temperature that was measured last holds, whatever the state says.
void ComponentChannel::keepTemperature() {
  if (const std::optional<double>& temperature = temperatures_.current()) {
    model_->stream.setTemperature(*temperature);
    if (promotion_) {
      promotion_->model->stream.setTemperature(*temperature);
    }
  }
}

// Whether another model is computed, too.
bool ComponentChannel::isBeside() const { return promotion_ && promotion_->fade.stage() != RunStage::configured; }

void ComponentChannel::countLatency(std::int64_t nanoseconds) {
  const std::lock_guard<std::mutex> lock(mutex_);
  counts_.latency.add(nanoseconds);
}

void ComponentChannel::countLost(std::uint64_t samples) {
  const std::lock_guard<std::mutex> lock(mutex_);
  counts_.lost += samples;
}

void ComponentChannel::reset() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    model_->stream.reset();
    if (promotion_) {
      promotion_->model->stream.reset();
    }
  }
  gap_.clear();
}

void ComponentChannel::setEnabled(bool enabled) {
  const std::lock_guard<std::mutex> lock(mutex_);
  counts_.enabled = enabled;
}

SavedState ComponentChannel::save() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  SavedState saved{savedStream(model_->stream), name_, model_->component.elements(), {}};
  if (isBeside()) {
    saved.promotion = SavedPromotion{savedStream(promotion_->model->stream), io::toYaml({promotion_->description}),
                                     promotion_->fade.stage(), promotion_->fade.weight()};
  }
  return saved;
}

std::shared_ptr<ComponentChannel::Promotion> ComponentChannel::checkState(const SavedState& state) const {
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
    component::ComponentState restored = model->component.makeState();
    model->component.restore(restored, state.displacement, state.memory);
    if (!state.promotion) {
      return {};
    }
    const SavedPromotion& saved = *state.promotion;
    const auto parsed = io::parseComponentFile(saved.description, "promotion");
    auto promotion = std::make_shared<Promotion>(io::selectComponent(parsed, name_, "promotion"), max_gap_,
                                                 promotion_settings_, saved.stage, saved.weight);
    restore(promotion->model->stream, saved);
    if (saved.started) {
      promotion->fade.resume(saved.stamp);
    }
    return promotion;
  } catch (const io::ComponentFileError& error) {
    throw std::invalid_argument(fmt::format("{}: {}", name_, error.what()));
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("{}: {}", name_, error.what()));
  }
}

void ComponentChannel::load(const SavedState& state) {
  std::shared_ptr<Promotion> promotion = checkState(state);
  gap_.clear();
  const std::lock_guard<std::mutex> lock(mutex_);
  std::swap(promotion_, promotion);  // freed after the lock
  restore(model_->stream, state);
  keepTemperature();
}

void ComponentChannel::exchange(const std::shared_ptr<Model>& model) {
  std::shared_ptr<Model> old = model;  // freed after the lock
  std::shared_ptr<Promotion> promotion;
  gap_.clear();
  const std::lock_guard<std::mutex> lock(mutex_);
  const component::SampleStream& stream = model_->stream;
  if (!sameElements(model_->component.elements(), model->component.elements())) {
    std::swap(promotion_, promotion);
    note_ = promotion ? "the component file was read again and has another model" : "";
    since_ = stream.lastStamp();
  } else {
    restore(model->stream, savedStream(stream));
  }
  add(stream.counters(), counts_);
  std::swap(model_, old);
  keepTemperature();
}

void ComponentChannel::promote(const io::ComponentDescription& description) {
  auto promotion = std::make_shared<Promotion>(description, max_gap_, promotion_settings_, RunStage::shadow, 0.0);
  std::shared_ptr<Promotion> finished;
  gap_.clearPairedErrors();
  const std::lock_guard<std::mutex> lock(mutex_);
  dropFinished(finished);
  if (promotion_) {
    throw std::invalid_argument(fmt::format("{}: another model is {} already; accepted: after a rollback", name_,
                                            toString(promotion_->fade.stage())));
  }
  promotion_ = std::move(promotion);
  keepTemperature();
  note_.clear();
}

void ComponentChannel::rollBack() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!isBeside() || promotion_->fade.stage() == RunStage::rolling_back) {
    throw std::invalid_argument(fmt::format("{}: the configured model gives the force, nothing is promoted", name_));
  }
  promotion_->note.clear();
  promotion_->fade.giveBack();
}

// A model that has left its place is of no use any more; `finished` is to be freed after the lock.
void ComponentChannel::dropFinished(std::shared_ptr<Promotion>& finished) {
  if (promotion_ && promotion_->fade.stage() == RunStage::configured) {
    note_ = promotion_->note;
    since_ = promotion_->fade.since();
    std::swap(promotion_, finished);
  }
}

std::shared_ptr<const io::ComponentDescription> ComponentChannel::configured() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return model_->described;
}

RunningModel ComponentChannel::running() const {
  RunningModel running;
  const std::lock_guard<std::mutex> lock(mutex_);
  running.configured_sha256 = model_->sha256;
  running.note = promotion_ ? promotion_->note : note_;
  running.since = promotion_ ? promotion_->fade.since() : since_;
  if (isBeside()) {
    running.stage = promotion_->fade.stage();
    running.weight = promotion_->fade.weight();
    running.other_sha256 = promotion_->model->sha256;
    for (const element::ElementDescription& element : promotion_->description.add) {
      running.added.push_back(element.type);
    }
  }
  return running;
}

ChannelReport ComponentChannel::report() {
  std::shared_ptr<Promotion> finished;  // freed after the lock
  const std::lock_guard<std::mutex> lock(mutex_);
  dropFinished(finished);
  const component::SampleStream& stream = model_->stream;
  ChannelReport result = counts_;
  counts_.latency = {};
  add(stream.counters(), result);
  result.valid = model_->valid;
  result.started = stream.started();
  result.last_time = 1e-9 * static_cast<double>(stream.lastStamp());
  result.displacement = stream.state().displacement();
  result.shifts_with_temperature = model_->component.shiftsWithTemperature();
  result.temperature = temperatures_.current();
  return result;
}

}  // namespace rubber_suspension::node
