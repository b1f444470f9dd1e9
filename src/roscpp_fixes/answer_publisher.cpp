// A publisher that loses no burst and counts what slow subscribers lose.
#include "roscpp_fixes/answer_publisher.h"

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

#include "roscpp_fixes/loss_count.h"

namespace rubber_suspension::roscpp_fixes {
namespace {

constexpr const char* kNoTransport = "none";

}  // namespace

/// Where roscpp's network thread has handed over all that was published; one for the process. That thread goes round
/// and round: it first hands all messages that were published to the subscribers, where each queue that is full loses
/// its oldest, then it reads and writes the sockets.
class NetworkTurns {
 public:
  static std::shared_ptr<NetworkTurns> get() {
    static std::mutex mutex;
    static std::weak_ptr<NetworkTurns> existing;
    const std::lock_guard<std::mutex> lock(mutex);
    std::shared_ptr<NetworkTurns> result = existing.lock();
    if (!result) {
      existing = result = std::make_shared<NetworkTurns>();
      result->self_ = result;
    }
    return result;
  }

  // roscpp's own listener, which hands over, was there before and is called before.
  NetworkTurns() : listener_(ros::PollManager::instance()->addPollThreadListener([this] { end(); })) {}
  NetworkTurns(const NetworkTurns&) = delete;
  NetworkTurns& operator=(const NetworkTurns&) = delete;
  ~NetworkTurns() { ros::PollManager::instance()->removePollThreadListener(listener_); }

  // By the network thread: this one is to be told of the turn's end.
  void add(const boost::shared_ptr<AnswerLink>& link) { links_.push_back(link); }

 private:
  void end();

  std::vector<boost::shared_ptr<AnswerLink>> links_;  // of this turn
  std::weak_ptr<NetworkTurns> self_;
  boost::signals2::connection listener_;
};

/// Stands first among the subscribers of a topic, sees each message before the others, and wants none.
class AnswerLink : public ros::SubscriberLink {
 public:
  AnswerLink(const ros::PublicationPtr& publication, std::uint32_t queue_size)
      // Half of a queue at most in one turn: a subscriber whose queue is empty then has room for two.
      : most_ahead_(queue_size / 2), losses_(queue_size) {
    parent_ = publication;
    topic_ = publication->getName();
    destination_caller_id_ = "counter of this node";
  }

  void enqueueMessage(const ros::SerializedMessage& message, bool /*serialized*/, bool /*nocopy*/) override {
    endMessage();
    if (!in_turn_) {
      in_turn_ = true;
      turns_->add(boost::static_pointer_cast<AnswerLink>(shared_from_this()));
    }
    losses_.begin(message.buf);
    ++handed_over_;
  }

  // By the network thread. No socket has been written since the message was handed over.
  void endTurn() {
    endMessage();
    in_turn_ = false;
    if (waiting_) {
      const std::lock_guard<std::mutex> lock(mutex_);
      taken_over_.notify_all();
    }
  }

  void published() { ++published_; }

  // Until the network thread has taken over enough of what was published, as long as it runs.
  void waitForRoom() {
    if (!isFull()) {
      return;
    }
    std::unique_lock<std::mutex> lock(mutex_);
    waiting_ = true;
    while (isFull() && !stopped_ && !ros::isShuttingDown()) {
      taken_over_.wait_for(lock, std::chrono::milliseconds(100));
    }
    waiting_ = false;
  }

  void stop() { stopped_ = true; }
  std::uint64_t undelivered() const { return undelivered_; }

  void drop() override {}
  std::string getTransportType() override { return kNoTransport; }
  std::string getTransportInfo() override { return "counts messages that are lost"; }
  void getPublishTypes(bool& serialized, bool& nocopy, const std::type_info& /*type*/) override {
    serialized = nocopy = false;
  }

 private:
  bool isFull() const { return published_ - handed_over_ >= most_ahead_; }
  void endMessage() { undelivered_ += losses_.end() ? 1 : 0; }

  const std::uint64_t most_ahead_;
  const std::shared_ptr<NetworkTurns> turns_ = NetworkTurns::get();
  std::atomic<std::uint64_t> published_{0};
  std::atomic<std::uint64_t> handed_over_{0};
  std::atomic<std::uint64_t> undelivered_{0};
  std::atomic<bool> stopped_{false};
  std::atomic<bool> waiting_{false};
  std::mutex mutex_;
  std::condition_variable taken_over_;
  LossCount losses_;      // of the network thread only
  bool in_turn_ = false;  // likewise
};

void NetworkTurns::end() {
  if (links_.empty()) {
    return;
  }
  const std::shared_ptr<NetworkTurns> self = self_.lock();  // what is done here may end its last owner
  for (const auto& link : std::exchange(links_, {})) {
    link->endTurn();
  }
}

// A subscriber that was there before the link, which would not see what it loses, comes again.
void AnswerPublisher::advertise(ros::NodeHandle& handle, ros::AdvertiseOptions& options) {
  constexpr int kAttempts = 5;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    shutdown();
    publisher_ = handle.advertise(options);
    publication_ = ros::TopicManager::instance()->lookupPublication(publisher_.getTopic());
    link_ = boost::make_shared<AnswerLink>(publication_, options.queue_size);
    publication_->addSubscriberLink(link_);
    XmlRpc::XmlRpcValue rows;
    rows.setSize(0);
    publication_->getInfo(rows);
    constexpr int kTransport = 3;
    if (rows.size() == 0 || static_cast<const std::string&>(rows[0][kTransport]) == kNoTransport) {
      return;
    }
  }
}

bool AnswerPublisher::hasSubscribers() {
  if (publication_->getNumSubscribers() > 1) {
    return true;
  }
  publication_->incrementSequence();  // as roscpp does for a message that nobody is there for
  return false;
}

void AnswerPublisher::send(const boost::function<ros::SerializedMessage()>& serialized,
                           ros::SerializedMessage& message) {
  link_->waitForRoom();
  ros::TopicManager::instance()->publish(publication_->getName(), serialized, message);
}

ros::SerializedMessage AnswerPublisher::makeBuffer(std::uint32_t size) {
  constexpr std::uint32_t kLength = sizeof(std::uint32_t);
  ros::SerializedMessage message(boost::shared_array<std::uint8_t>(new std::uint8_t[size + kLength]), size + kLength);
  ros::serialization::OStream stream(message.buf.get(), kLength);
  ros::serialization::serialize(stream, size);
  message.message_start = message.buf.get() + kLength;
  link_->published();
  return message;
}

std::uint64_t AnswerPublisher::undelivered() const { return link_ ? link_->undelivered() : 0; }

void AnswerPublisher::shutdown() {
  if (link_) {
    link_->stop();
    publication_->removeSubscriberLink(link_);
  }
  publisher_.shutdown();
}

}  // namespace rubber_suspension::roscpp_fixes
