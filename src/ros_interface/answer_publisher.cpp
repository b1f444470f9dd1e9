// A publisher that knows what became of its messages.
#include "ros_interface/answer_publisher.h"

#include <ros/init.h>
#include <ros/poll_manager.h>
#include <ros/publication.h>
#include <ros/subscriber_link.h>

#include <atomic>
#include <boost/make_shared.hpp>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <vector>

namespace rubber_suspension::ros_interface {
namespace {

// roscpp's network thread goes round and round: it first hands all messages that were published to the subscribers'
// queues, where each that is full loses its oldest, then it reads and writes the sockets. A message that is freed in
// that thread while it hands over was lost; any other has been written, or its subscriber has gone.
thread_local bool handing_over = false;

}  // namespace

class HandOver;

/// The messages of one topic; shared with the buffers of those under way.
class AnswerCount {
 public:
  AnswerCount(ros::PublicationPtr publication, std::uint64_t most_ahead);

  void published() { ++published_; }

  // By the network thread.
  void takenOver(const std::shared_ptr<AnswerCount>& self);
  void released() { freed_ += handing_over ? 1 : 0; }
  void endTurn();

  std::uint64_t undelivered() const { return undelivered_; }

  const std::shared_ptr<HandOver>& handOver() const { return hand_over_; }

  void stop() { stopped_ = true; }

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

 private:
  bool isFull() const { return published_ - handed_over_ >= most_ahead_; }

  const ros::PublicationPtr publication_;
  const std::uint64_t most_ahead_;
  const std::shared_ptr<HandOver> hand_over_;
  std::atomic<std::uint64_t> published_{0};
  std::atomic<std::uint64_t> handed_over_{0};
  std::atomic<std::uint64_t> undelivered_{0};
  std::atomic<std::uint64_t> freed_{0};  // in this turn
  bool in_turn_ = false;                 // of the network thread only
  std::atomic<bool> stopped_{false};
  std::atomic<bool> waiting_{false};
  std::mutex mutex_;
  std::condition_variable taken_over_;
};

/// Where the network thread has handed over all that was published; one for the process.
class HandOver {
 public:
  static std::shared_ptr<HandOver> get() {
    static std::mutex mutex;
    static std::weak_ptr<HandOver> existing;
    const std::lock_guard<std::mutex> lock(mutex);
    std::shared_ptr<HandOver> result = existing.lock();
    if (!result) {
      existing = result = std::make_shared<HandOver>();
    }
    return result;
  }

  // roscpp's own listener, which hands over, was there before and is called before.
  HandOver() : listener_(ros::PollManager::instance()->addPollThreadListener([this] { end(); })) {}
  HandOver(const HandOver&) = delete;
  HandOver& operator=(const HandOver&) = delete;
  ~HandOver() { ros::PollManager::instance()->removePollThreadListener(listener_); }

  void begin(const std::shared_ptr<AnswerCount>& count) {
    handing_over = true;
    counts_.push_back(count);
  }

 private:
  void end() {
    handing_over = false;
    if (counts_.empty()) {
      return;
    }
    const std::shared_ptr<HandOver> self = counts_.front()->handOver();  // these may be its last owners
    for (const auto& count : counts_) {
      count->endTurn();
    }
    counts_.clear();
  }

  std::vector<std::shared_ptr<AnswerCount>> counts_;  // of this turn; of the network thread only
  boost::signals2::connection listener_;
};

AnswerCount::AnswerCount(ros::PublicationPtr publication, std::uint64_t most_ahead)
    : publication_(std::move(publication)), most_ahead_(most_ahead), hand_over_(HandOver::get()) {}

void AnswerCount::takenOver(const std::shared_ptr<AnswerCount>& self) {
  if (!in_turn_) {
    in_turn_ = true;
    hand_over_->begin(self);
  }
  ++handed_over_;
}

void AnswerCount::endTurn() {
  in_turn_ = false;
  const std::uint64_t freed = freed_.exchange(0);
  if (freed > 0 && publication_->getNumSubscribers() > 1) {  // one is our own link
    undelivered_ += freed;
  }
  if (waiting_) {
    const std::lock_guard<std::mutex> lock(mutex_);
    taken_over_.notify_all();
  }
}

namespace {

// Stands among the subscribers of a topic, sees each message before they do, and wants none.
class CountingLink : public ros::SubscriberLink {
 public:
  CountingLink(const ros::PublicationPtr& publication, std::shared_ptr<AnswerCount> count) : count_(std::move(count)) {
    parent_ = publication;
    topic_ = publication->getName();
    connection_id_ = 0;
    destination_caller_id_ = "counter of this node";
  }

  void enqueueMessage(const ros::SerializedMessage& /*message*/, bool /*serialized*/, bool /*nocopy*/) override {
    count_->takenOver(count_);
  }
  void drop() override {}
  std::string getTransportType() override { return "none"; }
  std::string getTransportInfo() override { return "counts messages that are lost"; }
  void getPublishTypes(bool& serialized, bool& nocopy, const std::type_info& /*type*/) override {
    serialized = false;
    nocopy = false;
  }

 private:
  std::shared_ptr<AnswerCount> count_;
};

}  // namespace

void AnswerPublisher::watch(std::uint32_t queue_size) {
  publication_ = ros::TopicManager::instance()->lookupPublication(publisher_.getTopic());
  // Half of a queue at most in one turn: a subscriber whose queue is empty then has room for two.
  count_ = std::make_shared<AnswerCount>(publication_, queue_size / 2);
  publication_->addSubscriberLink(boost::make_shared<CountingLink>(publication_, count_));
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
  count_->waitForRoom();
  ros::TopicManager::instance()->publish(publication_->getName(), serialized, message);
}

ros::SerializedMessage AnswerPublisher::makeBuffer(std::uint32_t size) {
  constexpr std::uint32_t kLength = sizeof(std::uint32_t);
  const auto release = [count = count_](std::uint8_t* buffer) {
    delete[] buffer;
    count->released();
  };
  ros::SerializedMessage message(boost::shared_array<std::uint8_t>(new std::uint8_t[size + kLength], release),
                                 size + kLength);
  ros::serialization::OStream stream(message.buf.get(), kLength);
  ros::serialization::serialize(stream, size);
  message.message_start = message.buf.get() + kLength;
  count_->published();
  return message;
}

std::uint64_t AnswerPublisher::undelivered() const { return count_ ? count_->undelivered() : 0; }

void AnswerPublisher::shutdown() {
  if (count_) {
    count_->stop();
  }
  publisher_.shutdown();
}

}  // namespace rubber_suspension::ros_interface
