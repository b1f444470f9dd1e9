// One component of the node: its samples, its counters, its state.
#include "node/component_channel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
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

// All that a component of six directions consists of, as if it had one: a state of it fits no other.
std::vector<element::ElementDescription> listed(const component::SixDirectionsLaws& laws) {
  const auto numbers = [](const Eigen::Isometry3d& frame) {
    return std::vector<double>(frame.matrix().data(), frame.matrix().data() + frame.matrix().size());
  };
  std::vector<element::ElementDescription> list = {
      {"arrangement",
       {{"coupling", {static_cast<double>(laws.translation), static_cast<double>(laws.rotation)}},
        {"axis", {static_cast<double>(laws.axis)}},
        {"measure", {static_cast<double>(laws.measure)}},
        {"on_a", numbers(laws.on_a)},
        {"on_b", numbers(laws.on_b)}}}};
  for (std::size_t i = 0; i < component::kDirections; ++i) {
    for (const element::ElementDescription& element : laws.elements[i]) {
      list.push_back({fmt::format("{}.{}", component::toString(static_cast<component::Direction>(i)), element.type),
                      element.values});
    }
  }
  return list;
}

// Refuses a model that cannot be computed beside another.
void requireOneDirection(const io::ComponentDescription& description) {
  if (description.six) {
    throw std::invalid_argument(fmt::format(
        "{}: a component of six directions cannot be promoted; accepted: one of one direction", description.name));
  }
}

// The samples that all windows have, of stamps that increase in each.
void keepCommonStamps(std::vector<std::vector<MatchedSample>>& windows) {
  const auto earlier = [](const MatchedSample& a, const MatchedSample& b) { return a.stamp < b.stamp; };
  std::vector<MatchedSample> common = windows[0];
  for (const auto& window : windows) {
    std::vector<MatchedSample> both;
    std::set_intersection(common.begin(), common.end(), window.begin(), window.end(), std::back_inserter(both),
                          earlier);
    common = std::move(both);
  }
  for (auto& window : windows) {
    window.erase(std::remove_if(window.begin(), window.end(),
                                [&](const MatchedSample& sample) {
                                  return !std::binary_search(common.begin(), common.end(), sample, earlier);
                                }),
                 window.end());
  }
}

}  // namespace

class ComponentChannel::Model {
 public:
  Model(const io::ComponentDescription& description, double max_gap)
      : described(std::make_shared<const io::ComponentDescription>(description)),
        sha256(io::sha256(io::toYaml({description}))),
        valid(description.six ? std::nullopt : description.validDisplacement()) {
    if (description.six) {
      six_.emplace(description, max_gap);
    } else {
      one_.emplace(description, max_gap);
    }
  }
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;

  component::SampleStream& samples() { return one_->stream; }
  component::PoseStream& poses() { return six_->stream; }
  const component::SixDirections& six() const { return six_->component; }
  const component::SixDirectionsState& place() const { return six_->stream.state(); }

  // What is asked of either.
  template <class Ask>
  auto ask(Ask question) const {
    return six_ ? question(*six_) : question(*one_);
  }
  template <class Do>
  void tell(Do order) {
    six_ ? order(*six_) : order(*one_);
  }

  std::vector<element::ElementDescription> elements() const {
    return ask([](const auto& model) { return model.elements(); });
  }
  SavedStream save() const {
    return ask([](const auto& model) { return model.save(); });
  }
  void restore(const SavedStream& saved) {
    tell([&](auto& model) { saved.started ? model.restore(saved) : model.stream.reset(); });
  }
  void reset() {
    tell([](auto& model) { model.stream.reset(); });
  }
  void setTemperature(double temperature) {
    tell([&](auto& model) { model.stream.setTemperature(temperature); });
  }
  component::StreamCounters counters() const {
    return ask([](const auto& model) { return model.stream.counters(); });
  }
  std::int64_t lastStamp() const {
    return ask([](const auto& model) { return model.stream.lastStamp(); });
  }

  const std::shared_ptr<const io::ComponentDescription> described;
  const std::string sha256;
  const std::optional<element::Range> valid;  // [m]

 private:
  // A component with its stream, which refers to it, so the two stay at one address.
  struct OneDirection {
    OneDirection(const io::ComponentDescription& description, double max_gap)
        : component(description.makeComponent()), stream(component, max_gap) {}

    std::vector<element::ElementDescription> elements() const { return component.elements(); }
    SavedStream save() const {
      return {stream.started(), stream.lastStamp(), stream.state().displacement(), stream.state().memory()};
    }
    void restore(const SavedStream& saved) { stream.deserialise(saved.stamp, saved.displacement, saved.memory); }
    void check(const SavedStream& saved) const {
      component::ComponentState state = component.makeState();
      component.restore(state, saved.displacement, saved.memory);
    }

    const component::Component component;
    component::SampleStream stream;
  };

  struct SixDirections {
    SixDirections(const io::ComponentDescription& description, double max_gap)
        : component(description.six->makeComponent()), stream(component, max_gap) {}

    std::vector<element::ElementDescription> elements() const { return listed(component.laws()); }
    SavedStream save() const { return {stream.started(), stream.lastStamp(), 0.0, stream.state().numbers()}; }
    void restore(const SavedStream& saved) { stream.deserialise(saved.stamp, saved.memory); }
    void check(const SavedStream& saved) const {
      component::SixDirectionsState state = component.makeState();
      component.restore(state, saved.memory);
    }

    const component::SixDirections component;
    component::PoseStream stream;
  };

  std::optional<OneDirection> one_;
  std::optional<SixDirections> six_;
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
    const component::StreamForce answer = model->samples().push(stamp, displacement);
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
      has_six_(description.six != nullptr),
      model_(makeModel(description, max_gap)) {
  for (std::size_t i = 0; i < (has_six_ ? component::kDirections : 1); ++i) {
    gaps_.emplace_back(has_six_ ? GapMonitor::kCapacity : samples_kept);
  }
}

// Whether a sample may go to the model, at the temperature of its stamp.
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
    const component::StreamForce answer = model_->samples().push(stamp, displacement);
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
    answer = model_->poses().push(stamp, position, rotation);
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

// The monitors hold a wrench as it was measured, in A's axes: what it comes to in the directions is up to the pose.
std::vector<std::vector<MatchedSample>> ComponentChannel::windows(double seconds) const {
  std::vector<std::vector<MatchedSample>> windows;
  for (const GapMonitor& gap : gaps_) {
    windows.push_back(gap.window(seconds));
  }
  if (!has_six_) {
    return windows;
  }
  keepCommonStamps(windows);
  std::shared_ptr<const Model> model;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    model = model_;
  }
  for (std::size_t n = 0; n < windows[0].size(); ++n) {
    component::SixNumbers coordinates;
    component::SixNumbers measured;
    for (Eigen::Index i = 0; i < 6; ++i) {
      coordinates[i] = windows[static_cast<std::size_t>(i)][n].displacement;
      measured[i] = windows[static_cast<std::size_t>(i)][n].measured;
    }
    const component::SixNumbers forces =
        model->six().directionForces(model->six().pose(coordinates), {measured.head<3>(), measured.tail<3>()});
    for (Eigen::Index i = 0; i < 6; ++i) {
      windows[static_cast<std::size_t>(i)][n].measured = forces[i];
    }
  }
  return windows;
}

bool ComponentChannel::setTemperature(std::int64_t stamp, double temperature) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!std::isfinite(temperature) ||
      !model_->ask([](const auto& model) { return model.component.temperatures(); }).contains(temperature)) {
    ++counts_.refused_temperatures;
    return false;
  }
  temperatures_.add(stamp, temperature);
  return true;
}

// The temperature that was measured last holds, whatever the state says.
void ComponentChannel::keepTemperature() {
  if (const std::optional<double>& temperature = temperatures_.current()) {
    model_->setTemperature(*temperature);
    if (promotion_) {
      promotion_->model->setTemperature(*temperature);
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
    model_->reset();
    if (promotion_) {
      promotion_->model->reset();
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
  SavedState saved{model_->save(), name_, model_->elements(), {}};
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
  if (state.component != name_) {
    throw std::invalid_argument(fmt::format("state of component {} does not belong to {}", state.component, name_));
  }
  if (!sameElements(state.elements, model->elements())) {
    throw std::invalid_argument(fmt::format("{}: the state was saved with other elements or parameters", name_));
  }
  try {
    model->ask([&](const auto& of) { of.check(state); });
    if (!state.promotion) {
      return {};
    }
    const SavedPromotion& saved = *state.promotion;
    const auto parsed = io::parseComponentFile(saved.description, "promotion");
    const io::ComponentDescription& beside = io::selectComponent(parsed, name_, "promotion");
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
  std::swap(promotion_, promotion);  // freed after the lock
  model_->restore(state);
  keepTemperature();
}

void ComponentChannel::exchange(const std::shared_ptr<Model>& model) {
  std::shared_ptr<Model> old = model;  // freed after the lock
  std::shared_ptr<Promotion> promotion;
  clearGaps();
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!sameElements(model_->elements(), model->elements())) {
    std::swap(promotion_, promotion);
    note_ = promotion ? "the component file was read again and has another model" : "";
    since_ = model_->lastStamp();
  } else {
    model->restore(model_->save());
  }
  add(model_->counters(), counts_);
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
  ChannelReport result = counts_;
  counts_.latency = {};
  add(model_->counters(), result);
  result.valid = model_->valid;
  result.last_time = 1e-9 * static_cast<double>(model_->lastStamp());
  if (has_six_) {
    result.valid_rotation = model_->six().laws().valid_rotation;
    result.coordinates = model_->place().coordinates();
  } else {
    result.displacement = model_->samples().state().displacement();
  }
  result.started = model_->ask([](const auto& model) { return model.stream.started(); });
  result.shifts_with_temperature =
      model_->ask([](const auto& model) { return model.component.shiftsWithTemperature(); });
  result.temperature = temperatures_.current();
  return result;
}

}  // namespace rubber_suspension::node
