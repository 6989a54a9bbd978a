#include "runtime/app/interrupt.h"

#include <atomic>
#include <csignal>

namespace fulcrum::runtime {
namespace {

std::atomic<int> signal_seen{0};

extern "C" void note_interrupt(int signal) {
    signal_seen.store(signal, std::memory_order_relaxed);
}

}  // namespace

void watch_for_interrupts() {
    struct sigaction action {};
    action.sa_handler = note_interrupt;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        (void)sigaction(signal, &action, nullptr);
    }
    // Nobody reads any more, or a file may not become longer: that is an ordinary error of who writes.
    (void)std::signal(SIGPIPE, SIG_IGN);
    (void)std::signal(SIGXFSZ, SIG_IGN);
}

bool interrupted() noexcept {
    return signal_seen.load(std::memory_order_relaxed) != 0;
}

int interrupt_exit_code() noexcept {
    constexpr int kShells = 128;  // what shells add to a signal's number
    const int signal = signal_seen.load(std::memory_order_relaxed);
    return signal == 0 ? 0 : kShells + signal;
}

}  // namespace fulcrum::runtime
