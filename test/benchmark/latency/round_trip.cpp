// Measures round trips through a node.
#include <fmt/format.h>
#include <ros/callback_queue.h>
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
#include <thread>

#include "benchmark/latency/benchmark_node.h"
#include "element/refuse.h"
#include "ros_interface/connection.h"

namespace rubber_suspension::benchmark {
namespace {

using Steady = std::chrono::steady_clock;

constexpr std::uint32_t kQueueSize = 100000;
constexpr double kConnectTimeout = 60.0;  // [s]
constexpr double kLastAnswers = 5.0;      // time to wait for late answers at the end [s]

// Functions of the sample number `tick`: stamps are 1 ms apart, and the motion is slow with an amplitude of 2 mm.
ros::Time stampOf(std::uint64_t tick) {
  return ros::Time(1, 0) + ros::Duration().fromNSec(static_cast<std::int64_t>(tick) * 1000000);
}
std::uint64_t tickOf(const ros::Time& stamp) { return (stamp.toNSec() - 1000000000ULL) / 1000000ULL; }
double displacementOf(std::uint64_t tick) { return 2e-3 * std::sin(0.01 * static_cast<double>(tick)); }

// Returns a measured force [N], with friction that reverses smoothly at any sampling rate.
double measuredForceOf(std::uint64_t tick) {
  return 4e6 * displacementOf(tick) + 800.0 * std::tanh(5.0 * std::cos(0.01 * static_cast<double>(tick)));
}

}  // namespace

// One pair of topics: those of a component, or the bundled topics.
struct RoundTripMeter::Link {
  Link(ros::NodeHandle& handle, const std::string& component, bool measured) {
    if (measured) {
      force_publisher = handle.advertise<MeasuredForce>(component + "/measured_force", kQueueSize);
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
    const auto heard = [this] { return publisher.getNumSubscribers() > 0; };
    element::refuseIf<std::runtime_error>(
        !ros_interface::waitForPublishers(subscriber.getTopic(), kConnectTimeout) ||
            !ros_interface::waitFor(*ros::getGlobalCallbackQueue(), kConnectTimeout, heard),
        "no node serves {}", publisher.getTopic());
  }

  // Prepares a run of `capacity` samples that begins with this number. No answers may arrive during the call.
  void begin(std::uint64_t number, std::size_t capacity) {
    first = number;
    sent.assign(capacity, kAnswered);
    trips.clear();
    trips.reserve(capacity);
    answered = 0;
    surplus = 0;
  }

  void send(std::uint64_t tick) {
    publish(tick);
    if (force_publisher) {
      MeasuredForce force;
      force.header.stamp = stampOf(tick);
      force.force = measuredForceOf(tick);
      force_publisher.publish(force);
    }
  }

  template <class Answer, class Message, class Fill>
  void serve(ros::NodeHandle& handle, const std::string& in, const std::string& out, Message message, Fill fill) {
    publisher = handle.advertise<Message>(in, kQueueSize);
    publish = [this, message, fill](std::uint64_t tick) mutable {
      message.header.stamp = stampOf(tick);
      fill(message, displacementOf(tick));
      sent[tick - first] = Steady::now();
      publisher.publish(message);
    };
    const boost::function<void(const boost::shared_ptr<const Answer>&)> callback =
        [this](const boost::shared_ptr<const Answer>& answer) { take(answer->header.stamp); };
    subscriber =
        handle.subscribe<Answer>(out, kQueueSize, callback, ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay());
  }

  void take(const ros::Time& stamp) {
    const auto now = Steady::now();
    const std::uint64_t index = tickOf(stamp) - first;
    if (index >= sent.size() || sent[index] == kAnswered) {
      ++surplus;
      return;
    }
    trips.push_back(std::chrono::duration<double>(now - sent[index]).count());
    sent[index] = kAnswered;
    answered.fetch_add(1, std::memory_order_release);
  }

  ros::Publisher force_publisher;  // used only if forces are measured
  ros::Publisher publisher;
  std::function<void(std::uint64_t tick)> publish;
  ros::Subscriber subscriber;
  static constexpr Steady::time_point kAnswered{};
  std::uint64_t first = 0;
  std::vector<Steady::time_point> sent;  // index: number of ticks since the first
  std::vector<double> trips;             // written by the receiving thread
  std::atomic<std::size_t> answered{0};
  std::atomic<std::size_t> surplus{0};
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
  for (auto& link : links_) {
    link->connect();
  }
  receiver_.start("receiver", 0);
}

RoundTripMeter::~RoundTripMeter() { receiver_.stop(); }

std::size_t RoundTripMeter::answered() const {
  return std::accumulate(links_.begin(), links_.end(), std::size_t{0}, [](std::size_t sum, const auto& link) {
    return sum + link->answered.load(std::memory_order_acquire);
  });
}

template <class Due>
RoundTrips RoundTripMeter::run(std::uint64_t most, Due isDue) {
  for (auto& link : links_) {
    link->begin(next_, most);
  }
  const auto start = Steady::now();
  std::uint64_t tick = 0;
  while (tick < most && ros::ok() && isDue(tick, Steady::now() - start)) {
    for (auto& link : links_) {
      link->send(next_);
    }
    ++next_;
    ++tick;
  }
  RoundTrips result;
  result.sent = tick * links_.size();
  const auto end = Steady::now() + std::chrono::duration<double>(kLastAnswers);
  while (answered() < result.sent && Steady::now() < end) {
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
  result.elapsed = std::chrono::duration<double>(Steady::now() - start).count();
  for (const auto& link : links_) {
    result.surplus += link->surplus.load();
    // A late answer may still be added, so the loop reads only as many trips as were counted.
    const auto count = static_cast<std::ptrdiff_t>(link->answered.load(std::memory_order_acquire));
    result.durations.insert(result.durations.end(), link->trips.begin(), link->trips.begin() + count);
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
  return run(most, [&](std::uint64_t tick, Steady::duration elapsed) {
    const auto start = Steady::now() - elapsed;
    while (tick * links_.size() >= answered() + under_way * links_.size() && Steady::now() - start < long_enough) {
      std::this_thread::sleep_for(std::chrono::microseconds(20));
    }
    return Steady::now() - start < long_enough;
  });
}

}  // namespace rubber_suspension::benchmark
