// The time to save a consistent state: bundles with a lock on all components, and saves compared with bundles.
#include <fmt/format.h>

#include "benchmark/cases.h"
#include "benchmark/example.h"
#include "node/channel_group.h"

namespace rubber_suspension::benchmark {
namespace {

// Bundles for the components of a node, with and without the lock.
struct BundleBench {
  std::vector<std::unique_ptr<node::ComponentChannel>> channels;
  std::unique_ptr<node::ChannelGroup> group;
  std::vector<double> displacement;
  std::vector<std::int64_t> stamps;
  std::vector<double> library;
  std::vector<double> bare;
  std::size_t saved = 0;

  BundleBench(std::size_t components, std::size_t samples)
      : displacement(benchmarkDisplacement(std::max<std::size_t>(2, samples / components))),
        stamps(stampsOf(Stamps::even, displacement.size())),
        library(displacement.size() * components),
        bare(library.size()) {
    constexpr double kMaxGap = 0.5;  // [s], the value of the node
    std::vector<node::ComponentChannel*> pointers;
    for (std::size_t i = 0; i < components; ++i) {
      const io::ComponentDescription description{fmt::format("component_{:03d}", i), ExampleParameters().elements()};
      channels.push_back(std::make_unique<node::ComponentChannel>(description, kMaxGap));
      pointers.push_back(channels.back().get());
    }
    group = std::make_unique<node::ChannelGroup>(pointers);
  }

  template <bool locked>
  void push() {
    group->reset();
    std::vector<double>& forces = locked ? library : bare;
    for (std::size_t sample = 0; sample < stamps.size(); ++sample) {
      const auto lock = locked ? group->bundle() : std::shared_lock<std::shared_mutex>();
      for (std::size_t i = 0; i < channels.size(); ++i) {
        element::ComponentForce parts;
        channels[i]->push(stamps[sample], displacement[sample], parts);
        forces[sample * channels.size() + i] = parts.total;
      }
    }
  }

  // Bundles wait while the states of all components are copied, but not while the file is written.
  static constexpr std::size_t kSaves = 100;
  void save() {
    saved = 0;
    for (std::size_t i = 0; i < kSaves; ++i) {
      for (const node::SavedState& state : group->save()) {
        saved += state.stamp == stamps.back() ? 1 : 0;
      }
    }
  }
};

Case lockCase(std::size_t components, std::size_t samples, double most) {
  const auto bench = std::make_shared<BundleBench>(components, samples);
  const std::string of = components == 1 ? "one component" : fmt::format("{} components", components);
  Case result = forceCase(bench, fmt::format("the node's bundle of {}, under the lock that a save takes alone", of),
                          &BundleBench::push<true>, "the same without that lock", &BundleBench::push<false>);
  result.unit = "bundle";
  result.count = result.baseline_count = static_cast<double>(bench->displacement.size());
  result.tolerance = 0.0;
  result.most = most;
  return result;
}

Case saveCase(std::size_t components, std::size_t samples) {
  const auto bench = std::make_shared<BundleBench>(components, samples);
  Case result = forceCase(bench, fmt::format("the node's states of {} components copied at one instant", components),
                          &BundleBench::save, "one bundle of theirs, under the lock", &BundleBench::push<true>);
  result.unit = "save";
  result.count = BundleBench::kSaves;
  result.baseline_count = static_cast<double>(bench->displacement.size());
  result.error = [bench, wanted = components * BundleBench::kSaves] {
    return static_cast<double>(wanted) - static_cast<double>(bench->saved);
  };
  result.error_meaning = "states of another instant";
  result.tolerance = 0.0;
  return result;
}

}  // namespace

std::vector<Case> bundleCases(const BenchmarkSize& size) {
  // A lock takes two atomic operations, some 10 ns without contention, and a sample takes 20 ns. A ratio of two would
  // mean another kind of lock. With fifty components, only effects of the memory layout of the code remain.
  constexpr double kMostOfOne = 2.0;
  constexpr double kMostOfFifty = 1.1;
  return {lockCase(1, size.samples, kMostOfOne), lockCase(50, size.samples, kMostOfFifty), saveCase(50, size.samples)};
}

}  // namespace rubber_suspension::benchmark
