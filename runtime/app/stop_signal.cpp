#include "runtime/app/stop_signal.h"

#include <atomic>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace fulcrum::runtime {
namespace {

std::atomic<StopSwitch*> stop_target{nullptr};
std::atomic<unsigned> stops_seen{0};
std::atomic<bool> stop_waits{false};  // it came while nothing could be stopped yet
std::atomic<int> presses_running{0};  // handlers that may have the old target still
static_assert(std::atomic<StopSwitch*>::is_always_lock_free &&
              std::atomic<unsigned>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

extern "C" void press_stop(int /*signal*/) {
    presses_running.fetch_add(1, std::memory_order_seq_cst);
    if (StopSwitch* const target = stop_target.load(std::memory_order_seq_cst)) {
        target->press();
    } else {
        stop_waits.store(true, std::memory_order_seq_cst);
    }
    stops_seen.fetch_add(1, std::memory_order_release);
    presses_running.fetch_sub(1, std::memory_order_seq_cst);
}

// What the system says of a process; the owner of its folder would not do, for that of one that may not be looked into is root.
struct ProcessStatus {
    std::string name;
    char state = 'X';
    uid_t user = 0;  // the real one
};

ProcessStatus read_status(const std::string& processes, pid_t id) {
    ProcessStatus status;
    std::ifstream file(processes + "/" + std::to_string(id) + "/status");
    for (std::string word; file >> word;) {
        if (word == "Name:") {
            file >> status.name;
        } else if (word == "State:") {
            file >> status.state;
        } else if (word == "Uid:") {
            file >> status.user;
            break;
        }
    }
    return status;
}

// Running, of this user or for root of anybody, under the name that says that it can be stopped. What has ended and was not buried feels
// nothing any more.
bool can_be_stopped(const ProcessStatus& status, std::string_view wanted) {
    const uid_t me = ::geteuid();
    return status.name == wanted && status.state != 'Z' && status.state != 'X' &&
           (me == 0 || status.user == me || status.user == ::getuid());
}

// All but this one. A folder in which not even this one is to be seen tells nothing.
Expected<std::vector<pid_t>> list_processes(const std::string& processes) {
    std::vector<pid_t> found;
    bool sees_itself = false;
    std::error_code error;
    for (std::filesystem::directory_iterator entry(processes, error), end; !error && entry != end;
         entry.increment(error)) {
        const std::string name = entry->path().filename();
        pid_t id = 0;
        const auto parsed = std::from_chars(name.data(), name.data() + name.size(), id);
        if (parsed.ec != std::errc{} || parsed.ptr != name.data() + name.size()) {
            continue;
        }
        if (id == ::getpid()) {
            sees_itself = read_status(processes, id).state != ProcessStatus{}.state;
        } else {
            found.push_back(id);
        }
    }
    if (error || !sees_itself) {
        return fail("nobody can see what runs here" + (error ? ": " + error.message() : ""),
                    processes, "switch the arm off");
    }
    return found;
}

enum class Told : std::uint8_t { no_hand, stopped, missed };

// Held fast before it is looked at: its number may be another's by the time that it is told (pidfd_open(2)). `errno` says why it was missed.
Told tell_to_stop(const StopWhom& whom, pid_t id) {
    if (!can_be_stopped(read_status(whom.processes, id), whom.name)) {
        return Told::no_hand;
    }
    const int process = static_cast<int>(::syscall(SYS_pidfd_open, id, 0));
    if (process < 0) {
        return errno == ESRCH ? Told::no_hand : Told::missed;
    }
    Told told = Told::no_hand;
    if (can_be_stopped(read_status(whom.processes, id), whom.name)) {
        const long sent = ::syscall(SYS_pidfd_send_signal, process, SIGUSR1, nullptr, 0);
        told = sent == 0 ? Told::stopped : errno == ESRCH ? Told::no_hand : Told::missed;
    }
    const int why = errno;
    ::close(process);
    errno = why;
    return told;
}

}  // namespace

void watch_for_stop_signal(const char* name) {
    struct sigaction action {};
    action.sa_handler = press_stop;
    action.sa_flags = SA_RESTART;
    (void)sigaction(SIGUSR1, &action, nullptr);
    // Only now may others know: before, the signal would have ended the program.
    (void)::prctl(PR_SET_NAME, name);
}

void set_stop_target(StopSwitch* target) noexcept {
    stop_target.store(target, std::memory_order_seq_cst);
    // Who began before that, on another thread, presses the old one or says that there was none: neither may be missed.
    while (presses_running.load(std::memory_order_seq_cst) != 0) {
        std::this_thread::yield();
    }
    if (target != nullptr && stop_waits.exchange(false, std::memory_order_seq_cst)) {
        target->press();
    }
}

unsigned stop_signals_seen() noexcept {
    return stops_seen.load(std::memory_order_acquire);
}

Expected<std::size_t> stop_all_hands(const StopWhom& whom) {
    const auto running = list_processes(whom.processes);
    if (!running) {
        return tl::unexpected(running.error());
    }
    std::size_t n_stopped = 0;
    std::string missed;
    for (const pid_t id : *running) {
        if (id != whom.only.value_or(id)) {
            continue;
        }
        const Told told = tell_to_stop(whom, id);
        n_stopped += told == Told::stopped ? 1 : 0;
        if (told == Told::missed) {
            missed += (missed.empty() ? "" : ", ") + std::to_string(id) + " (" +
                      std::strerror(errno) + ")";
        }
    }
    if (!missed.empty()) {
        return fail("these could not be told to stop: " + missed, "",
                    "end them, or switch the arm off");
    }
    return n_stopped;
}

}  // namespace fulcrum::runtime
