#include "runtime/app/interrupt.h"
#include "runtime/app/lesson_parts.h"
#include "runtime/app/stop_signal.h"
#include "tests/unit/runtime/rig.h"

#include <atomic>
#include <chrono>
#include <csignal>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

using namespace fulcrum::runtime::test;

namespace {

// What is noted is noted for good, and would end every run of this program: a process of its own tries it. 0 where all was right, else
// the number of what was not.
int try_signals() {
    watch_for_interrupts();
    if (interrupted()) {
        return 1;
    }
    int ends[2] = {};
    if (pipe(ends) != 0) {
        return 2;
    }
    (void)close(ends[0]);
    if (write(ends[1], "x", 1) != -1) {
        return 3;
    }
    (void)close(ends[1]);
    (void)std::raise(SIGXFSZ);
    if (interrupted() || interrupt_exit_code() != 0) {
        return 4;
    }
    if (!patience({})(2.0) || patience(2.0)(2.0)) {
        return 5;
    }
    (void)std::raise(SIGTERM);
    // What a lesson's process was asked before is waited for, but not for long.
    if (!patience({})(0.4) || patience({})(0.6)) {
        return 6;
    }
    return interrupted() && interrupt_exit_code() == 128 + SIGTERM ? 0 : 7;
}

// Read before any process is started, so that the others have it too.
const pid_t kTestProcess = ::getpid();

// Of this process and those it starts alone: other cases may run beside it. At most 15 letters are kept.
std::string test_name() {
    return "tried-" + std::to_string(kTestProcess);
}

constexpr uid_t kNobody = 65534;

constexpr std::chrono::seconds kPatience{10};

enum class Kind : std::uint8_t { usual, hangs, closed, of_another, pushes_on };

// How long a force is left after a stop, and what is given for the word of that to be heard.
constexpr std::chrono::milliseconds kFade{30};
constexpr std::chrono::milliseconds kHeard{600};

// Another process that can be stopped: it ends with 0 after its switch was pressed, with 1 if nobody does, with 2 after more signals than one.
int run_stoppable(int told, Kind kind) {
    watch_for_stop_signal(test_name().c_str());
    static StopSwitch target;
    set_stop_target(&target);
    // Nobody may look into it: the system then says that its folder is root's.
    if (kind == Kind::closed && ::prctl(PR_SET_DUMPABLE, 0) != 0) {
        return 3;
    }
    if (kind == Kind::of_another && ::setuid(kNobody) != 0) {
        return 3;
    }
    const char ready = 'r';
    (void)!::write(told, &ready, 1);
    const auto until = std::chrono::steady_clock::now() + kPatience;
    while (std::chrono::steady_clock::now() < until) {
        if (target.is_pressed()) {
            std::this_thread::sleep_for(kFade);
            target.tell_still(kind != Kind::pushes_on);
            std::this_thread::sleep_for(kHeard);
            return stop_signals_seen() == 1 ? 0 : 2;
        }
        // One that hangs asks for nothing and waits for nothing.
        if (kind != Kind::hangs) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }
    return 1;
}

// What a process of its own that does this ends with.
int exit_code_of(pid_t id) {
    int status = 0;
    return ::waitpid(id, &status, 0) == id && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

pid_t start_process(const std::function<int()>& deed) {
    const pid_t id = ::fork();
    if (id == 0) {
        ::_exit(deed());
    }
    return id;
}

// Started, and known to be so; its exit code is asked for once.
class Other {
  public:
    explicit Other(Kind kind = Kind::usual) {
        int ends[2];
        REQUIRE(::pipe(ends) == 0);
        id_ = start_process([&] { return run_stoppable(ends[1], kind); });
        ::close(ends[1]);
        char ready = 0;
        (void)!::read(ends[0], &ready, 1);
        ::close(ends[0]);
    }
    [[nodiscard]] pid_t id() const { return id_; }
    [[nodiscard]] int exit_code() const { return exit_code_of(id_); }
    // Until the system says that it is in this state.
    void await_state(char wanted) const {
        char state = ' ';
        const auto until = std::chrono::steady_clock::now() + kPatience;
        while (state != wanted && std::chrono::steady_clock::now() < until) {
            std::ifstream file("/proc/" + std::to_string(id_) + "/status");
            for (std::string word; file >> word && word != "State:";) {
            }
            file >> state;
        }
        CHECK(state == wanted);
    }

  private:
    pid_t id_;
};

StopOutcome stop_and_tell() {
    return value_of(stop_all_hands({.name = test_name()}));
}

// How many stopped, none of which was silent.
std::size_t stop_all() {
    const StopOutcome outcome = stop_and_tell();
    CHECK(outcome.silent.empty());
    return outcome.n_stopped;
}

}  // namespace

TEST_CASE("interrupt: the wish to end is noted; a closed pipe, a file too long are usual errors") {
    const pid_t child = ::fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        ::_exit(try_signals());
    }
    int status = 0;
    REQUIRE(::waitpid(child, &status, 0) == child);
    REQUIRE(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 0);
    CHECK_FALSE(interrupted());
}

TEST_CASE("stop signal: presses the switch of every process that can be stopped, and of no other") {
    const Other first;
    const Other second(Kind::hangs);
    const Other third(Kind::closed);
    const pid_t other = start_process([] {
        // Says nothing of itself: a signal would end it.
        std::this_thread::sleep_for(std::chrono::milliseconds(500));
        return 0;
    });
    CHECK(stop_all() == 3);
    CHECK(first.exit_code() == 0);
    CHECK(second.exit_code() == 0);
    CHECK(third.exit_code() == 0);
    CHECK(exit_code_of(other) == 0);
    // Nothing is left that could be told, and that is no error.
    CHECK(stop_all() == 0);
}

TEST_CASE("stop signal: what was killed is not counted, what is halted hears it later") {
    const Other killed;
    const Other halted;
    const Other living;
    REQUIRE(::kill(killed.id(), SIGKILL) == 0);
    killed.await_state('Z');  // it has ended, and nobody has buried it
    REQUIRE(::kill(halted.id(), SIGSTOP) == 0);
    halted.await_state('T');
    const StopOutcome outcome = stop_and_tell();
    CHECK(outcome.n_stopped == 1);
    CHECK(outcome.silent == std::vector{halted.id()});
    CHECK(living.exit_code() == 0);
    REQUIRE(::kill(halted.id(), SIGCONT) == 0);
    CHECK(halted.exit_code() == 0);
    CHECK(killed.exit_code() == -1);
}

TEST_CASE("stop signal: one whose force does not go is named, and so is it the next time") {
    const Other good;
    const Other bad(Kind::pushes_on);
    const auto began = std::chrono::steady_clock::now();
    const StopOutcome outcome = stop_and_tell();
    CHECK(outcome.n_stopped == 1);
    CHECK(outcome.silent == std::vector{bad.id()});
    CHECK(std::chrono::steady_clock::now() - began >= StopWhom{}.patience);
    // A word for an earlier stop is none for this one: what has given it and hangs since is named.
    REQUIRE(::kill(good.id(), SIGSTOP) == 0);
    good.await_state('T');
    CHECK(value_of(stop_all_hands({.name = test_name(), .only = good.id()})).silent ==
          std::vector{good.id()});
    for (const pid_t id : {good.id(), bad.id()}) {
        REQUIRE(::kill(id, SIGKILL) == 0);
        (void)exit_code_of(id);
    }
}

TEST_CASE("stop signal: a stranger under our name is neither counted nor told") {
    // No handler: the signal would end it.
    const pid_t mute = start_process([] {
        (void)::prctl(PR_SET_NAME, test_name().c_str());
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
        return 0;
    });
    // Another program that takes the signal for something else.
    const ScratchFolder folder;
    const std::string shell = folder.file("shell");
    std::filesystem::copy("/bin/bash", shell);
    const pid_t other = start_process([&] {
        const std::string script = "trap 'exit 7' USR1; printf " + test_name() +
                                   " >/proc/$$/comm; touch '" + folder.file("ready") +
                                   "'; for i in 1 2 3 4 5 6; do sleep 0.1; done";
        ::execl(shell.c_str(), "shell", "-c", script.c_str(), nullptr);
        return 1;
    });
    const auto until = std::chrono::steady_clock::now() + kPatience;
    while (!std::filesystem::exists(folder.file("ready")) &&
           std::chrono::steady_clock::now() < until) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    CHECK(stop_all() == 0);
    CHECK(exit_code_of(mute) == 0);
    CHECK(exit_code_of(other) == 0);
}

TEST_CASE("stop signal: one alone is stopped where it is named") {
    const Other meant;
    const Other left;
    CHECK(value_of(stop_all_hands({.name = test_name(), .only = meant.id()})).n_stopped == 1);
    CHECK(meant.exit_code() == 0);
    CHECK(stop_all() == 1);
    CHECK(left.exit_code() == 0);
}

TEST_CASE("stop signal: where nobody can see what runs, that is told and is no success") {
    const ScratchFolder folder;
    // Not there; a file; empty, as where it is not mounted; a process that tells nothing of itself.
    folder.write("file", "none");
    std::filesystem::create_directories(folder.file("empty"));
    std::filesystem::create_directories(folder.file("mute/" + std::to_string(::getpid())));
    for (const char* where : {"none", "file", "empty", "mute"}) {
        CAPTURE(where);
        const std::string stopped =
            refusal_of(stop_all_hands({.name = test_name(), .processes = folder.file(where)}));
        check_says(stopped, {"nobody can see what runs here"});
        CHECK(stopped.ends_with("switch the arm off."));
    }
}

TEST_CASE("stop signal: root stops everybody's, others their own alone") {
    if (::geteuid() != 0) {
        SUCCEED("only root can be somebody else");
        return;
    }
    const Other of_root;
    const Other of_nobody(Kind::of_another);
    // As nobody: that one alone is told.
    const pid_t stopper = start_process([] {
        const bool is_nobody = ::setuid(kNobody) == 0;
        const auto stopped = stop_all_hands({.name = test_name()});
        return is_nobody && stopped && stopped->n_stopped == 1 ? 0 : 1;
    });
    CHECK(exit_code_of(stopper) == 0);
    CHECK(of_nobody.exit_code() == 0);
    const Other again(Kind::of_another);
    CHECK(stop_all() == 2);
    CHECK(of_root.exit_code() == 0);
    CHECK(again.exit_code() == 0);
}

TEST_CASE("stop signal: none is lost between two targets, and none presses one that is gone") {
    const pid_t child = start_process([] {
        watch_for_stop_signal(test_name().c_str());
        constexpr unsigned kStops = 2000;
        // Signals come to one thread while the other changes what they press.
        std::atomic<bool> ended{false};
        std::thread sender([&] {
            for (unsigned i = 0; i < kStops; ++i) {
                (void)::pthread_kill(::pthread_self(), SIGUSR1);
            }
            ended.store(true);
        });
        unsigned pressed = 0;
        bool waits = true;
        while (waits) {
            waits = !ended.load();
            auto target = std::make_unique<StopSwitch>();
            set_stop_target(target.get());
            set_stop_target(nullptr);
            pressed += target->is_pressed() ? 1 : 0;
        }
        sender.join();
        return stop_signals_seen() == kStops && pressed > 0 ? 0 : 1;
    });
    CHECK(exit_code_of(child) == 0);
}

TEST_CASE("stop signal: one that comes while nothing can be stopped stops what comes next") {
    const pid_t child = start_process([] {
        watch_for_stop_signal(test_name().c_str());
        (void)::raise(SIGUSR1);
        StopSwitch next;
        set_stop_target(&next);
        StopSwitch after;
        set_stop_target(&after);
        return next.is_pressed() && !after.is_pressed() && stop_signals_seen() == 1 ? 0 : 1;
    });
    CHECK(exit_code_of(child) == 0);
}
