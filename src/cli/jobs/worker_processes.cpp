#include "jobs/worker_processes.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <exception>
#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

#include "common/program_error.h"

namespace softgl::cli {
namespace {

using Clock = std::chrono::steady_clock;

constexpr size_t kMostAnswer = 64 << 10;
constexpr char kMore = 'm', kLast = 'l'; // an answer begins with one of them
constexpr int kCannotBegin = 125;        // exit code of a process that could not begin
constexpr size_t kNoJob = SIZE_MAX;
constexpr std::array<int, 3> kEndings = {SIGTERM, SIGINT, SIGHUP};

volatile std::sig_atomic_t signals_seen = 0, first_signal = 0;

void note_signal(int signal) {
  if (signals_seen == 0) first_signal = signal;
  signals_seen = signals_seen + 1;
}

// While one exists, signals that end a process are noted, and only within wait().
class Signals {
public:
  Signals() {
    signals_seen = 0;
    first_signal = 0;
    sigset_t blocked;
    ::sigemptyset(&blocked);
    for (const int signal : kEndings) ::sigaddset(&blocked, signal);
    ::sigprocmask(SIG_BLOCK, &blocked, &before_);
    struct sigaction action {};
    action.sa_handler = note_signal;
    for (size_t i = 0; i < kEndings.size(); ++i) {
      ::sigaction(kEndings[i], nullptr, &actions_[i]);
      if (actions_[i].sa_handler != SIG_IGN) ::sigaction(kEndings[i], &action, nullptr); // nohup
    }
    action.sa_handler = SIG_IGN; // a process that is gone
    ::sigaction(SIGPIPE, &action, &pipe_action_);
  }
  ~Signals() {
    for (size_t i = 0; i < kEndings.size(); ++i) ::sigaction(kEndings[i], &actions_[i], nullptr);
    ::sigaction(SIGPIPE, &pipe_action_, nullptr);
    ::sigprocmask(SIG_SETMASK, &before_, nullptr);
  }
  Signals(const Signals&) = delete;
  Signals& operator=(const Signals&) = delete;

  void wait(std::vector<pollfd>& files, double seconds) const {
    timespec most{time_t(seconds), long((seconds - double(time_t(seconds))) * 1e9)};
    ::ppoll(files.data(), files.size(), seconds < 0 ? nullptr : &most, &before_);
  }

  // In a new process: the parent decides what a signal ends. A terminal and Slurm send it to all.
  void leave_to_parent() const {
    for (const int signal : {SIGTERM, SIGINT, SIGHUP, SIGXFSZ}) ::signal(signal, SIG_IGN);
    ::sigprocmask(SIG_SETMASK, &before_, nullptr);
  }

private:
  sigset_t before_;
  std::array<struct sigaction, kEndings.size()> actions_;
  struct sigaction pipe_action_;
};

struct Worker {
  pid_t process = 0;
  int socket = -1;
  size_t job = kNoJob;
};

class WorkerGroup {
public:
  WorkerGroup(const std::vector<size_t>& jobs, const WorkerPlan& plan) : jobs_(jobs), plan_(plan) {}
  ~WorkerGroup() {
    for (Worker& worker : workers_) {
      ::kill(worker.process, SIGKILL);
      end(worker);
    }
  }
  WorkerGroup(const WorkerGroup&) = delete;
  WorkerGroup& operator=(const WorkerGroup&) = delete;

  int run(std::vector<size_t>& dropped) {
    Clock::time_point limit{};
    for (;;) {
      if (signals_seen == 0) hand_out();
      let_idle_go();
      if (workers_.empty()) break;
      double seconds = -1;
      if (signals_seen > 0) {
        if (limit == Clock::time_point{})
          limit = Clock::now() + std::chrono::milliseconds(long(plan_.grace * 1e3));
        seconds = std::chrono::duration<double>(limit - Clock::now()).count();
        if (signals_seen > 1 || seconds <= 0) {
          for (const Worker& worker : workers_) dropped.push_back(worker.job);
          break;
        }
      }
      listen(seconds);
    }
    return first_signal;
  }

private:
  // Gives each process that is idle a job, and starts as many as there may be.
  void hand_out() {
    for (Worker& worker : workers_)
      if (worker.job == kNoJob && next_ < jobs_.size()) give(worker);
    while (workers_.size() < plan_.processes && next_ < jobs_.size()) {
      if (!start()) {
        if (workers_.empty())
          throw ProgramError(kCannotRead, std::string("cannot start a process: ") + std::strerror(errno));
        break; // fewer do the same work
      }
      give(workers_.back());
    }
  }

  void give(Worker& worker) {
    worker.job = jobs_[next_++];
    const uint64_t number = worker.job;
    // A process that is gone is noticed when it is listened to.
    if (::write(worker.socket, &number, sizeof number) < 0) return;
  }

  void let_idle_go() {
    for (size_t i = workers_.size(); i-- > 0;)
      if (workers_[i].job == kNoJob) remove(i);
  }

  int remove(size_t number) {
    const int status = end(workers_[number]);
    workers_.erase(workers_.begin() + long(number));
    return status;
  }

  // Closing the socket ends a process that is alive. Returns what wait() says.
  static int end(Worker& worker) {
    ::close(worker.socket);
    int status = 0;
    while (::waitpid(worker.process, &status, 0) < 0 && errno == EINTR) {}
    return status;
  }

  bool start() {
    int sockets[2];
    if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, sockets) != 0) return false;
    const pid_t parent = ::getpid(), process = ::fork();
    if (process == 0) {
      ::close(sockets[0]);
      for (const Worker& other : workers_) ::close(other.socket);
      work(sockets[1], parent);
    }
    const int problem = errno;
    ::close(sockets[1]);
    errno = problem;
    if (process < 0) {
      ::close(sockets[0]);
      errno = problem;
      return false;
    }
    workers_.push_back({process, sockets[0], kNoJob});
    return true;
  }

  [[noreturn]] void work(int socket, pid_t parent) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent) ::_exit(0);
    signals_.leave_to_parent();
    try {
      plan_.begin();
    } catch (const std::exception& error) {
      const std::string text = std::string("softgl: error: ") + error.what() + "\n";
      if (::write(STDERR_FILENO, text.data(), text.size()) < 0) ::_exit(kCannotBegin);
      ::_exit(kCannotBegin);
    }
    uint64_t job = 0;
    while (::read(socket, &job, sizeof job) == sizeof job) {
      const JobAnswer answer = plan_.work(job);
      const std::string text = (answer.last ? kLast : kMore) + answer.text.substr(0, kMostAnswer - 1);
      if (::write(socket, text.data(), text.size()) < 0 || answer.last) break;
    }
    ::_exit(0);
  }

  void listen(double seconds) {
    std::vector<pollfd> files;
    for (const Worker& worker : workers_) files.push_back({worker.socket, POLLIN, 0});
    signals_.wait(files, seconds);
    for (size_t i = files.size(); i-- > 0;)
      if (files[i].revents) hear(i);
  }

  void hear(size_t number) {
    Worker& worker = workers_[number];
    std::string text(kMostAnswer, '\0');
    const ssize_t count = ::read(worker.socket, text.data(), text.size());
    if (count > 0 && worker.job != kNoJob) {
      const size_t job = std::exchange(worker.job, kNoJob);
      const bool last = text[0] == kLast;
      if (last) remove(number);
      plan_.answered(job, text.substr(1, size_t(count) - 1));
      return;
    }
    if (count < 0 && (errno == EINTR || errno == EAGAIN)) return;
    const size_t job = worker.job;
    const int status = remove(number);
    if (WIFEXITED(status) && WEXITSTATUS(status) == kCannotBegin)
      throw ProgramError(kUsageError, "a process that draws could not begin");
    if (job != kNoJob) plan_.died(job, status);
  }

  const std::vector<size_t>& jobs_;
  const WorkerPlan& plan_;
  const Signals signals_;
  std::vector<Worker> workers_;
  size_t next_ = 0;
};

} // namespace

int run_jobs(const std::vector<size_t>& jobs, const WorkerPlan& plan, std::vector<size_t>& dropped) {
  return WorkerGroup(jobs, plan).run(dropped);
}

} // namespace softgl::cli
