#include <isocast/base/error.h>
#include <isocast/base/interrupt.h>
#include <pthread.h>

#include <atomic>
#include <csignal>
#include <thread>

namespace isocast {
namespace {

// A thread waits for the signals; every other thread has them blocked, so nothing runs in signal context.
struct Watcher {
  std::stop_source source;
  Watcher() {
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGINT);
    sigaddset(&set, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &set, nullptr);
    std::thread([set, this] {
      int signal = 0;
      sigwait(&set, &signal);
      source.request_stop();
      sigwait(&set, &signal);
      _exit(130);
    }).detach();
  }
};

Watcher& watcher() {
  static Watcher* const instance = new Watcher;  // lives as long as its thread
  return *instance;
}

std::atomic<const std::stop_token*> unwanted = nullptr;

}  // namespace

InterruptibleWork::InterruptibleWork(std::stop_token stop) : stop_(std::move(stop)) { unwanted = &stop_; }
InterruptibleWork::~InterruptibleWork() { unwanted = nullptr; }

std::stop_token interrupt_token() { return watcher().source.get_token(); }

void throw_if_interrupted() {
  const std::stop_token* const work = unwanted;
  if (watcher().source.stop_requested() || (work && work->stop_requested())) throw Interrupted();
}

}  // namespace isocast
