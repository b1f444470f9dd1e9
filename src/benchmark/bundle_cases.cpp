// What it costs that a saved state is one instant: bundles under the lock of all components, and a save against them.
#include <fmt/format.h>

#include <memory>

#include "benchmark/bare_loop.h"
#include "benchmark/cases.h"
#include "benchmark/test_signal.h"
#include "node/channel_group.h"

namespace rubber_suspension::benchmark {
namespace {

constexpr double kMaxGap = 0.5;  // [s], that of the node

// Components as the node holds them.
class Channels {
 public:
  explicit Channels(int count) {
    std::vector<node::ComponentChannel*> pointers;
    for (int i = 0; i < count; ++i) {
      const io::ComponentDescription description{fmt::format("component_{:03d}", i), elementsOf(bareParameters(5))};
      owned_.push_back(std::make_unique<node::ComponentChannel>(description, kMaxGap));
      pointers.push_back(owned_.back().get());
    }
    group_ = std::make_unique<node::ChannelGroup>(pointers);
  }

  node::ChannelGroup& group() { return *group_; }

  // The components without what holds them together.
  void push(std::int64_t stamp, double displacement, double* force) const {
    for (const auto& channel : owned_) {
      element::ComponentForce parts;
      channel->push(stamp, displacement, parts);
      *force++ = parts.total;
    }
  }

 private:
  std::vector<std::unique_ptr<node::ComponentChannel>> owned_;
  std::unique_ptr<node::ChannelGroup> group_;
};

// As many bundles for as many components twice: under the lock, and without.
struct Bench {
  Channels channels;
  std::vector<double> displacement;
  std::vector<std::int64_t> stamps;
  std::vector<double> locked;
  std::vector<double> bare;

  Bench(int components, std::size_t samples)
      : channels(components),
        displacement(benchmarkDisplacement(std::max<std::size_t>(2, samples / static_cast<std::size_t>(components)))),
        stamps(evenStamps(displacement.size())),
        locked(displacement.size() * static_cast<std::size_t>(components)),
        bare(locked.size()) {}

  std::size_t components() const { return locked.size() / displacement.size(); }

  void pushLocked() {
    channels.group().reset();
    for (std::size_t i = 0; i < displacement.size(); ++i) {
      const auto lock = channels.group().bundle();
      channels.push(stamps[i], displacement[i], &locked[i * components()]);
    }
  }

  void pushBare() {
    channels.group().reset();
    for (std::size_t i = 0; i < displacement.size(); ++i) {
      channels.push(stamps[i], displacement[i], &bare[i * components()]);
    }
  }
};

Case lockCase(int components, std::size_t samples, double most) {
  const auto bench = std::make_shared<Bench>(components, samples);
  Case result;
  result.name = fmt::format("the node's bundle of {}, under the lock that a save takes alone",
                            components == 1 ? "one component" : fmt::format("{} components", components));
  result.baseline = "the same without that lock";
  result.unit = "bundle";
  result.count = result.baseline_count = static_cast<double>(bench->displacement.size());
  result.library = [bench] { bench->pushLocked(); };
  result.bare = [bench] { bench->pushBare(); };
  result.error = [bench] { return relativeDifference(bench->bare, bench->locked); };
  result.error_meaning = "of the largest force";
  result.most = most;
  return result;
}

// Bundles wait while the states of all components are copied; the file is written afterwards.
Case saveCase(int components, std::size_t samples) {
  const auto bench = std::make_shared<Bench>(components, samples);
  constexpr int kSaves = 100;
  const auto saved = std::make_shared<std::size_t>(0);
  Case result;
  result.name = fmt::format("the node's states of {} components copied at one instant", components);
  result.baseline = "one bundle of theirs, under the lock";
  result.unit = "save";
  result.count = kSaves;
  result.baseline_count = static_cast<double>(bench->displacement.size());
  result.library = [bench, saved] {
    *saved = 0;
    for (int i = 0; i < kSaves; ++i) {
      for (const node::SavedState& state : bench->channels.group().save()) {
        *saved += state.stamp == bench->stamps.back() ? 1 : 0;
      }
    }
  };
  result.bare = [bench] { bench->pushLocked(); };
  result.error = [saved, components] { return static_cast<double>(kSaves * components) - static_cast<double>(*saved); };
  result.error_meaning = "states of another instant";
  return result;
}

}  // namespace

std::vector<Case> bundleCases(const BenchmarkSize& size) {
  // A lock and its release are two atomic operations, some 10 ns where nobody else wants it, and a sample takes 20 ns:
  // a lock of twice that price would be another kind of lock. Of fifty components nothing may be seen beyond what the
  // layout of the code does to both.
  constexpr double kMostOfOne = 2.0;
  constexpr double kMostOfFifty = 1.1;
  return {lockCase(1, size.samples, kMostOfOne), lockCase(50, size.samples, kMostOfFifty), saveCase(50, size.samples)};
}

}  // namespace rubber_suspension::benchmark
