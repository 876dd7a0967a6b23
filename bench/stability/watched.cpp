#include "watched.h"

#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <vector>

namespace ping_pong::stability
{
namespace
{
using Clock = std::chrono::steady_clock;
using Work = std::function<Verdict(std::uint64_t)>;

// Every `stride`-th index from `next` on.
struct Worker
{
  std::uint64_t next = 0;
  pid_t process = 0;
  int answers = -1;
  Clock::time_point since;  // it works on `next`
};

bool writeAll(int file, const Verdict& verdict)
{
  const char* bytes = reinterpret_cast<const char*>(&verdict);
  for (std::size_t done = 0; done < sizeof verdict;)
  {
    const ssize_t now = write(file, bytes + done, sizeof verdict - done);
    if (now <= 0) return false;
    done += static_cast<std::size_t>(now);
  }
  return true;
}

bool readAll(int file, Verdict& verdict)
{
  char* bytes = reinterpret_cast<char*>(&verdict);
  for (std::size_t done = 0; done < sizeof verdict;)
  {
    const ssize_t now = read(file, bytes + done, sizeof verdict - done);
    if (now <= 0) return false;
    done += static_cast<std::size_t>(now);
  }
  return true;
}

[[noreturn]] void workOn(const Work& work, std::uint64_t next, std::uint64_t end, unsigned stride, int answers)
{
  for (; next < end; next += stride)
    if (!writeAll(answers, work(next))) break;
  std::_Exit(0);
}

void start(Worker& worker, const Work& work, std::uint64_t end, unsigned stride)
{
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("no pipe");
  std::fflush(nullptr);
  worker.process = fork();
  if (worker.process < 0) throw std::runtime_error("no process");
  if (worker.process == 0)
  {
    close(ends[0]);
    workOn(work, worker.next, end, stride, ends[1]);
  }
  close(ends[1]);
  worker.answers = ends[0];
  worker.since = Clock::now();
}

void stop(Worker& worker)
{
  kill(worker.process, SIGKILL);
  waitpid(worker.process, nullptr, 0);
  close(worker.answers);
  worker.answers = -1;
}

Verdict failed(Check check)
{
  Verdict verdict;
  verdict.fault(check, 0.0);
  return verdict;
}
}  // namespace

void watched(const Watch& watch, const Work& work, const std::function<void(std::uint64_t, const Verdict&)>& told)
{
  const std::uint64_t end = watch.first + watch.count;
  const unsigned stride = watch.processes;
  std::vector<Worker> workers(stride);
  for (unsigned i = 0; i < stride; ++i)
  {
    workers[i].next = watch.first + i;
    if (workers[i].next < end) start(workers[i], work, end, stride);
  }
  const auto done = [&](Worker& worker, const Verdict& verdict, bool again)
  {
    told(worker.next, verdict);
    worker.next += stride;
    worker.since = Clock::now();
    if (!again && worker.next < end) return;
    stop(worker);
    if (worker.next < end) start(worker, work, end, stride);
  };
  for (;;)
  {
    std::vector<pollfd> files;
    std::vector<Worker*> of;
    for (Worker& worker : workers)
      if (worker.answers >= 0)
      {
        files.push_back({worker.answers, POLLIN, 0});
        of.push_back(&worker);
      }
    if (files.empty()) return;
    poll(files.data(), files.size(), 50);
    for (std::size_t i = 0; i < files.size(); ++i)
    {
      Verdict verdict;
      if (files[i].revents != 0)
      {
        const bool whole = readAll(of[i]->answers, verdict);
        done(*of[i], whole ? verdict : failed(Check::Crashed), !whole);
      }
      else if (std::chrono::duration<double>(Clock::now() - of[i]->since).count() > watch.patience)
        done(*of[i], failed(Check::Hung), true);
    }
  }
}
}  // namespace ping_pong::stability
