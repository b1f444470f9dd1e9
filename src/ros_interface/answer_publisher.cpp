// A publisher that loses no message of a burst, and counts the messages that slow subscribers lose.
#include "ros_interface/answer_publisher.h"

#include <ros/init.h>
#include <ros/poll_manager.h>
#include <ros/publication.h>
#include <ros/subscriber_link.h>

#include <atomic>
#include <boost/make_shared.hpp>
#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "node/loss_count.h"

namespace rubber_suspension::ros_interface {

/// Follows the turns of roscpp's network thread. There is at most one object per process. In each turn the thread first
/// passes all published messages to the queues of the subscribers, where a full queue drops its oldest message, and
/// then reads and writes the sockets.
class NetworkTurns {
 public:
  static std::shared_ptr<NetworkTurns> get() {
    static std::mutex mutex;
    static std::weak_ptr<NetworkTurns> existing;
    const std::lock_guard<std::mutex> lock(mutex);
    std::shared_ptr<NetworkTurns> result = existing.lock();
    if (!result) {
      existing = result = std::make_shared<NetworkTurns>();
    }
    return result;
  }

  // roscpp's own listener passes the messages on. It was added earlier, so it is called first.
  NetworkTurns() : listener_(ros::PollManager::instance()->addPollThreadListener([this] { end(); })) {}
  ~NetworkTurns() { ros::PollManager::instance()->removePollThreadListener(listener_); }

  // The network thread calls this.
  void add(const boost::shared_ptr<AnswerLink>& link) { links_.push_back(link); }

 private:
  void end();

  std::vector<boost::shared_ptr<AnswerLink>> links_;  // links that have passed on messages in this turn
  boost::signals2::connection listener_;
};

/// The first subscriber of a topic. roscpp offers it each message before all others, and it takes none.
class AnswerLink : public ros::SubscriberLink {
 public:
  AnswerLink(const ros::PublicationPtr& publication, std::uint32_t queue_size)
      // One turn may pass on half of a queue, so that an empty queue has room for two turns.
      : most_ahead_(queue_size / 2), losses_(queue_size) {
    parent_ = publication;
    topic_ = publication->getName();
    destination_caller_id_ = "counter of this node";
  }

  void enqueueMessage(const ros::SerializedMessage& message, bool /*serialized*/, bool /*nocopy*/) override {
    undelivered += losses_.end() ? 1 : 0;
    if (!std::exchange(in_turn_, true)) {
      turns_->add(boost::static_pointer_cast<AnswerLink>(shared_from_this()));
    }
    losses_.begin(message.buf);
    ++handed_over_;
  }

  // The network thread calls this before it writes sockets, so only a full queue can have released a message.
  void endTurn() {
    undelivered += losses_.end() ? 1 : 0;
    in_turn_ = false;
    wake();
  }

  // Waits until the network thread has passed on enough messages or has ended. Only polling detects the end of the
  // thread.
  void waitForRoom() {
    constexpr std::chrono::milliseconds kLook(10);
    const auto may_go_on = [&] { return published - handed_over_ < most_ahead_ || stopped_ || ros::isShuttingDown(); };
    if (!may_go_on()) {
      std::unique_lock<std::mutex> lock(mutex_);
      while (!room_.wait_for(lock, kLook, may_go_on)) {
      }
    }
  }

  void stop() {
    stopped_ = true;
    wake();
  }

  void drop() override {}
  std::string getTransportType() override { return "none"; }
  std::string getTransportInfo() override { return "counts messages that are lost"; }
  void getPublishTypes(bool& serialized, bool& nocopy, const std::type_info& /*type*/) override {
    serialized = nocopy = false;
  }

  std::atomic<std::uint64_t> published{0};
  std::atomic<std::uint64_t> undelivered{0};

 private:
  // Wakes waitForRoom(). The lock prevents a change between its check of the condition and its wait.
  void wake() {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
    }
    room_.notify_all();
  }

  const std::uint64_t most_ahead_;
  const std::shared_ptr<NetworkTurns> turns_ = NetworkTurns::get();
  std::atomic<std::uint64_t> handed_over_{0};
  std::atomic<bool> stopped_{false};
  std::mutex mutex_;
  std::condition_variable room_;
  node::LossCount losses_;  // used by the network thread only
  bool in_turn_ = false;    // used by the network thread only
};

void NetworkTurns::end() {
  const auto links = std::exchange(links_, {});  // the destructor of the last link may destroy this object
  for (const auto& link : links) {
    link->endTurn();
  }
}

// Advertises the topic. Repeats this if a subscriber connects before the link, which would miss its losses.
void AnswerPublisher::advertise(ros::NodeHandle& handle, ros::AdvertiseOptions& options) {
  int attempts = 0;
  do {
    shutdown();
    publisher_ = handle.advertise(options);
    publication_ = ros::TopicManager::instance()->lookupPublication(publisher_.getTopic());
    link_ = boost::make_shared<AnswerLink>(publication_, options.queue_size);
    publication_->addSubscriberLink(link_);
  } while (publication_->getNumSubscribers() > 1 && ++attempts < 5);
}

void AnswerPublisher::send(const boost::function<ros::SerializedMessage()>& serialized,
                           ros::SerializedMessage& unserialized) {
  if (publication_->getNumSubscribers() <= 1) {
    publication_->incrementSequence();  // roscpp also does so for a message without subscribers
    return;
  }
  link_->waitForRoom();
  const auto counted = [&] {
    ++link_->published;
    return serialized();
  };
  ros::TopicManager::instance()->publish(publication_->getName(), counted, unserialized);
}

std::uint64_t AnswerPublisher::undelivered() const { return link_ ? link_->undelivered.load() : 0; }

void AnswerPublisher::shutdown() {
  if (link_) {
    link_->stop();
    publication_->removeSubscriberLink(link_);
  }
  publisher_.shutdown();
}

}  // namespace rubber_suspension::ros_interface
