// The lesson's side: close off, load, answer frames until the program goes.
#include "runtime/lua/host/lesson_host.h"
#include "runtime/lua/process/lesson_process.h"
#include "runtime/lua/process/shared_page.h"
#include "runtime/lua/sandbox/sandbox.h"
#include "runtime/lua/wire/channel.h"

#include <charconv>
#include <cstring>
#include <exception>
#include <new>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <unistd.h>

namespace fulcrum::runtime {
namespace {

constexpr std::size_t kOwnMemoryBytes = 48U
                                        << 20U;  // messages and the C++ side, beyond the Lua arenas
constexpr std::size_t kMostScripts = 1 + kMostHands;  // the lesson, and simulated hands

/// The talk with the program. What it can't send or read ends the process.
class Talk {
  public:
    explicit Talk(int socket) : channel_(socket, kMaxMessageBytes) {}

    template <class Message>
    [[nodiscard]] bool tell(const Message& message) {
        out_.clear();
        encode(message, out_);
        return channel_.send(out_) == out_.size();
    }
    /// The program takes no longer message: then why, and false.
    [[nodiscard]] bool tell(const LessonDescription& description) {
        out_.clear();
        encode(description, out_);
        constexpr std::size_t kKilobyte = 1U << 10U;
        if (out_.size() > kMaxAnswerBytes) {
            static_cast<void>(tell(ScriptError{
                "the lesson's questions, bodies and tests are " +
                    std::to_string(out_.size() / kKilobyte) + " kB of text in all, and " +
                    std::to_string(kMaxAnswerBytes / kKilobyte) +
                    " kB are the most; take some out, or make two lessons of it",
                "lesson.lua", 0}));
            return false;
        }
        return channel_.send(out_) == out_.size();
    }
    /// Waits for a message of that kind; anything else is the end.
    [[nodiscard]] std::optional<std::span<const std::uint8_t>> hear(WireKind kind) {
        RawMessage message;
        Channel::Result result = Channel::Result::nothing;
        while (result == Channel::Result::nothing) {
            result = channel_.receive(message);
        }
        if (result != Channel::Result::message || message.kind != kind) {
            return std::nullopt;
        }
        return message.body;
    }

  private:
    Channel channel_;
    Bytes out_;
};

ModuleAnswer ask_for_module(Talk& talk, const std::string& name) {
    ModuleAnswer none;
    none.problem = "the program does not answer";
    if (!talk.tell(ModuleRequest{name})) {
        return none;
    }
    const auto bytes = talk.hear(WireKind::module_answer);
    if (!bytes) {
        return none;
    }
    auto answer = decode_module_answer(*bytes);
    return answer ? std::move(*answer) : none;
}

/// Loads and plays the lesson; the exit code.
int play(Talk& talk, SharedPage* page) {
    const auto load_bytes = talk.hear(WireKind::load);
    auto load = load_bytes ? decode_load(*load_bytes) : fail("no load message");
    if (!load) {
        return 1;
    }
    HostServices services;
    services.running_line = &page->running;
    services.find_module = [&talk](const std::string& name) { return ask_for_module(talk, name); };
    services.print_while_loading = [&talk](const std::string& text) {
        static_cast<void>(talk.tell(PrintCommand{text}));
    };
    LessonHost host(*load, services);
    if (const auto error = host.load()) {
        static_cast<void>(talk.tell(*error));
        return 1;
    }
    if (!talk.tell(host.description())) {
        return 1;
    }
    while (const auto bytes = talk.hear(WireKind::frame)) {
        const auto frame = decode_frame(*bytes);
        LessonReply reply;
        const auto error =
            frame ? host.run_frame(*frame, reply) : ScriptError{frame.error().message, "", 0};
        if (error) {
            static_cast<void>(talk.tell(*error));
            return 1;
        }
        if (!talk.tell(reply)) {
            return 1;
        }
    }
    return 0;
}

/// Maps the page, closes everything else and puts up the walls.
Walled<SharedPage*> close_off(int socket) {
    const int page_file = socket + 1;
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    void* mapped =
        mmap(nullptr, kSharedPageBytes, PROT_READ | PROT_WRITE, MAP_SHARED, page_file, 0);
    if (mapped == MAP_FAILED) {
        return tl::unexpected(Wall::page);
    }
    if (auto closed = close_all_files_but(socket, page_file); !closed) {
        return tl::unexpected(closed.error());
    }
    close(page_file);
    auto* page = static_cast<SharedPage*>(mapped);
    const SandboxSettings settings{socket, kMostScripts * page->memory_bytes + kOwnMemoryBytes};
    if (auto entered = enter_sandbox(settings); !entered) {
        return tl::unexpected(entered.error());
    }
    return page;
}

/// Closes off and plays; the exit code.
int play_behind_walls(int socket) {
    const auto page = close_off(socket);
    if (!page) {
        return kWallExitCode + static_cast<int>(page.error());
    }
    Talk talk(socket);
    try {
        return play(talk, *page);
    } catch (const std::bad_alloc&) {
        static_cast<void>(
            talk.tell(ScriptError{"this needs more memory than a lesson may have", "", 0}));
    }
    return 1;
}

}  // namespace

std::optional<int> lesson_process_socket(int argc, char** argv) {
    if (argc != 3 || std::strcmp(argv[1], kLessonArgument) != 0) {
        return std::nullopt;
    }
    int socket = -1;
    const char* end = argv[2] + std::strlen(argv[2]);
    const auto [stop, problem] = std::from_chars(argv[2], end, socket);
    return problem == std::errc{} && stop == end ? socket : -1;
}

int lesson_process_main(int socket) {
    int code = 1;
    try {
        code = socket > STDERR_FILENO ? play_behind_walls(socket) : 1;
    } catch (const std::exception&) {
        code = 1;
    }
    // No farewell of the C library: nothing here is worth saving, and its system calls are not allowed.
    _exit(code);
}

}  // namespace fulcrum::runtime
