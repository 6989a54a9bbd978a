#include "runtime/app/stop_signal.h"

#include <atomic>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

namespace fulcrum::runtime {
namespace {

std::atomic<StopSwitch*> stop_target{nullptr};
std::atomic<unsigned> stops_seen{0};
std::atomic<bool> stop_waits{false};  // it came while nothing could be stopped yet
static_assert(std::atomic<StopSwitch*>::is_always_lock_free &&
              std::atomic<unsigned>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

extern "C" void press_stop(int /*signal*/) {
    if (StopSwitch* const target = stop_target.load(std::memory_order_acquire)) {
        target->press();
    } else {
        stop_waits.store(true, std::memory_order_release);
    }
    stops_seen.fetch_add(1, std::memory_order_release);
}

// Running as this user, under the name that says that it can be stopped.
bool can_be_stopped(const std::filesystem::path& process, std::string_view wanted) {
    struct stat about {};
    if (::stat(process.c_str(), &about) != 0 || about.st_uid != ::geteuid()) {
        return false;
    }
    std::ifstream file(process / "comm");
    std::string name;
    return std::getline(file, name) && name == wanted;
}

std::vector<pid_t> find_stoppable(std::string_view wanted) {
    std::vector<pid_t> found;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator("/proc", error)) {
        const std::string name = entry.path().filename();
        pid_t id = 0;
        const auto parsed = std::from_chars(name.data(), name.data() + name.size(), id);
        if (parsed.ec == std::errc{} && parsed.ptr == name.data() + name.size() &&
            id != ::getpid() && can_be_stopped(entry.path(), wanted)) {
            found.push_back(id);
        }
    }
    return found;
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
    if (target != nullptr && stop_waits.exchange(false, std::memory_order_seq_cst)) {
        target->press();
    }
}

unsigned stop_signals_seen() noexcept {
    return stops_seen.load(std::memory_order_acquire);
}

Expected<std::size_t> stop_all_hands(const char* name) {
    std::size_t n_stopped = 0;
    std::string missed;
    for (const pid_t id : find_stoppable(name)) {
        if (::kill(id, SIGUSR1) == 0) {
            ++n_stopped;
        } else if (errno != ESRCH) {
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
