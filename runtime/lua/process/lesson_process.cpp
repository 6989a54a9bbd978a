#include "runtime/lua/process/lesson_process.h"

#include "haptics/base/clock.h"
#include "haptics/base/sanitized.h"
#include "runtime/lua/process/child_process.h"
#include "runtime/lua/process/lesson_sources.h"
#include "runtime/lua/sandbox/sandbox.h"
#include "runtime/lua/wire/channel.h"

#include <cmath>
#include <cstring>
#include <signal.h>

namespace fulcrum::runtime {
namespace {

constexpr double kSlowness = kSanitized ? 10.0 : 1.0;
constexpr double kLookEvery_s = 0.02;  // between two looks at the clocks while waiting
constexpr std::size_t kMaxLoadPrints = 200;

std::string milliseconds(double time_s) {
    return std::to_string(static_cast<int>(std::lround(time_s * 1000.0))) + " ms";
}

}  // namespace

struct LessonProcess::Parts {
    Parts(LessonSources sources_read, LessonProcessOptions chosen,
          std::unique_ptr<ChildProcess> started)
        : sources(std::move(sources_read)),
          options(std::move(chosen)),
          child(std::move(started)),
          channel(child->socket(), kMaxAnswerBytes) {}

    LessonSources sources;
    LessonProcessOptions options;
    std::unique_ptr<ChildProcess> child;
    Channel channel;
    LessonDescription description{};
    std::vector<std::string> prints;
    Bytes out;
    bool waiting = false;
    std::optional<Error> failure;
    double asked_at_s = 0.0;
    double cpu_at_ask_s = 0.0;
    double cpu_limit_s = 0.0;

    /// From now on the process has so much time to answer, as a build without sanitizers counts it.
    void start_clock(double cpu_s) {
        asked_at_s = monotonic_now_s();
        cpu_at_ask_s = child->cpu_s();
        cpu_limit_s = cpu_s;
    }
    [[nodiscard]] bool worked_too_long() const {
        return child->cpu_s() - cpu_at_ask_s > kSlowness * cpu_limit_s;
    }
    [[nodiscard]] bool is_given_up() const {
        return options.waits_on && !options.waits_on(monotonic_now_s() - asked_at_s);
    }

    /// Ends the process and remembers why. Every later call gives the same error.
    Error fail_with(Error error) {
        child->end();
        waiting = false;
        failure = error;
        return error;
    }
    /// The place where the script was last seen, as far as it can be believed.
    [[nodiscard]] std::string last_place() const {
        ScriptError place = child->last_seen();
        place.file = sources.known_name(place.file);
        return to_error(place).where;
    }
    /// Why nobody waits any longer; nothing while somebody does.
    std::optional<Error> look_at_clocks() {
        if (worked_too_long()) {
            return fail_with({"this did not answer within " + milliseconds(cpu_limit_s) +
                                  " (a loop that never ends?)",
                              last_place(),
                              {}});
        }
        if (is_given_up()) {
            const double waited_s = monotonic_now_s() - asked_at_s;
            return fail_with({"the lesson's process was given up after " + milliseconds(waited_s) +
                                  ", in which it hardly ran",
                              last_place(), "see whether the computer is too busy"});
        }
        return std::nullopt;
    }
    Error fail_malformed(const std::string& problem) {
        return fail_with({"the lesson's process sent nonsense and was ended (" + problem + ")",
                          last_place(),
                          {}});
    }
    /// The process has gone by itself.
    Error fail_gone() {
        const ProcessEnd end = child->end();
        if (!end.by_signal && end.code >= kWallExitCode && end.code < kWallExitCode + kWalls) {
            return fail_with(
                {std::string("no lesson can be run safely here: ") +
                     wall_text(static_cast<Wall>(end.code - kWallExitCode)),
                 {},
                 "use Linux 5.9 or later, in a container only one that allows seccomp"});
        }
        std::string what = "the lesson's process ended without an answer";
        if (end.by_signal && end.code == SIGSYS) {
            what = "the lesson's process tried something that is not allowed and was ended";
        } else if (end.by_signal && end.code == SIGKILL) {
            what = "the lesson's process was ended from outside";
        } else if (end.by_signal) {
            what = std::string("the lesson's process crashed (") + strsignal(end.code) + ")";
        }
        return fail_with({what, last_place(), {}});
    }
    Error fail_script(std::span<const std::uint8_t> bytes) {
        auto error = decode_error(bytes);
        if (!error) {
            return fail_malformed(error.error().message);
        }
        if (!error->file.empty()) {
            error->file = sources.known_name(error->file);
        }
        return fail_with(to_error(*error));
    }

    /// Sends what is in `out`, all of it, within the clocks.
    [[nodiscard]] Expected<void> send_all() {
        std::span<const std::uint8_t> rest = out;
        while (!rest.empty()) {
            const auto sent = channel.send(rest);
            if (!sent) {
                return tl::unexpected(fail_gone());
            }
            rest = rest.subspan(*sent);
            if (rest.empty()) {
                break;
            }
            if (auto late = look_at_clocks()) {
                return tl::unexpected(std::move(*late));
            }
            child->wait_writable(kLookEvery_s);
        }
        return {};
    }
    /// The next message, waiting for it within the clocks.
    [[nodiscard]] Expected<RawMessage> receive() {
        RawMessage message;
        for (;;) {
            switch (channel.receive(message)) {
                case Channel::Result::message:
                    return message;
                case Channel::Result::closed:
                    return tl::unexpected(fail_gone());
                case Channel::Result::malformed:
                    return tl::unexpected(fail_malformed("a message of impossible length"));
                case Channel::Result::nothing:
                    break;
            }
            if (auto late = look_at_clocks()) {
                return tl::unexpected(std::move(*late));
            }
            child->wait_readable(kLookEvery_s);
        }
    }

    [[nodiscard]] Expected<void> load();
    [[nodiscard]] Expected<bool> take_load_message(const RawMessage& message);
    [[nodiscard]] Expected<LessonReply> take_reply(const RawMessage& message);
};

// ---- loading ------------------------------------------------------------------------------------------------------

Expected<bool> LessonProcess::Parts::take_load_message(const RawMessage& message) {
    switch (message.kind) {
        case WireKind::module_request: {
            const auto request = decode_module_request(message.body);
            if (!request) {
                return tl::unexpected(fail_malformed(request.error().message));
            }
            out.clear();
            encode(sources.find_module(request->name), out);
            if (auto sent = send_all(); !sent) {
                return tl::unexpected(sent.error());
            }
            return false;
        }
        case WireKind::print: {
            auto print = decode_print(message.body);
            if (!print || prints.size() >= kMaxLoadPrints) {
                return tl::unexpected(
                    fail_malformed(print ? "too many prints" : print.error().message));
            }
            prints.push_back(std::move(print->text));
            return false;
        }
        case WireKind::description: {
            auto decoded = decode_description(message.body);
            if (!decoded) {
                return tl::unexpected(fail_malformed(decoded.error().message));
            }
            description = std::move(*decoded);
            return true;
        }
        case WireKind::error:
            return tl::unexpected(fail_script(message.body));
        default:
            return tl::unexpected(fail_malformed("a message out of turn"));
    }
}

Expected<void> LessonProcess::Parts::load() {
    auto lesson = sources.read_lesson();
    if (!lesson) {
        return tl::unexpected(fail_with(lesson.error()));
    }
    auto hand = sources.read_hand();
    if (!hand) {
        return tl::unexpected(fail_with(hand.error()));
    }
    auto second_hand = sources.read_second_hand();
    if (!second_hand) {
        return tl::unexpected(fail_with(second_hand.error()));
    }
    out.clear();
    encode(LoadMessage{std::move(*lesson), std::move(*hand), options.seed & INT64_MAX,
                       options.memory_bytes, options.load_instructions, options.frame_instructions,
                       std::move(*second_hand)},
           out);
    start_clock(options.load_cpu_s);
    if (auto sent = send_all(); !sent) {
        return sent;
    }
    for (;;) {
        const auto message = receive();
        if (!message) {
            return tl::unexpected(message.error());
        }
        const auto done = take_load_message(*message);
        if (!done) {
            return tl::unexpected(done.error());
        }
        if (*done) {
            return {};
        }
    }
}

Expected<std::unique_ptr<LessonProcess>> LessonProcess::start(const LessonFiles& files,
                                                              const LessonProcessOptions& options) {
    auto child = ChildProcess::start(options.executable, options.memory_bytes);
    if (!child) {
        return tl::unexpected(child.error());
    }
    auto parts = std::make_unique<Parts>(LessonSources(files), options, std::move(*child));
    if (auto loaded = parts->load(); !loaded) {
        return tl::unexpected(loaded.error());
    }
    return std::unique_ptr<LessonProcess>(new LessonProcess(std::move(parts)));
}

LessonProcess::LessonProcess(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
LessonProcess::~LessonProcess() = default;

// ---- frames -------------------------------------------------------------------------------------------------------

Expected<LessonReply> LessonProcess::Parts::take_reply(const RawMessage& message) {
    if (message.kind == WireKind::error) {
        return tl::unexpected(fail_script(message.body));
    }
    if (message.kind != WireKind::reply) {
        return tl::unexpected(fail_malformed("a message out of turn"));
    }
    auto reply = decode_reply(message.body, description);
    if (!reply) {
        return tl::unexpected(fail_malformed(reply.error().message));
    }
    waiting = false;
    return reply;
}

Expected<void> LessonProcess::send(const LessonFrame& frame) {
    Parts& parts = *parts_;
    if (parts.failure) {
        return tl::unexpected(*parts.failure);
    }
    if (parts.waiting) {
        return fail("a frame was sent before the last was answered");
    }
    parts.out.clear();
    encode(frame, parts.out);
    parts.start_clock(parts.options.answer_cpu_s);
    parts.waiting = true;
    return parts.send_all();
}

Expected<LessonReply> LessonProcess::exchange(const LessonFrame& frame) {
    if (auto sent = send(frame); !sent) {
        return tl::unexpected(sent.error());
    }
    parts_->child->wait_readable(kLookEvery_s);
    const auto message = parts_->receive();
    return message ? parts_->take_reply(*message) : tl::unexpected(message.error());
}

std::optional<Expected<LessonReply>> LessonProcess::poll() {
    Parts& parts = *parts_;
    if (parts.failure) {
        return tl::unexpected(*parts.failure);
    }
    if (!parts.waiting) {
        return std::nullopt;
    }
    RawMessage message;
    switch (parts.channel.receive(message)) {
        case Channel::Result::message:
            return parts.take_reply(message);
        case Channel::Result::closed:
            return tl::unexpected(parts.fail_gone());
        case Channel::Result::malformed:
            return tl::unexpected(parts.fail_malformed("a message of impossible length"));
        case Channel::Result::nothing:
            break;
    }
    if (parts.worked_too_long()) {
        return tl::unexpected(*parts.look_at_clocks());
    }
    return std::nullopt;
}

// ---- what is known ------------------------------------------------------------------------------------------------

bool LessonProcess::waits_for_reply() const noexcept {
    return parts_->waiting;
}
double LessonProcess::waited_s() const noexcept {
    return parts_->waiting ? monotonic_now_s() - parts_->asked_at_s : 0.0;
}
const LessonDescription& LessonProcess::description() const noexcept {
    return parts_->description;
}
const std::vector<std::string>& LessonProcess::prints_while_loading() const noexcept {
    return parts_->prints;
}
const std::vector<std::filesystem::path>& LessonProcess::files_read() const noexcept {
    return parts_->sources.files_read();
}
pid_t LessonProcess::pid() const noexcept {
    return parts_->child->pid();
}

}  // namespace fulcrum::runtime
