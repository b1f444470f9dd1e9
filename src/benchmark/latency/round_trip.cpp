// Measures round trips through a node.
#include "benchmark/latency/round_trip.h"

#include <fmt/format.h>
#include <ros/init.h>
#include <rubber_suspension/Displacement.h>
#include <rubber_suspension/DisplacementArray.h>
#include <rubber_suspension/Force.h>
#include <rubber_suspension/ForceArray.h>
#include <rubber_suspension/MeasuredForce.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <numeric>
#include <stdexcept>
#include <thread>

#include "ros_interface/connection.h"

namespace rubber_suspension::benchmark {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::uint32_t kQueueSize = 100000;
constexpr double kConnectTimeout = 60.0;  // [s]
constexpr double kLastAnswers = 5.0;      // time that answers under way may take at the end [s]

std::int64_t nanoseconds() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now().time_since_epoch()).count();
}

// Sample number `tick` of a run: stamps 1 ms apart, a slow motion of some millimetres.
ros::Time stampOf(std::uint64_t tick) {
  return ros::Time(1, 0) + ros::Duration().fromNSec(static_cast<std::int64_t>(tick) * 1000000);
}
std::uint64_t tickOf(const ros::Time& stamp) { return (stamp.toNSec() - 1000000000ULL) / 1000000ULL; }
double displacementOf(std::uint64_t tick) { return 2e-3 * std::sin(0.01 * static_cast<double>(tick)); }

// [N], with a reversal smooth enough for any sampling rate.
double measuredForceOf(std::uint64_t tick) {
  return 4e6 * displacementOf(tick) + 800.0 * std::tanh(5.0 * std::cos(0.01 * static_cast<double>(tick)));
}

}  // namespace

// One pair of topics: a component's, or the bundled ones.
class RoundTripMeter::Link {
 public:
  Link(ros::NodeHandle& handle, const std::string& component, bool measured) {
    if (measured) {
      force_publisher_ = handle.advertise<MeasuredForce>(component + "/measured_force", kQueueSize);
    }
    serve<Force>(handle, component + "/displacement", component + "/force", Displacement(),
                 [](Displacement& message, double displacement) { message.displacement = displacement; });
  }

  Link(ros::NodeHandle& handle, const std::vector<std::string>& components) {
    DisplacementArray bundle;
    bundle.components = components;
    serve<ForceArray>(handle, "displacements", "forces", bundle, [](DisplacementArray& message, double displacement) {
      message.displacement.assign(message.components.size(), displacement);
    });
  }

  void connect() {
    const auto end = Clock::now() + std::chrono::duration<double>(kConnectTimeout);
    bool connected = ros_interface::waitForPublishers(subscriber_.getTopic(), kConnectTimeout);
    while (connected && publisher_.getNumSubscribers() == 0) {
      connected = Clock::now() < end && ros::ok();
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    if (!connected) {
      throw std::runtime_error(fmt::format("no node serves {}", publisher_.getTopic()));
    }
  }

  // For a run of that many samples, of which this is the first. Not while answers may come.
  void begin(std::uint64_t first, std::size_t capacity) {
    first_ = first;
    sent_.assign(capacity, kAnswered);
    trips_.clear();
    trips_.reserve(capacity);
    answered_ = 0;
    surplus_ = 0;
  }

  void send(std::uint64_t tick) {
    publish_(tick);
    if (force_publisher_) {
      MeasuredForce force;
      force.header.stamp = stampOf(tick);
      force.force = measuredForceOf(tick);
      force_publisher_.publish(force);
    }
  }

  std::size_t answered() const { return answered_.load(std::memory_order_acquire); }
  std::size_t surplus() const { return surplus_; }
  const std::vector<double>& trips() const { return trips_; }

 private:
  template <class Answer, class Message, class Fill>
  void serve(ros::NodeHandle& handle, const std::string& in, const std::string& out, Message message, Fill fill) {
    publisher_ = handle.advertise<Message>(in, kQueueSize);
    publish_ = [this, message, fill](std::uint64_t tick) mutable {
      message.header.stamp = stampOf(tick);
      fill(message, displacementOf(tick));
      sent_[tick - first_] = nanoseconds();
      publisher_.publish(message);
    };
    const boost::function<void(const boost::shared_ptr<const Answer>&)> callback =
        [this](const boost::shared_ptr<const Answer>& answer) { take(answer->header.stamp); };
    subscriber_ =
        handle.subscribe<Answer>(out, kQueueSize, callback, ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay());
  }

  void take(const ros::Time& stamp) {
    const std::int64_t now = nanoseconds();
    const std::uint64_t index = tickOf(stamp) - first_;
    if (index >= sent_.size() || sent_[index] == kAnswered) {
      ++surplus_;
      return;
    }
    trips_.push_back(1e-9 * static_cast<double>(now - sent_[index]));
    sent_[index] = kAnswered;
    answered_.fetch_add(1, std::memory_order_release);
  }

  ros::Publisher force_publisher_;  // where forces are measured
  ros::Publisher publisher_;
  std::function<void(std::uint64_t tick)> publish_;
  ros::Subscriber subscriber_;
  static constexpr std::int64_t kAnswered = -1;
  std::uint64_t first_ = 0;
  std::vector<std::int64_t> sent_;  // when, by tick since the first [ns]
  std::vector<double> trips_;       // written by the receiving thread
  std::atomic<std::size_t> answered_{0};
  std::atomic<std::size_t> surplus_{0};
};

RoundTripMeter::RoundTripMeter(const std::string& space, const std::vector<std::string>& components, bool bundled,
                               bool measured) {
  ros::NodeHandle handle(space);
  handle.setCallbackQueue(&receiver_.queue());
  if (bundled) {
    links_.push_back(std::make_unique<Link>(handle, components));
  } else {
    for (const std::string& component : components) {
      links_.push_back(std::make_unique<Link>(handle, component, measured));
    }
  }
  receiver_.start("receiver", 0);
}

RoundTripMeter::~RoundTripMeter() { receiver_.stop(); }

void RoundTripMeter::connect() {
  for (auto& link : links_) {
    link->connect();
  }
}

std::size_t RoundTripMeter::answered() const {
  return std::accumulate(links_.begin(), links_.end(), std::size_t{0},
                         [](std::size_t sum, const auto& link) { return sum + link->answered(); });
}

template <class Due>
RoundTrips RoundTripMeter::run(std::uint64_t most, Due isDue) {
  for (auto& link : links_) {
    link->begin(next_, most);
  }
  const auto start = Clock::now();
  std::uint64_t tick = 0;
  while (tick < most && ros::ok() && isDue(tick, Clock::now() - start)) {
    for (auto& link : links_) {
      link->send(next_);
    }
    ++next_;
    ++tick;
  }
  RoundTrips result;
  result.sent = tick * links_.size();
  const auto end = Clock::now() + std::chrono::duration<double>(kLastAnswers);
  while (answered() < result.sent && Clock::now() < end) {
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
  result.elapsed = std::chrono::duration<double>(Clock::now() - start).count();
  for (const auto& link : links_) {
    result.surplus += link->surplus();
    // Only as many as were counted: a straggler may still be at work.
    const auto count = static_cast<std::ptrdiff_t>(link->answered());
    result.durations.insert(result.durations.end(), link->trips().begin(), link->trips().begin() + count);
  }
  std::sort(result.durations.begin(), result.durations.end());
  return result;
}

RoundTrips RoundTripMeter::atRate(double rate, double duration) {
  const std::chrono::duration<double> period(1.0 / rate);
  return run(static_cast<std::uint64_t>(std::llround(rate * duration)), [=](std::uint64_t tick, auto elapsed) {
    std::this_thread::sleep_for(tick * period - elapsed);
    return true;
  });
}

RoundTrips RoundTripMeter::flood(double duration, std::size_t under_way, std::uint64_t most) {
  const std::chrono::duration<double> long_enough(duration);
  return run(most, [&](std::uint64_t tick, Clock::duration elapsed) {
    const auto start = Clock::now() - elapsed;
    while (tick * links_.size() >= answered() + under_way * links_.size() && Clock::now() - start < long_enough) {
      std::this_thread::sleep_for(std::chrono::microseconds(20));
    }
    return Clock::now() - start < long_enough;
  });
}

}  // namespace rubber_suspension::benchmark
