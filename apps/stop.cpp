#include "stop.hpp"

#include <atomic>
#include <csignal>

namespace scalebreak::apps {
namespace {

std::atomic<bool> told = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler sets it");

}  // namespace

void stop_on_signals() {
  struct sigaction action = {};
  action.sa_handler = [](int) { told = true; };
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  for (const int signal : {SIGINT, SIGTERM}) sigaction(signal, &action, nullptr);
}

bool told_to_stop() { return told; }

}  // namespace scalebreak::apps
