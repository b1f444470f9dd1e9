// A publisher that knows what became of its messages.
#include "ros_interface/answer_publisher.h"

#include <ros/callback_queue_interface.h>
#include <ros/init.h>
#include <ros/poll_manager.h>
#include <ros/publication.h>
#include <ros/single_subscriber_publisher.h>
#include <ros/subscriber_link.h>

#include <atomic>
#include <boost/make_shared.hpp>
#include <chrono>
#include <condition_variable>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "log/text.h"
#include "node/link_losses.h"

namespace rubber_suspension::ros_interface {
namespace {

using node::LinkLosses;

// Rows of ros::Publication::getInfo().
constexpr int kConnection = 0;
constexpr int kCaller = 1;
constexpr int kTransport = 3;

constexpr const char* kOwnTransport = "none";
constexpr const char* kIntraprocess = "INTRAPROCESS";
constexpr int kFirstLink = 0;

XmlRpc::XmlRpcValue subscribersOf(ros::Publication& publication) {
  XmlRpc::XmlRpcValue rows;
  rows.setSize(0);
  publication.getInfo(rows);
  return rows;
}

// Names are what subscribers send.
void addName(const std::string& name, std::string& names) {
  constexpr std::size_t kLongestName = 100;
  constexpr std::size_t kLongest = 300;
  if (names.size() < kLongest) {
    names += (names.empty() ? "" : " or ") + log::oneLine(name.substr(0, kLongestName));
  }
}

}  // namespace

class HandOver;

/// The messages of one topic. roscpp's network thread goes round and round: it first hands all messages that were
/// published to the subscribers one after the other, where each queue that is full loses its oldest, then it reads and
/// writes the sockets. Links of our own stand among the subscribers, see each message, and want none: the first before
/// all others, and one after each subscriber, so that what the queue between two of them loses is known. Two
/// subscribers that came in the same round have one link between them, and are named together.
class AnswerCount : public std::enable_shared_from_this<AnswerCount> {
 public:
  AnswerCount(ros::PublicationPtr publication, std::uint64_t most_ahead);

  void published() { ++published_; }

  // The first of our own links; once. False where a subscriber stands before it, whose losses it would not see.
  bool addFirstLink();

  // By the network thread: a link behind each subscriber that is new; those whose subscribers have gone go.
  void refreshLinks();

  // By the network thread, as a message passes a link.
  void pass(int link, const ros::SerializedMessage& message);
  void endTurn();

  // While our own links are being changed, the two numbers may not fit: then as if there were some.
  bool hasSubscribers() const {
    const std::uint32_t changes = changes_;
    const bool any = publication_->getNumSubscribers() > own_links_;
    return any || changes % 2 == 1 || changes_ != changes;
  }

  std::uint64_t undelivered() const { return undelivered_; }
  std::map<std::string, std::uint64_t> undeliveredTo();

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
  void addLink(int link);
  void take(const ros::SerializedMessage& message);
  void count(std::size_t lost, const std::string& subscriber);
  void endMessage();

  const ros::PublicationPtr publication_;
  const std::uint64_t most_ahead_;
  const std::shared_ptr<HandOver> hand_over_;
  std::atomic<std::uint64_t> published_{0};
  std::atomic<std::uint64_t> handed_over_{0};
  std::atomic<std::uint64_t> undelivered_{0};
  std::atomic<std::uint32_t> own_links_{0};
  std::atomic<std::uint32_t> changes_{0};  // of our own links, begun and ended
  std::atomic<bool> stopped_{false};
  std::atomic<bool> waiting_{false};
  std::mutex mutex_;
  std::condition_variable taken_over_;

  // Of the network thread only.
  struct Link {
    boost::weak_ptr<ros::SubscriberLink> link;
    std::string before;  // the subscribers between the link before and this one
  };
  LinkLosses losses_;
  std::map<int, Link> links_;         // by their numbers, which rise
  std::size_t lost_behind_last_ = 0;  // messages that subscribers behind our last link lost
  bool in_turn_ = false;
  bool in_message_ = false;
  bool lost_one_ = false;  // at this message

  std::mutex lost_mutex_;
  std::map<std::string, std::uint64_t> lost_by_;
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
      result->self_ = result;
    }
    return result;
  }

  // roscpp's own listener, which hands over, was there before and is called before.
  HandOver() : listener_(ros::PollManager::instance()->addPollThreadListener([this] { end(); })) {}
  HandOver(const HandOver&) = delete;
  HandOver& operator=(const HandOver&) = delete;
  ~HandOver() { ros::PollManager::instance()->removePollThreadListener(listener_); }

  // By the network thread.
  void begin(const std::shared_ptr<AnswerCount>& count) { counts_.push_back(count); }

  // Its subscribers are others than before.
  void look(const std::weak_ptr<AnswerCount>& count) {
    const std::lock_guard<std::mutex> lock(mutex_);
    changed_.push_back(count);
    any_changed_ = true;
  }

 private:
  void end() {
    if (counts_.empty() && !any_changed_) {
      return;
    }
    const std::shared_ptr<HandOver> self = self_.lock();  // what is done here may end its last owner
    for (const auto& count : counts_) {
      count->endTurn();
    }
    counts_.clear();
    if (any_changed_.exchange(false)) {
      refreshChanged();
    }
  }

  void refreshChanged() {
    std::vector<std::weak_ptr<AnswerCount>> changed;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      changed.swap(changed_);
    }
    for (const auto& weak : changed) {
      if (const auto count = weak.lock()) {
        count->refreshLinks();
      }
    }
  }

  std::vector<std::shared_ptr<AnswerCount>> counts_;  // of this turn; of the network thread only
  std::mutex mutex_;
  std::vector<std::weak_ptr<AnswerCount>> changed_;
  std::atomic<bool> any_changed_{false};
  std::weak_ptr<HandOver> self_;
  boost::signals2::connection listener_;
};

namespace {

// Stands among the subscribers of a topic, sees each message, and wants none.
class CountingLink : public ros::SubscriberLink {
 public:
  CountingLink(const ros::PublicationPtr& publication, std::shared_ptr<AnswerCount> count, int number)
      : count_(std::move(count)), number_(number) {
    parent_ = publication;
    topic_ = publication->getName();
    connection_id_ = static_cast<unsigned int>(number);
    destination_caller_id_ = "counter of this node";
  }

  void enqueueMessage(const ros::SerializedMessage& message, bool /*serialized*/, bool /*nocopy*/) override {
    count_->pass(number_, message);
  }
  void drop() override {}
  std::string getTransportType() override { return kOwnTransport; }
  std::string getTransportInfo() override { return "counts messages that are lost"; }
  void getPublishTypes(bool& serialized, bool& nocopy, const std::type_info& /*type*/) override {
    serialized = false;
    nocopy = false;
  }

 private:
  std::shared_ptr<AnswerCount> count_;
  int number_;
};

}  // namespace

AnswerCount::AnswerCount(ros::PublicationPtr publication, std::uint64_t most_ahead)
    : publication_(std::move(publication)),
      most_ahead_(most_ahead),
      hand_over_(HandOver::get()),
      losses_(publication_->getMaxQueue()) {}

void AnswerCount::addLink(int link) {
  const auto counting = boost::make_shared<CountingLink>(publication_, shared_from_this(), link);
  links_[link].link = counting;
  publication_->addSubscriberLink(counting);
  ++own_links_;
}

bool AnswerCount::addFirstLink() {
  addLink(kFirstLink);
  XmlRpc::XmlRpcValue rows = subscribersOf(*publication_);
  for (int i = 0; i < rows.size(); ++i) {
    const std::string& transport = rows[i][kTransport];
    if (transport == kOwnTransport) {
      return true;
    }
    if (transport != kIntraprocess) {  // those have no queue
      return false;
    }
  }
  return true;  // the publication has ended
}

void AnswerCount::pass(int link, const ros::SerializedMessage& message) {
  if (link == kFirstLink) {
    take(message);
  } else {
    count(losses_.passed(), links_.at(link).before);
  }
}

void AnswerCount::take(const ros::SerializedMessage& message) {
  endMessage();
  if (!in_turn_) {
    in_turn_ = true;
    hand_over_->begin(shared_from_this());
  }
  in_message_ = true;
  losses_.begin(message.buf);
  ++handed_over_;
}

// The sockets have not been written since the message was handed over.
void AnswerCount::endMessage() {
  if (in_message_) {
    const std::size_t lost = losses_.passed();
    lost_behind_last_ += lost;
    lost_one_ = lost_one_ || lost > 0;
    undelivered_ += lost_one_ ? 1 : 0;
  }
  in_message_ = false;
  lost_one_ = false;
}

void AnswerCount::count(std::size_t lost, const std::string& subscriber) {
  if (lost == 0) {
    return;
  }
  lost_one_ = true;
  constexpr std::size_t kMostNames = 50;  // whoever comes under ever new names fills no memory
  const std::lock_guard<std::mutex> lock(lost_mutex_);
  const bool known = lost_by_.size() < kMostNames || lost_by_.count(subscriber) > 0;
  lost_by_[known ? subscriber : "others"] += lost;
}

void AnswerCount::endTurn() {
  endMessage();
  in_turn_ = false;
  if (waiting_) {
    const std::lock_guard<std::mutex> lock(mutex_);
    taken_over_.notify_all();
  }
}

void AnswerCount::refreshLinks() {
  ++changes_;
  XmlRpc::XmlRpcValue rows = subscribersOf(*publication_);
  std::string names;
  for (int i = 0; i < rows.size(); ++i) {
    XmlRpc::XmlRpcValue& row = rows[i];
    if (static_cast<const std::string&>(row[kTransport]) != kOwnTransport) {
      addName(row[kCaller], names);
      continue;
    }
    const auto link = links_.find(static_cast<int>(row[kConnection]));
    link->second.before = names;
    if (names.empty() && link->first != kFirstLink) {
      publication_->removeSubscriberLink(link->second.link.lock());
      --own_links_;
      links_.erase(link);
    }
    names.clear();
  }
  count(lost_behind_last_, names.empty() ? "a subscriber that has gone" : names);
  lost_behind_last_ = 0;
  if (!names.empty()) {
    const int link = links_.rbegin()->first + 1;
    links_[link].before = names;
    addLink(link);
  }
  ++changes_;
}

std::map<std::string, std::uint64_t> AnswerCount::undeliveredTo() {
  const std::lock_guard<std::mutex> lock(lost_mutex_);
  return lost_by_;
}

namespace {

void neverCalled(const ros::SingleSubscriberPublisher& /*subscriber*/) {}

}  // namespace

// roscpp puts a callback for each subscriber that comes or goes into a queue. Nothing is called: that one comes is all
// that is to be known.
class SubscriberWatch : public ros::CallbackQueueInterface {
 public:
  void report(const std::shared_ptr<AnswerCount>& count) {
    const std::lock_guard<std::mutex> lock(mutex_);
    count_ = count;
    count->handOver()->look(count);
  }

  void addCallback(const ros::CallbackInterfacePtr& /*callback*/, std::uint64_t /*owner*/) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (const auto count = count_.lock()) {
      count->handOver()->look(count);
    }
  }

  void removeByID(std::uint64_t /*owner*/) override {}

 private:
  std::mutex mutex_;
  std::weak_ptr<AnswerCount> count_;
};

AnswerPublisher::AnswerPublisher() : subscriber_watch_(std::make_shared<SubscriberWatch>()) {}

AnswerPublisher::~AnswerPublisher() { shutdown(); }

void AnswerPublisher::watchSubscribers(ros::AdvertiseOptions& options) const {
  options.connect_cb = options.disconnect_cb = &neverCalled;
  options.callback_queue = subscriber_watch_.get();
}

bool AnswerPublisher::watch(std::uint32_t queue_size) {
  publication_ = ros::TopicManager::instance()->lookupPublication(publisher_.getTopic());
  // Half of a queue at most in one turn: a subscriber whose queue is empty then has room for two.
  count_ = std::make_shared<AnswerCount>(publication_, queue_size / 2);
  const bool first = count_->addFirstLink();
  subscriber_watch_->report(count_);
  return first;
}

bool AnswerPublisher::hasSubscribers() {
  if (count_->hasSubscribers()) {
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
  ros::SerializedMessage message(boost::shared_array<std::uint8_t>(new std::uint8_t[size + kLength]), size + kLength);
  ros::serialization::OStream stream(message.buf.get(), kLength);
  ros::serialization::serialize(stream, size);
  message.message_start = message.buf.get() + kLength;
  count_->published();
  return message;
}

std::uint64_t AnswerPublisher::undelivered() const { return count_ ? count_->undelivered() : 0; }

std::map<std::string, std::uint64_t> AnswerPublisher::undeliveredTo() const {
  return count_ ? count_->undeliveredTo() : std::map<std::string, std::uint64_t>();
}

void AnswerPublisher::shutdown() {
  if (count_) {
    count_->stop();
  }
  publisher_.shutdown();
}

}  // namespace rubber_suspension::ros_interface
