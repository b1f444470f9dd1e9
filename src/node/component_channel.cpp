// One component of the node: its samples, counters and state.
#include "node/component_channel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "element/refuse.h"
#include "io/sha256.h"

namespace rubber_suspension::node {
namespace {

void add(const component::StreamCounters& news, component::StreamCounters& sum) {
  using Counters = component::StreamCounters;
  for (const auto counter :
       {&Counters::accepted, &Counters::restarted, &Counters::bridged, &Counters::not_finite, &Counters::repeated,
        &Counters::stepped_back, &Counters::force_not_finite, &Counters::not_a_rotation, &Counters::beyond_measure}) {
    sum.*counter += news.*counter;
  }
}

SavedStream savedOf(const component::SampleStream& stream) {
  return {stream.started(), stream.lastStamp(), stream.state().displacement(), stream.state().memory()};
}

SavedStream savedOf(const component::PoseStream& stream) {
  return {stream.started(), stream.lastStamp(), 0.0, stream.state().numbers()};
}

void goOn(component::SampleStream& stream, const SavedStream& saved) {
  stream.deserialise(saved.stamp, saved.displacement, saved.memory);
}

void goOn(component::PoseStream& stream, const SavedStream& saved) { stream.deserialise(saved.stamp, saved.memory); }

// Throws for a model that cannot be computed in parallel with another model.
void requireOneDirection(const io::ComponentDescription& description) {
  element::refuseIf(description.six != nullptr,
                    "{}: has six directions and cannot be promoted; accepted: a component of one direction",
                    description.name);
}

}  // namespace

class ComponentChannel::Model {
 public:
  Model(const io::ComponentDescription& description, double max_gap)
      : described(std::make_shared<const io::ComponentDescription>(description)),
        sha256(io::sha256(io::toYaml({description}))),
        valid(description.six ? std::nullopt : description.validDisplacement()),
        max_gap_(max_gap) {
    if (description.six) {
      six.emplace(description.six->makeComponent(), max_gap);
    } else {
      one.emplace(description.makeComponent(), max_gap);
    }
  }
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;

  // Calls `question` with the component and its stream, for one direction or for six directions.
  template <class Ask>
  auto ask(Ask question) const {
    return six ? question(six->component, six->stream) : question(one->component, one->stream);
  }
  template <class Order>
  void tell(Order order) {
    six ? order(six->stream) : order(one->stream);
  }

  ModelIdentity identity() const {
    return six ? ModelIdentity{{}, sha256} : ModelIdentity{one->component.elements(), ""};
  }
  SavedStream save() const {
    return ask([](const auto& /*component*/, const auto& stream) { return savedOf(stream); });
  }
  void restore(const SavedStream& saved) {
    tell([&](auto& stream) { saved.started ? goOn(stream, saved) : stream.reset(); });
  }
  // Throws unless the model can continue from a saved stream. It does not use the running stream, so it needs no lock.
  void check(const SavedStream& saved) const {
    ask([&](const auto& component, const auto& running) {
      std::decay_t<decltype(running)> stream(component, max_gap_);
      goOn(stream, saved);
    });
  }

  // A component and its stream. The stream refers to the component, so neither object may be moved.
  template <class Component, class Stream>
  struct Fed {
    Fed(Component made, double max_gap) : component(std::move(made)), stream(component, max_gap) {}

    const Component component;
    Stream stream;
  };

  const std::shared_ptr<const io::ComponentDescription> described;
  const std::string sha256;
  const std::optional<element::Range> valid;  // [m]
  std::optional<Fed<component::Component, component::SampleStream>> one;
  std::optional<Fed<component::SixDirections, component::PoseStream>> six;

 private:
  const double max_gap_;
};

// A second model in addition to the configured model. It receives the samples that the configured model accepts.
class ComponentChannel::Promotion {
 public:
  Promotion(io::ComponentDescription of, double max_gap, const PromotionSettings& settings, RunStage stage,
            double weight)
      : description(std::move(of)), model(makeModel(description, max_gap)), fade(settings, stage, weight) {}

  // Processes a sample that the configured model has answered with the force `configured`. Returns the published force,
  // and sets `beside` to the total force of the second model.
  element::ComponentForce push(std::int64_t stamp, double displacement, const element::ComponentForce& configured,
                               double& beside) {
    fade.advance(stamp);
    const component::StreamForce answer = model->one->stream.push(stamp, displacement);
    if (!component::isAccepted(answer.acceptance)) {
      fade.end();
      note = "the promoted model was removed because its force was not finite";
      return configured;
    }
    const bool in_place = fade.stage() == RunStage::promoting || fade.stage() == RunStage::promoted;
    beside = in_place ? configured.total : answer.force.total;
    return fade.blend(configured, answer.force);
  }

  // Ends the shadow stage. The cross-fade begins unless the second model had larger errors than the configured model.
  void judgeShadow(const PairedErrors& errors) {
    const bool is_no_worse = errors.samples == 0 || errors.other <= errors.published;
    note = (is_no_worse ? "" : "the model was not promoted because it was worse: ") + describeErrors(errors);
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
      has_six_(description.six != nullptr),
      model_(makeModel(description, max_gap)) {
  for (std::size_t i = 0; i < (has_six_ ? std::size_t{component::kDirections} : 1); ++i) {
    gaps_.emplace_back(has_six_ ? GapMonitor::kCapacity : samples_kept);
  }
}

// Begins a sample: sets the temperature at its stamp. Returns false if the component is disabled.
bool ComponentChannel::begins(std::int64_t stamp, bool finite) {
  if (!counts_.enabled) {
    ++counts_.disabled;
    return false;
  }
  if (finite && temperatures_.take(stamp)) {
    keepTemperature();
  }
  return true;
}

bool ComponentChannel::push(std::int64_t stamp, double displacement, element::ComponentForce& force) {
  double beside = std::numeric_limits<double>::quiet_NaN();
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!begins(stamp, std::isfinite(displacement))) {
      return false;
    }
    const component::StreamForce answer = model_->one->stream.push(stamp, displacement);
    if (!component::isAccepted(answer.acceptance)) {
      return false;
    }
    counts_.beyond_valid += model_->valid && !model_->valid->contains(displacement) ? 1 : 0;
    force = answer.force;
    if (isBeside()) {
      force = promotion_->push(stamp, displacement, answer.force, beside);
      if (promotion_->fade.shadowIsOver()) {
        promotion_->judgeShadow(gap().pairedErrors());
      }
    }
  }
  gap().addSimulated(stamp, displacement, force.total, beside);
  return true;
}

bool ComponentChannel::push(std::int64_t stamp, const Eigen::Vector3d& position, const Eigen::Quaterniond& rotation,
                            component::Wrench& wrench) {
  component::StreamWrench answer;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!begins(stamp, position.allFinite() && rotation.coeffs().allFinite())) {
      return false;
    }
    answer = model_->six->stream.push(stamp, position, rotation);
    if (!component::isAccepted(answer.acceptance)) {
      return false;
    }
    counts_.beyond_rotation += answer.beyond_valid ? 1 : 0;
  }
  wrench = answer.force.wrench;
  for (std::size_t i = 0; i < component::kDirections; ++i) {
    gap(i).addSimulated(stamp, answer.coordinates[static_cast<Eigen::Index>(i)], answer.force.direction[i].total);
  }
  return true;
}

void ComponentChannel::addMeasured(std::int64_t stamp, const component::Wrench& wrench) {
  for (std::size_t i = 0; i < component::kDirections; ++i) {
    const auto axis = static_cast<Eigen::Index>(i % 3);
    gap(i).addMeasured(stamp, i < component::kRx ? wrench.force[axis] : wrench.moment[axis]);
  }
}

// For six directions the monitors store the measured wrench. Its generalised forces depend on the pose and are computed
// here. Samples that are not in all monitors are omitted.
std::vector<std::vector<MatchedSample>> ComponentChannel::windows(double seconds) const {
  std::vector<std::vector<MatchedSample>> windows;
  for (const GapMonitor& gap : gaps_) {
    windows.push_back(gap.window(seconds));
  }
  if (!has_six_) {
    return windows;
  }
  const component::SixDirections component = configured()->six->makeComponent();
  std::vector<std::vector<MatchedSample>> result(windows.size());
  for (const MatchedSample& sample : windows[0]) {
    std::array<MatchedSample, component::kDirections> of;
    component::SixNumbers coordinates;
    component::Wrench measured;
    bool complete = true;
    for (std::size_t i = 0; i < of.size() && complete; ++i) {
      const auto found = std::lower_bound(windows[i].begin(), windows[i].end(), sample.stamp,
                                          [](const MatchedSample& a, std::int64_t stamp) { return a.stamp < stamp; });
      complete = found != windows[i].end() && found->stamp == sample.stamp;
      of[i] = complete ? *found : MatchedSample();
      const auto at = static_cast<Eigen::Index>(i);
      coordinates[at] = of[i].displacement;
      (i < component::kRx ? measured.force : measured.moment)[at % 3] = of[i].measured;
    }
    const component::SixNumbers forces = component.directionForces(component.pose(coordinates), measured);
    for (std::size_t i = 0; i < of.size() && complete; ++i) {
      of[i].measured = forces[static_cast<Eigen::Index>(i)];
      result[i].push_back(of[i]);
    }
  }
  return result;
}

bool ComponentChannel::setTemperature(std::int64_t stamp, double temperature) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!std::isfinite(temperature) ||
      !model_->ask([](const auto& component, const auto& /*stream*/) { return component.temperatures(); })
           .contains(temperature)) {
    ++counts_.refused_temperatures;
    return false;
  }
  temperatures_.add(stamp, temperature);
  return true;
}

// Applies the last measured temperature, which takes precedence over the temperature in a loaded state.
void ComponentChannel::keepTemperature() {
  if (const std::optional<double>& temperature = temperatures_.current()) {
    model_->tell([&](auto& stream) { stream.setTemperature(*temperature); });
    if (promotion_) {
      promotion_->model->one->stream.setTemperature(*temperature);
    }
  }
}

bool ComponentChannel::isBeside() const { return promotion_ && promotion_->fade.stage() != RunStage::configured; }

void ComponentChannel::countLost(std::uint64_t samples) {
  const std::lock_guard<std::mutex> lock(mutex_);
  counts_.lost += samples;
}

void ComponentChannel::reset() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    model_->tell([](auto& stream) { stream.reset(); });
    if (promotion_) {
      promotion_->model->one->stream.reset();
    }
  }
  clearGaps();
}

void ComponentChannel::clearGaps() {
  std::for_each(gaps_.begin(), gaps_.end(), [](GapMonitor& gap) { gap.clear(); });
}

void ComponentChannel::setEnabled(bool enabled) {
  const std::lock_guard<std::mutex> lock(mutex_);
  counts_.enabled = enabled;
}

SavedState ComponentChannel::save() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  SavedState saved{model_->save(), name_, model_->identity(), {}};
  if (isBeside()) {
    saved.promotion = SavedPromotion{promotion_->model->save(), io::toYaml({promotion_->description}),
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
  element::refuseIf(state.component != name_, "the state belongs to component {}; accepted: a state of {}",
                    state.component, name_);
  element::refuseIf(state.model != model->identity(), "{}: the state was saved with other elements or parameters",
                    name_);
  try {
    model->check(state);
    if (!state.promotion) {
      return {};
    }
    const SavedPromotion& saved = *state.promotion;
    const auto parsed = io::parseComponentFile(saved.description, "promotion");
    const io::ComponentDescription beside = io::selectComponent(parsed, name_, "promotion");
    requireOneDirection(*model->described);
    requireOneDirection(beside);
    auto promotion = std::make_shared<Promotion>(beside, max_gap_, promotion_settings_, saved.stage, saved.weight);
    promotion->model->restore(saved);
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
  clearGaps();
  const std::lock_guard<std::mutex> lock(mutex_);
  std::swap(promotion_, promotion);  // the old promotion is freed after the lock
  model_->restore(state);
  keepTemperature();
}

void ComponentChannel::exchange(const std::shared_ptr<Model>& model) {
  std::shared_ptr<Model> old = model;  // is freed after the lock
  std::shared_ptr<Promotion> promotion;
  clearGaps();
  const std::lock_guard<std::mutex> lock(mutex_);
  if (model_->identity() != model->identity()) {
    std::swap(promotion_, promotion);
    note_ = promotion ? "the promotion ended: the component file was reloaded with another model" : "";
    since_ = model_->save().stamp;
  } else {
    model->restore(model_->save());
  }
  model_->ask([&](const auto& /*component*/, const auto& stream) { add(stream.counters(), counts_); });
  std::swap(model_, old);
  keepTemperature();
}

void ComponentChannel::promote(const io::ComponentDescription& description) {
  requireOneDirection(*configured());
  requireOneDirection(description);
  auto promotion = std::make_shared<Promotion>(description, max_gap_, promotion_settings_, RunStage::shadow, 0.0);
  std::shared_ptr<Promotion> finished;
  gap().clearPairedErrors();
  const std::lock_guard<std::mutex> lock(mutex_);
  dropFinished(finished);
  if (promotion_) {
    throw std::invalid_argument(fmt::format("{}: another model is already {}; accepted: promote after a rollback",
                                            name_, toString(promotion_->fade.stage())));
  }
  promotion_ = std::move(promotion);
  keepTemperature();
  note_.clear();
}

void ComponentChannel::rollBack() {
  const std::lock_guard<std::mutex> lock(mutex_);
  element::refuseIf(!isBeside() || promotion_->fade.stage() == RunStage::rolling_back,
                    "{}: no model is promoted; the configured model already gives the force", name_);
  promotion_->note.clear();
  promotion_->fade.giveBack();
}

// Moves a second model that is no longer used to `finished`, which the caller frees after it has released the lock.
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
  std::shared_ptr<Promotion> finished;  // is freed after the lock
  const std::lock_guard<std::mutex> lock(mutex_);
  dropFinished(finished);
  ChannelReport result = counts_;
  result.latency = latency_.take();
  result.valid = model_->valid;
  model_->ask([&](const auto& component, const auto& stream) {
    add(stream.counters(), result);
    result.started = stream.started();
    result.last_time = 1e-9 * static_cast<double>(stream.lastStamp());
    result.shifts_with_temperature = component.shiftsWithTemperature();
  });
  if (has_six_) {
    result.valid_rotation = model_->six->component.laws().valid_rotation;
    result.coordinates = model_->six->stream.state().coordinates();
  } else {
    result.displacement = model_->one->stream.state().displacement();
  }
  result.temperature = temperatures_.current();
  return result;
}

}  // namespace rubber_suspension::node
