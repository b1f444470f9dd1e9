// Worker processes, fed over a socket pair each.
#include "campaign/worker_pool.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <deque>
#include <optional>
#include <set>
#include <stdexcept>

namespace rubber_suspension::campaign {
namespace {

volatile std::sig_atomic_t interrupted = 0;

extern "C" void noteInterruption(int /*signal*/) { interrupted = 1; }

constexpr std::array kInterruptions = {SIGINT, SIGTERM, SIGHUP};

// Interruptions are noted, no more, as long as it lives. Without SA_RESTART: a wait ends.
class InterruptionWatch {
 public:
  InterruptionWatch() {
    interrupted = 0;
    struct sigaction noting {};
    noting.sa_handler = noteInterruption;
    for (std::size_t i = 0; i < kInterruptions.size(); ++i) {
      sigaction(kInterruptions[i], &noting, &before_[i]);
    }
  }
  InterruptionWatch(const InterruptionWatch&) = delete;
  InterruptionWatch& operator=(const InterruptionWatch&) = delete;
  ~InterruptionWatch() {
    for (std::size_t i = 0; i < kInterruptions.size(); ++i) {
      sigaction(kInterruptions[i], &before_[i], nullptr);
    }
  }

 private:
  std::array<struct sigaction, kInterruptions.size()> before_{};
};

enum class Answer : std::int32_t { done, failed, exception };

// What a worker sends: the answer and, of an exception, its text.
struct Message {
  Answer answer = Answer::done;
  std::array<char, 500> text{};
};

struct Worker {
  pid_t pid = -1;
  int socket = -1;
  std::optional<std::size_t> job;
  double begun = 0.0;  // the job, by the clock of the pool [s]
  bool ended = false;  // killed because the job took too long
};

// Seconds in which this process ran. Between two looks, of which there is one a second at least, more than this means
// that it was suspended, and its workers with it.
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
  return WIFSIGNALED(status) && (WTERMSIG(status) == SIGKILL || WTERMSIG(status) == SIGTERM ||
                                 WTERMSIG(status) == SIGINT || WTERMSIG(status) == SIGHUP);
}

std::string describe(int status) {
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    return fmt::format("the process died of signal {} ({}){}", signal, strsignal(signal),
                       signal == SIGKILL ? ", twice; is there enough memory?" : "");
  }
  return fmt::format("the process ended with status {}", WEXITSTATUS(status));
}

[[noreturn]] void fail(const char* what) {
  throw std::runtime_error(fmt::format("a worker process cannot be made: {}: {}", what, std::strerror(errno)));
}

// The life of a worker process: it ends with the supervisor.
void serve(int socket, const PoolCallbacks& callbacks) {
  Message message;
  try {
    const auto work = callbacks.start_worker();
    std::uint64_t job = 0;
    while (recv(socket, &job, sizeof job, 0) == static_cast<ssize_t>(sizeof job)) {
      message.answer = work(job) ? Answer::done : Answer::failed;
      if (send(socket, &message, sizeof message, MSG_NOSIGNAL) < 0) {
        return;
      }
    }
  } catch (const std::exception& error) {
    message.answer = Answer::exception;
    std::snprintf(message.text.data(), message.text.size(), "%s", error.what());
    send(socket, &message, sizeof message, MSG_NOSIGNAL);
  }
}

class Pool {
 public:
  Pool(const std::vector<std::size_t>& jobs, int workers, const PoolCallbacks& callbacks, double longest)
      : callbacks_(callbacks), longest_(longest), waiting_(jobs.begin(), jobs.end()) {
    workers_.resize(std::min(static_cast<std::size_t>(workers), jobs.size()));
  }
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;
  ~Pool() { endWorkers(); }

  PoolEnd run() {
    const InterruptionWatch watch;
    for (Worker& worker : workers_) {
      start(worker);
      feed(worker);
    }
    while (interrupted == 0 && running() > 0) {
      wait();
      endOverdue();
      tick();
    }
    return interrupted == 0 ? PoolEnd::finished : PoolEnd::interrupted;
  }

 private:
  void start(Worker& worker) {
    std::array<int, 2> sockets{};
    if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, sockets.data()) != 0) {
      fail("socketpair");
    }
    std::fflush(nullptr);
    const pid_t supervisor = getpid();
    const pid_t pid = fork();
    if (pid < 0) {
      close(sockets[0]);
      close(sockets[1]);
      fail("fork");
    }
    if (pid == 0) {
      beWorker(supervisor, sockets);
    }
    close(sockets[1]);
    worker = {};
    worker.pid = pid;
    worker.socket = sockets[0];
  }

  // Never returns: neither destructors nor what a test framework would do at exit belong here.
  [[noreturn]] void beWorker(pid_t supervisor, const std::array<int, 2>& sockets) const {
    for (const int signal : kInterruptions) {
      std::signal(signal, SIG_DFL);
    }
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    close(sockets[0]);
    for (const Worker& other : workers_) {
      if (other.socket >= 0) {
        close(other.socket);  // else its worker would not see the supervisor's end
      }
    }
    if (getppid() == supervisor) {
      serve(sockets[1], callbacks_);
    }
    std::fflush(nullptr);
    _exit(0);
  }

  void feed(Worker& worker) {
    if (waiting_.empty()) {
      close(worker.socket);
      waitpid(worker.pid, nullptr, 0);
      worker = {};
      return;
    }
    worker.job = waiting_.front();
    worker.begun = clock_.now();
    waiting_.pop_front();
    const std::uint64_t job = *worker.job;
    send(worker.socket, &job, sizeof job, MSG_NOSIGNAL);  // one that died is seen by its silence
  }

  void wait() {
    std::vector<pollfd> sockets;
    for (const Worker& worker : workers_) {
      sockets.push_back({worker.socket, POLLIN, 0});  // a negative one is passed over
    }
    if (poll(sockets.data(), sockets.size(), longestWait()) <= 0) {
      return;
    }
    for (std::size_t i = 0; i < workers_.size(); ++i) {
      if (sockets[i].revents != 0 && interrupted == 0) {
        hear(workers_[i]);
      }
    }
  }

  // Until the next limit of a job, but a second at most [ms].
  int longestWait() {
    double wait = 1.0;
    const double now = clock_.now();
    for (const Worker& worker : workers_) {
      if (longest_ > 0.0 && worker.job && !worker.ended) {
        wait = std::clamp(worker.begun + longest_ - now, 0.0, wait);
      }
    }
    return static_cast<int>(std::ceil(1000.0 * wait));
  }

  // Its silence is heard when it is gone: a process that waits for a file system may take its time.
  void endOverdue() {
    const double now = clock_.now();
    for (Worker& worker : workers_) {
      if (longest_ > 0.0 && worker.job && !worker.ended && now - worker.begun > longest_) {
        kill(worker.pid, SIGKILL);
        worker.ended = true;
      }
    }
  }

  void hear(Worker& worker) {
    Message message;
    const ssize_t count = recv(worker.socket, &message, sizeof message, 0);
    if (count != static_cast<ssize_t>(sizeof message)) {
      bury(worker);
    } else if (message.answer == Answer::exception) {
      message.text.back() = '\0';
      throw std::runtime_error(message.text.data());
    } else {
      callbacks_.finished(*worker.job, message.answer == Answer::done);
      worker.job.reset();
      if (worker.ended) {  // the answer was on its way when the limit came
        bury(worker);
      } else {
        feed(worker);
      }
    }
  }

  // A worker died: another takes its place.
  void bury(Worker& worker) {
    int status = 0;
    close(worker.socket);
    worker.socket = -1;
    waitpid(worker.pid, &status, 0);
    const Worker dead = worker;
    worker = {};
    if (dead.job && dead.ended) {
      callbacks_.died(*dead.job, overdue());
    } else if (dead.job && isFromOutside(status) && killed_.insert(*dead.job).second) {
      waiting_.push_front(*dead.job);
    } else if (dead.job) {
      callbacks_.died(*dead.job, describe(status));
    }
    if (!waiting_.empty()) {
      start(worker);
      feed(worker);
    }
  }

  // The same text for the same limit, because it stands in the table.
  std::string overdue() const {
    return fmt::format(
        "took longer than the limit of {:.6g} min and was ended; accepted: `campaign run --retry-failed` with another "
        "--job-minutes",
        longest_ / 60.0);
  }

  void tick() {
    std::vector<std::size_t> jobs;
    for (const Worker& worker : workers_) {
      if (worker.job) {
        jobs.push_back(*worker.job);
      }
    }
    callbacks_.tick(jobs);
  }

  std::size_t running() const {
    return static_cast<std::size_t>(
        std::count_if(workers_.begin(), workers_.end(), [](const Worker& worker) { return worker.job.has_value(); }));
  }

  void endWorkers() {
    for (const Worker& worker : workers_) {
      if (worker.pid > 0) {
        kill(worker.pid, SIGTERM);
        close(worker.socket);
      }
    }
    for (const Worker& worker : workers_) {
      if (worker.pid > 0) {
        waitpid(worker.pid, nullptr, 0);
      }
    }
  }

  const PoolCallbacks& callbacks_;
  double longest_;  // [s]; 0: no limit
  RunningClock clock_;
  std::deque<std::size_t> waiting_;
  std::vector<Worker> workers_;
  std::set<std::size_t> killed_;  // jobs whose worker was killed from outside, once
};

}  // namespace

PoolEnd workOff(const std::vector<std::size_t>& jobs, int workers, const PoolCallbacks& callbacks, double longest) {
  return Pool(jobs, workers, callbacks, longest).run();
}

}  // namespace rubber_suspension::campaign
