// Worker processes that take jobs from a list in memory that they share with their supervisor.
#include "campaign/worker_pool.h"

#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <boost/interprocess/anonymous_shared_memory.hpp>
#include <boost/interprocess/mapped_region.hpp>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <list>
#include <map>
#include <new>
#include <set>
#include <stdexcept>
#include <string>

namespace rubber_suspension::campaign {
namespace {

// Memory that this process shares with those that it forks; zeros at first.
template <class Value>
class SharedArray {
 public:
  explicit SharedArray(std::size_t size)
      : region_(boost::interprocess::anonymous_shared_memory(std::max<std::size_t>(size, 1) * sizeof(Value))) {}

  Value& operator[](std::size_t place) const { return static_cast<Value*>(region_.get_address())[place]; }

 private:
  boost::interprocess::mapped_region region_;
};

// The state of a job: one of these, or the number of the worker that has it, from 1.
enum State { kLeft = -4, kDied = -3, kFailed = -2, kDone = -1, kWaiting = 0 };
using AtomicState = std::atomic<int>;
static_assert(AtomicState::is_always_lock_free, "processes share no lock");

// As long as it lives, the end of a child and interruptions wait until somebody asks for them.
class HeldSignals {
 public:
  HeldSignals() {
    std::signal(SIGCHLD, SIG_DFL);  // who ignores it hears of no end
    sigemptyset(&held_);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGCHLD}) {
      sigaddset(&held_, signal);
    }
    sigprocmask(SIG_BLOCK, &held_, &before_);
  }
  HeldSignals(const HeldSignals&) = delete;
  HeldSignals& operator=(const HeldSignals&) = delete;
  ~HeldSignals() { release(); }

  void release() const { sigprocmask(SIG_SETMASK, &before_, nullptr); }

  // Waits a moment for one of them; true for an interruption.
  bool isInterrupted() const {
    constexpr timespec kMoment{0, 100000000};  // [s, ns]
    const int signal = sigtimedwait(&held_, nullptr, &kMoment);
    return signal > 0 && signal != SIGCHLD;
  }

 private:
  sigset_t held_{};
  sigset_t before_{};
};

// Seconds in which this process ran: more than this between two looks means that it was suspended, and its workers with
// it.
class RunningClock {
 public:
  double now() {
    constexpr double kMostBetweenLooks = 2.0;  // [s]
    const auto look = std::chrono::steady_clock::now();
    seconds_ += std::min(std::chrono::duration<double>(look - last_).count(), kMostBetweenLooks);
    last_ = look;
    return seconds_;
  }

 private:
  double seconds_ = 0.0;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

// Signals that say something of the machine and nothing of the job.
bool isFromOutside(int status) {
  constexpr std::array kSignals = {SIGKILL, SIGTERM, SIGINT, SIGHUP};
  return WIFSIGNALED(status) && std::find(kSignals.begin(), kSignals.end(), WTERMSIG(status)) != kSignals.end();
}

std::string describe(int status) {
  if (!WIFSIGNALED(status)) {
    return fmt::format("the process ended with status {}", WEXITSTATUS(status));
  }
  const int signal = WTERMSIG(status);
  return fmt::format("the process died of signal {} ({}){}", signal, strsignal(signal),
                     signal == SIGKILL ? ", twice; is there enough memory?" : "");
}

class Pool {
 public:
  Pool(const std::vector<std::size_t>& jobs, int workers, const PoolCallbacks& callbacks, double longest)
      : jobs_(jobs),
        callbacks_(callbacks),
        longest_(longest),
        states_(jobs.size()),
        exception_(kMostBytes),
        pids_(std::min(static_cast<std::size_t>(workers), jobs.size()), kNobody) {
    for (std::size_t place = 0; place < jobs.size(); ++place) {
      open_.push_back(place);
    }
  }
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;
  ~Pool() {
    for (const pid_t pid : pids_) {
      if (pid != kNobody) {
        kill(pid, SIGTERM);
        waitpid(pid, nullptr, 0);
      }
    }
  }

  PoolEnd run() {
    for (pid_t& pid : pids_) {
      start(pid);
    }
    while (std::any_of(pids_.begin(), pids_.end(), [](pid_t pid) { return pid != kNobody; })) {
      if (signals_.isInterrupted()) {
        return PoolEnd::interrupted;
      }
      buryDead();
      look();
    }
    return PoolEnd::finished;
  }

 private:
  static constexpr pid_t kNobody = -1;
  static constexpr std::size_t kMostBytes = 500;  // of the text of an exception

  int numberOf(const pid_t& pid) const { return static_cast<int>(&pid - pids_.data()) + 1; }

  void start(pid_t& pid) {
    std::fflush(nullptr);
    const pid_t supervisor = getpid();
    const pid_t child = fork();
    if (child < 0) {
      throw std::runtime_error(std::string("a worker process cannot be made: ") + std::strerror(errno));
    }
    if (child == 0) {
      signals_.release();
      prctl(PR_SET_PDEATHSIG, SIGTERM);
      if (getppid() == supervisor) {  // else it died before
        serve(numberOf(pid));
      }
      std::fflush(nullptr);
      _exit(0);  // neither destructors nor what a test framework would do at exit belong here
    }
    pid = child;
  }

  // The life of a worker process.
  void serve(int number) const {
    try {
      const auto work = callbacks_.start_worker();
      for (std::size_t place = 0; place < jobs_.size(); ++place) {
        int waiting = kWaiting;
        if (states_[place].compare_exchange_strong(waiting, number)) {
          states_[place] = endOf(work, jobs_[place]);
        }
      }
    } catch (const std::exception& error) {
      std::string(error.what()).copy(&exception_[0], kMostBytes - 1);
    }
  }

  static State endOf(const std::function<bool(std::size_t)>& work, std::size_t job) {
    try {
      return work(job) ? kDone : kFailed;
    } catch (const std::bad_alloc&) {
      return kLeft;
    }
  }

  void buryDead() {
    for (pid_t& pid : pids_) {
      int status = 0;
      if (pid == kNobody || waitpid(pid, &status, WNOHANG) != pid) {
        continue;
      }
      pid = kNobody;
      if (exception_[0] != '\0') {
        throw std::runtime_error(&exception_[0]);
      }
      const auto job =
          std::find_if(open_.begin(), open_.end(), [&](std::size_t place) { return states_[place] == numberOf(pid); });
      if (job != open_.end()) {
        bury(*job, status);
      }
      const auto is_waiting = [&](std::size_t place) { return states_[place] == kWaiting; };
      if (std::any_of(open_.begin(), open_.end(), is_waiting)) {
        start(pid);
      }
    }
  }

  // Its worker died.
  void bury(std::size_t place, int status) {
    const bool overdue = overdue_.count(place) != 0;
    const bool outside = !overdue && isFromOutside(status);
    if (outside && killed_.insert(place).second) {
      begun_.erase(place);
      states_[place] = kWaiting;
      return;
    }
    states_[place] = kDied;
    const auto& tell = outside ? callbacks_.left : callbacks_.died;
    tell(jobs_[place], overdue ? limitText() : describe(status));
  }

  // Tells what has come to its end, and ends what takes too long: its silence is heard when it is gone, for a process
  // that waits for a file system may take its time.
  void look() {
    const double now = clock_.now();
    std::vector<std::size_t> running;
    for (auto place = open_.begin(); place != open_.end() && states_[*place] != kWaiting;) {
      const int state = states_[*place];
      if (state > 0) {
        running.push_back(jobs_[*place]);
        const double begun = begun_.emplace(*place, now).first->second;
        if (longest_ > 0.0 && now - begun > longest_ && overdue_.insert(*place).second) {
          kill(pids_[static_cast<std::size_t>(state) - 1], SIGKILL);
        }
        ++place;
      } else {
        if (state == kLeft) {
          callbacks_.left(jobs_[*place], "there was no memory for it");
        } else if (state != kDied) {
          callbacks_.finished(jobs_[*place], state == kDone);
        }
        begun_.erase(*place);
        place = open_.erase(place);
      }
    }
    callbacks_.tick(running);
  }

  // The same for the same limit, because it stands in the table.
  std::string limitText() const {
    return fmt::format(
        "took longer than the limit of {:.6g} min and was ended; accepted: `campaign run --retry-failed` with another "
        "--job-minutes",
        longest_ / 60.0);
  }

  const std::vector<std::size_t>& jobs_;
  const PoolCallbacks& callbacks_;
  double longest_;                   // [s]; 0: no limit
  SharedArray<AtomicState> states_;  // by the place of a job in the list
  SharedArray<char> exception_;
  HeldSignals signals_;
  RunningClock clock_;
  std::vector<pid_t> pids_;              // of the workers
  std::list<std::size_t> open_;          // places of jobs whose end nobody was told of
  std::map<std::size_t, double> begun_;  // when a job was first seen to be worked on [s]
  std::set<std::size_t> overdue_;        // whose worker was ended
  std::set<std::size_t> killed_;         // whose worker was killed from outside, once
};

}  // namespace

PoolEnd workOff(const std::vector<std::size_t>& jobs, int workers, const PoolCallbacks& callbacks, double longest) {
  return Pool(jobs, workers, callbacks, longest).run();
}

}  // namespace rubber_suspension::campaign
