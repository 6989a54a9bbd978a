#include "runtime/app/stop_signal.h"

#include <atomic>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <pthread.h>
#include <semaphore.h>
#include <string>
#include <string_view>
#include <sys/syscall.h>
#include <thread>
#include <unistd.h>
#include <utility>
#include <vector>

namespace fulcrum::runtime {
namespace {

std::atomic<StopSwitch*> stop_target{nullptr};
std::atomic<unsigned> stops_seen{0};
std::atomic<bool> stop_waits{false};  // it came while nothing could be stopped yet
std::atomic<int> target_users{0};     // handlers and others that may have the old target still
sem_t signal_came;                    // for who gives this process' word
static_assert(std::atomic<StopSwitch*>::is_always_lock_free &&
              std::atomic<unsigned>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

extern "C" void press_stop(int /*signal*/) {
    target_users.fetch_add(1, std::memory_order_seq_cst);
    if (StopSwitch* const target = stop_target.load(std::memory_order_seq_cst)) {
        target->press();
    } else {
        stop_waits.store(true, std::memory_order_seq_cst);
    }
    stops_seen.fetch_add(1, std::memory_order_release);
    target_users.fetch_sub(1, std::memory_order_seq_cst);
    (void)::sem_post(&signal_came);
}

bool has_no_force() noexcept {
    target_users.fetch_add(1, std::memory_order_seq_cst);
    const StopSwitch* const target = stop_target.load(std::memory_order_seq_cst);
    const bool is_still = target == nullptr || target->is_still();
    target_users.fetch_sub(1, std::memory_order_seq_cst);
    return is_still;
}

// What a process is called that has given its word after so many signals. Of a name 15 letters are kept.
constexpr std::size_t kMostLetters = 13;
std::string find_still_name(const std::string& name, unsigned n_signals) {
    return name + "!" + std::to_string(n_signals % 10);
}

// After each signal, once no force is left, until the process ends. A stop that is lifted first gets no word.
void give_word(pthread_t main_thread, const std::string& name) {
    constexpr std::chrono::milliseconds kLook{2};
    constexpr std::chrono::seconds kLongestFade{1};
    while (true) {
        if (::sem_wait(&signal_came) != 0) {
            continue;
        }
        const unsigned n_signals = stop_signals_seen();
        const auto until = std::chrono::steady_clock::now() + kLongestFade;
        while (!has_no_force() && std::chrono::steady_clock::now() < until) {
            std::this_thread::sleep_for(kLook);
        }
        if (has_no_force()) {
            (void)::pthread_setname_np(main_thread, find_still_name(name, n_signals).c_str());
        }
    }
}

// What the system says of a process; the owner of its folder would not do, for that of one that may not be looked into is root.
struct ProcessStatus {
    std::string name;
    char state = 'X';
    uid_t user = 0;             // the real one
    bool takes_signal = false;  // has a handler for it: without one it would end it
    [[nodiscard]] bool is_gone() const { return state == 'Z' || state == 'X'; }
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
        } else if (word == "SigCgt:") {
            unsigned long long handled = 0;
            file >> std::hex >> handled;
            status.takes_signal = (handled >> (SIGUSR1 - 1) & 1U) != 0;
            break;
        }
    }
    return status;
}

// Of this program, wherever it is installed. One that nobody may look into is believed.
bool is_ours(const std::string& processes, pid_t id) {
    const auto program_of = [&](pid_t process) {
        std::error_code error;
        std::string name =
            std::filesystem::read_symlink(processes + "/" + std::to_string(process) + "/exe", error)
                .filename();
        constexpr std::string_view kReplaced = " (deleted)";  // by a newer one
        if (name.ends_with(kReplaced)) {
            name.resize(name.size() - kReplaced.size());
        }
        return name;
    };
    const std::string other = program_of(id);
    return other.empty() || other == program_of(::getpid());
}

// Running, of this user or for root of anybody, under a name that says that it can be stopped. What has ended and was not buried feels
// nothing any more.
bool can_be_stopped(const ProcessStatus& status, std::string_view wanted) {
    const uid_t me = ::geteuid();
    const bool is_called_so =
        status.name == wanted || status.name.starts_with(std::string(wanted) + "!");
    return is_called_so && status.takes_signal && !status.is_gone() &&
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
// `name`: what it was called just before.
Told tell_to_stop(const StopWhom& whom, pid_t id, std::string& name) {
    if (!can_be_stopped(read_status(whom.processes, id), whom.name) ||
        !is_ours(whom.processes, id)) {
        return Told::no_hand;
    }
    const int process = static_cast<int>(::syscall(SYS_pidfd_open, id, 0));
    if (process < 0) {
        return errno == ESRCH ? Told::no_hand : Told::missed;
    }
    Told told = Told::no_hand;
    const ProcessStatus status = read_status(whom.processes, id);
    if (can_be_stopped(status, whom.name)) {
        name = status.name;
        const long sent = ::syscall(SYS_pidfd_send_signal, process, SIGUSR1, nullptr, 0);
        told = sent == 0 ? Told::stopped : errno == ESRCH ? Told::no_hand : Told::missed;
    }
    const int why = errno;
    ::close(process);
    errno = why;
    return told;
}

// A process that was told, and its name at that time.
struct ToldProcess {
    pid_t id = 0;
    std::string name;
};

// Leaves in `told` those that have given no word by then.
void await_words(const StopWhom& whom, std::vector<ToldProcess>& told) {
    constexpr std::chrono::milliseconds kLook{5};
    const std::string still = whom.name + "!";
    const auto gave_word = [&](const ToldProcess& process) {
        const ProcessStatus status = read_status(whom.processes, process.id);
        return status.is_gone() || (status.name.starts_with(still) && status.name != process.name);
    };
    const auto until = std::chrono::steady_clock::now() + whom.patience;
    while (std::erase_if(told, gave_word), !told.empty()) {
        if (std::chrono::steady_clock::now() >= until) {
            return;
        }
        std::this_thread::sleep_for(kLook);
    }
}

}  // namespace

void watch_for_stop_signal(const char* name) {
    struct sigaction action {};
    action.sa_handler = press_stop;
    action.sa_flags = SA_RESTART;
    (void)::sem_init(&signal_came, 0, 0);
    (void)sigaction(SIGUSR1, &action, nullptr);
    // Only now may others know: before, the signal would have ended the program.
    const std::string own = std::string(name).substr(0, kMostLetters);
    (void)::pthread_setname_np(::pthread_self(), own.c_str());
    std::thread(give_word, ::pthread_self(), own).detach();
}

void set_stop_target(StopSwitch* target) noexcept {
    stop_target.store(target, std::memory_order_seq_cst);
    // Who began before that, on another thread, presses the old one or says that there was none: neither may be missed.
    while (target_users.load(std::memory_order_seq_cst) != 0) {
        std::this_thread::yield();
    }
    if (target != nullptr && stop_waits.exchange(false, std::memory_order_seq_cst)) {
        target->press();
    }
}

unsigned stop_signals_seen() noexcept {
    return stops_seen.load(std::memory_order_acquire);
}

Expected<StopOutcome> stop_all_hands(const StopWhom& whom) {
    const auto running = list_processes(whom.processes);
    if (!running) {
        return tl::unexpected(running.error());
    }
    std::vector<ToldProcess> told;
    std::string missed;
    for (const pid_t id : *running) {
        if (id != whom.only.value_or(id)) {
            continue;
        }
        ToldProcess process{id, {}};
        switch (tell_to_stop(whom, id, process.name)) {
            case Told::no_hand:
                break;
            case Told::stopped:
                told.push_back(std::move(process));
                break;
            case Told::missed:
                missed += (missed.empty() ? "" : ", ") + std::to_string(id) + " (" +
                          std::strerror(errno) + ")";
                break;
        }
    }
    if (!missed.empty()) {
        return fail("these could not be told to stop: " + missed, "",
                    "end them, or switch the arm off");
    }
    StopOutcome outcome{told.size(), {}};
    await_words(whom, told);
    outcome.n_stopped -= told.size();
    for (const ToldProcess& process : told) {
        outcome.silent.push_back(process.id);
    }
    return outcome;
}

}  // namespace fulcrum::runtime
