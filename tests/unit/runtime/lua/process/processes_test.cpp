#include "runtime/lua/process/child_process.h"
#include "runtime/lua/process/lesson_process.h"
#include "runtime/lua/process/lesson_sources.h"
#include "runtime/lua/process/turn_taking.h"
#include "runtime/lua/sandbox/sandbox.h"
#include "tests/unit/runtime/lua/lesson_folder.h"
#include "tests/unit/runtime/rig.h"

#include <cerrno>
#include <csignal>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace fulcrum::runtime::test;
namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMemory = 4U << 20U;

int open_files() {
    int n = 0;
    for ([[maybe_unused]] const auto& entry :
         std::filesystem::directory_iterator("/proc/self/fd")) {
        ++n;
    }
    return n;
}

std::optional<int> socket_of(std::vector<std::string> arguments) {
    std::vector<char*> pointers;
    for (std::string& argument : arguments) {
        pointers.push_back(argument.data());
    }
    return lesson_process_socket(static_cast<int>(pointers.size()), pointers.data());
}

/// The exit code of the program started as a lesson's process by hand, with a number but nothing behind it.
int exit_code_with(const char* number) {
    const std::string program = lesson_helper();
    const pid_t pid = fork();
    if (pid == 0) {
        execl(program.c_str(), "helper", "--lesson-process", number, static_cast<char*>(nullptr));
        _exit(99);
    }
    int status = 0;
    REQUIRE(waitpid(pid, &status, 0) == pid);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// The sentence of a lesson that is started where the system refuses the call of that number.
std::string sentence_without(long number) {
    const LessonFolder folder;
    std::array<int, 2> ends{};
    REQUIRE(pipe(ends.data()) == 0);
    const pid_t pid = fork();
    REQUIRE(pid >= 0);
    if (pid == 0) {
        std::array<sock_filter, 4> filter = {
            sock_filter{BPF_LD | BPF_W | BPF_ABS, 0, 0, offsetof(seccomp_data, nr)},
            sock_filter{BPF_JMP | BPF_JEQ | BPF_K, 0, 1, static_cast<std::uint32_t>(number)},
            sock_filter{BPF_RET | BPF_K, 0, 0, SECCOMP_RET_ERRNO | ENOSYS},
            sock_filter{BPF_RET | BPF_K, 0, 0, SECCOMP_RET_ALLOW}};
        const sock_fprog program{static_cast<unsigned short>(filter.size()), filter.data()};
        if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 ||
            prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) != 0) {
            _exit(1);
        }
        const auto process = folder.start(lesson_text(""));
        const std::string said = process ? "started" : to_sentence(process.error());
        _exit(write(ends[1], said.data(), said.size()) == static_cast<ssize_t>(said.size()) ? 0
                                                                                            : 1);
    }
    close(ends[1]);
    std::array<char, 1000> said{};
    const ssize_t n = read(ends[0], said.data(), said.size());
    close(ends[0]);
    int status = 0;
    REQUIRE(waitpid(pid, &status, 0) == pid);
    return {said.data(), static_cast<std::size_t>(std::max<ssize_t>(n, 0))};
}

// Another process that waits to be killed.
class Waiting {
  public:
    Waiting() : id_(::fork()) {
        while (id_ == 0) {
            ::pause();
        }
    }
    Waiting(const Waiting&) = delete;
    Waiting& operator=(const Waiting&) = delete;
    ~Waiting() { end(); }
    void end() {
        if (id_ > 0) {
            ::kill(id_, SIGKILL);
            ::waitpid(id_, nullptr, 0);
            id_ = -1;
        }
    }
    [[nodiscard]] pid_t id() const { return id_; }

  private:
    pid_t id_;
};

cpu_set_t affinity_of(pid_t process) {
    cpu_set_t set;
    CPU_ZERO(&set);
    CHECK(::sched_getaffinity(process, sizeof set, &set) == 0);
    return set;
}

bool same(const cpu_set_t& a, const cpu_set_t& b) {
    return CPU_EQUAL(&a, &b) != 0;
}

}  // namespace

TEST_CASE("child process: starts, waits for a message, uses little time, is ended and reaped") {
    const int files_before = open_files();
    {
        auto child = ChildProcess::start(lesson_helper(), kMemory);
        REQUIRE(child);
        const pid_t pid = (*child)->pid();
        CHECK(pid > 0);
        CHECK(getpgid(pid) == pid);  // a Ctrl-C does not reach it
        CHECK((*child)->cpu_s() < 10.0);
        const ProcessEnd end = (*child)->end();
        CHECK(end.by_signal);
        CHECK(end.code == SIGKILL);
        CHECK((*child)->end().code == SIGKILL);  // the same each time
        CHECK((*child)->pid() == -1);
        CHECK((*child)->cpu_s() == 0.0);
        CHECK(waitpid(pid, nullptr, WNOHANG) == -1);
        CHECK((*child)->last_seen().line == 0);
    }
    CHECK(open_files() == files_before);
}

TEST_CASE("child process: how a process ended by itself is known") {
    auto child = ChildProcess::start("/bin/false", kMemory);
    REQUIRE(child);
    (*child)->wait_readable(30.0);  // the other end closes
    siginfo_t info{};
    waitid(P_PID, static_cast<id_t>((*child)->pid()), &info, WEXITED | WNOWAIT);
    const ProcessEnd end = (*child)->end();
    CHECK_FALSE(end.by_signal);
    CHECK(end.code == 1);
}

TEST_CASE("child process: the processor time it used to start is seen") {
    auto child = ChildProcess::start(lesson_helper(), kMemory);
    REQUIRE(child);
    double used_s = 0.0;
    for (int i = 0; i < 10'000 && used_s == 0.0; ++i) {
        (*child)->wait_readable(0.001);
        used_s = (*child)->cpu_s();
    }
    CHECK(used_s > 0.0);
}

TEST_CASE("child process: an executable that is not there is an error, and leaves nothing open") {
    const int files_before = open_files();
    CHECK_FALSE(ChildProcess::start("/nonexistent", kMemory));
    CHECK(open_files() == files_before);
}

TEST_CASE("lesson child: only the hidden argument makes a lesson's process") {
    CHECK_FALSE(socket_of({"fulcrum"}));
    CHECK_FALSE(socket_of({"fulcrum", "run", "gravity"}));
    CHECK_FALSE(socket_of({"fulcrum", "--lesson-process"}));
    CHECK_FALSE(socket_of({"fulcrum", "--lesson-process", "3", "4"}));
    CHECK(socket_of({"fulcrum", "--lesson-process", "3"}) == 3);
    CHECK(socket_of({"fulcrum", "--lesson-process", "x"}) == -1);
    CHECK(socket_of({"fulcrum", "--lesson-process", "3x"}) == -1);
}

TEST_CASE("lesson child: started by hand it ends at once") {
    CHECK(exit_code_with("x") == 1);
    CHECK(exit_code_with("0") == 1);
    CHECK(exit_code_with("900") == kWallExitCode + static_cast<int>(Wall::page));
}

TEST_CASE("lesson child: where a wall can't be put up, the sentence says which") {
    constexpr const char* kWhatToDo =
        "; use Linux 5.9 or later, in a container only one that allows seccomp.";
    CHECK(sentence_without(SYS_getpgid) == "started");
    CHECK(sentence_without(SYS_close_range) ==
          std::string("no lesson can be run safely here: the system can't close its files "
                      "(close_range)") +
              kWhatToDo);
    CHECK(sentence_without(SYS_seccomp) ==
          std::string("no lesson can be run safely here: the system can't filter system calls "
                      "(seccomp)") +
              kWhatToDo);
    for (int wall = 0; wall < kWalls; ++wall) {
        CHECK(std::string(wall_text(static_cast<Wall>(wall))).size() > 10);
    }
}

TEST_CASE("lesson sources: a module comes from the library first, then from the lesson's folder") {
    const LessonFolder folder;
    folder.write("story.lua", "mine");
    folder.write("helper.lua", "return 1");
    LessonSources sources(folder.files());
    CHECK(sources.find_module("story").source.name == "lib/story.lua");
    const ModuleAnswer helper = sources.find_module("helper");
    CHECK(helper.found);
    CHECK(helper.source.name == "helper.lua");
    CHECK(helper.source.text == "return 1");
    CHECK(sources.known_name("helper.lua") == "helper.lua");
    CHECK(sources.known_name("/etc/passwd") == "lesson.lua");
}

TEST_CASE("lesson sources: names that lead elsewhere, links, pipes and folders are refused") {
    const LessonFolder folder;
    LessonSources sources(folder.files());
    for (const char* name : {"", "..", "../x", "a/b", "/etc/passwd", "a.b", "A", "a-b"}) {
        CHECK_FALSE(sources.find_module(name).found);
    }
    fs::create_symlink("/etc/passwd", folder.path() / "link.lua");
    CHECK(sources.find_module("link").problem == "the file can't be read (is a symbolic link)");
    REQUIRE(mkfifo((folder.path() / "pipe.lua").c_str(), 0600) == 0);
    CHECK(sources.find_module("pipe").problem == "this is no plain file");
    fs::create_directory(folder.path() / "folder.lua");
    CHECK_FALSE(sources.find_module("folder").found);
    CHECK(sources.find_module("nothing").problem ==
          "there is no nothing.lua beside the lesson nor in the library");
    folder.write("know.lua", "return 1");
    CHECK(sources.find_module("now").problem ==
          "there is no now.lua beside the lesson nor in the library; did you mean \"know\"?");
}

TEST_CASE("lesson sources: a byte order mark goes, compiled Lua and giants are refused") {
    const LessonFolder folder;
    LessonSources sources(folder.files());
    folder.write("lesson.lua", "\xEF\xBB\xBFreturn 1");
    CHECK(sources.read_lesson()->text == "return 1");
    folder.write("lesson.lua", "\x1BLua");
    CHECK_THAT(to_sentence(sources.read_lesson().error()), Catch::Contains("this is compiled Lua"));
    folder.write("lesson.lua", std::string(kMaxSourceBytes, ' '));
    CHECK(sources.read_lesson()->text.size() == kMaxSourceBytes);
    folder.write("lesson.lua", std::string(kMaxSourceBytes + 1, ' '));
    CHECK_THAT(to_sentence(sources.read_lesson().error()), Catch::Contains("longer than 512 KB"));
}

TEST_CASE("lesson sources: a missing lesson is one sentence") {
    const LessonFolder folder;
    LessonSources sources(folder.files());
    CHECK_THAT(to_sentence(sources.read_lesson().error()),
               Catch::Contains("lesson.lua: the file can't be read (No such file or directory); "
                               "check the name and the folder."));
}

TEST_CASE("lesson sources: at most so many files") {
    const LessonFolder folder;
    LessonSources sources(folder.files());
    int n_found = 0;
    for (int i = 0; i < 40; ++i) {
        const std::string name = "m" + std::to_string(i);
        folder.write(name + ".lua", "");
        n_found += sources.find_module(name).found ? 1 : 0;
    }
    CHECK(n_found == 32);
}

TEST_CASE("turn taking: both are on one processor while they take turns, and free again after it") {
    const cpu_set_t before = affinity_of(0);
    Waiting other;
    const cpu_set_t others = affinity_of(other.id());
    {
        TurnTaking turns(other.id());
        CHECK_FALSE(turns.is_together());
        CHECK(same(affinity_of(0), before));
        for (int i = 0; i < TurnTaking::kTurns; ++i) {
            turns.turn();
        }
        CHECK(turns.is_together());
        const cpu_set_t here = affinity_of(0);
        CHECK(CPU_COUNT(&here) == 1);
        CHECK(same(affinity_of(other.id()), here));
        CHECK(CPU_ISSET(::sched_getcpu(), &here));
    }
    CHECK(same(affinity_of(0), before));
    CHECK(same(affinity_of(other.id()), others));
}

TEST_CASE("turn taking: one that is gone, or was never there, changes nothing for long") {
    const cpu_set_t before = affinity_of(0);
    Waiting other;
    {
        TurnTaking turns(other.id());
        other.end();
        for (int i = 0; i < 4 * TurnTaking::kTurns; ++i) {
            turns.turn();
        }
        TurnTaking nobody(-1);
        for (int i = 0; i < 4 * TurnTaking::kTurns; ++i) {
            nobody.turn();
        }
        CHECK_FALSE(nobody.is_together());
    }
    CHECK(same(affinity_of(0), before));
}
