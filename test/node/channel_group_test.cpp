// All components at one instant: bundles of samples arrive while states are saved, loaded and reset.
#include "node/channel_group.h"

#include "support/test.h"

namespace rubber_suspension {
namespace {

constexpr std::int64_t kMillisecond = 1000000;

io::ComponentDescription describe(const std::string& name) {
  return {
      name,
      {{"spring", {{"stiffness", {3e6}}}}, {"friction", {{"maximum_force", {6000.0}}, {"displacement", {0.0022}}}}}};
}

class Group : public testing::Test {
 protected:
  Group() {
    std::vector<node::ComponentChannel*> channels;
    for (int i = 0; i < 100; ++i) {
      owned_.push_back(std::make_unique<node::ComponentChannel>(describe("c" + std::to_string(i)), 0.5));
      channels.push_back(owned_.back().get());
    }
    group_ = std::make_unique<node::ChannelGroup>(channels);
  }

  // Returns the number of accepted samples of a bundle.
  std::size_t push(std::int64_t stamp) {
    const auto lock = group_->bundle();
    std::size_t accepted = 0;
    for (node::ComponentChannel* channel : group_->channels()) {
      element::ComponentForce force;
      accepted += channel->push(stamp, 1e-3, force) ? 1 : 0;
    }
    return accepted;
  }

  static std::set<std::int64_t> stamps(const std::vector<node::SavedState>& states) {
    std::set<std::int64_t> result;
    for (const node::SavedState& state : states) {
      result.insert(state.stamp);
    }
    return result;
  }

  std::vector<std::unique_ptr<node::ComponentChannel>> owned_;
  std::unique_ptr<node::ChannelGroup> group_;
};

// A thread sends bundles continuously. Each save contains a single instant, and no load or reset interrupts a bundle.
TEST_F(Group, SavesLoadsAndResetsTearNoBundle) {
  std::atomic<bool> running{true};
  std::atomic<int> torn{0};
  std::atomic<int> sent{0};
  push(kMillisecond);
  std::thread sender([&] {
    for (std::int64_t i = 2; running; ++i, ++sent) {
      const std::size_t accepted = push(i * kMillisecond);
      torn += accepted == group_->channels().size() ? 0 : 1;
    }
  });
  int saves_torn = 0;
  for (int round = 0; round < 300; ++round) {
    const std::vector<node::SavedState> states = group_->save();
    saves_torn += stamps(states).size() == 1 ? 0 : 1;
    std::vector<const node::SavedState*> pointers;
    for (const node::SavedState& state : states) {
      pointers.push_back(&state);
    }
    group_->load(pointers);
    if (round % 3 == 0) {
      group_->reset();
    }
    // Waits until at least one bundle was sent since the last service call.
    for (const int before = sent; sent == before;) {
      std::this_thread::yield();
    }
  }
  running = false;
  sender.join();
  EXPECT_EQ(saves_torn, 0);
  EXPECT_EQ(torn, 0);
}

TEST_F(Group, LoadsAllOrNone) {
  push(kMillisecond);
  std::vector<node::SavedState> states = group_->save();
  push(2 * kMillisecond);
  states.back().memory.push_back(0.0);
  std::vector<const node::SavedState*> pointers;
  for (const node::SavedState& state : states) {
    pointers.push_back(&state);
  }
  EXPECT_THROW(group_->load(pointers), std::invalid_argument);
  EXPECT_EQ(stamps(group_->save()), std::set<std::int64_t>{2 * kMillisecond});
}

}  // namespace
}  // namespace rubber_suspension
