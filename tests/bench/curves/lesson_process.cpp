// What a lesson in a process of its own costs: start, and the round trip of a frame, beside two baselines of the same run:
// the same host without a process, and a bare message of the same size to a process and back.
#include "runtime/lua/process/lesson_process.h"

#include "runtime/lua/host/lesson_host.h"
#include "tests/bench/harness/curve.h"
#include "tests/support/scratch_folder.h"

#include <stdexcept>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace fulcrum::bench {
namespace {

using namespace fulcrum::runtime;

constexpr int kBodies = 8;

constexpr const char* kLesson = R"(
local L = lesson { id = "bench", title = "Bench" }
local bodies = {}
function L:start(world)
  for i = 1, 8 do bodies[i] = world:body { name = "b" .. i, movable = true, at = { i / 10, 1, 0 } } end
end
function L:update(world, dt)
  local highest = 0
  for _, body in ipairs(bodies) do
    if body.where == "falling" and body.y > highest then highest = body.y end
  end
  world:score(math.floor(highest * 10))
end
return L
)";

LessonFrame make_frame(double time_s) {
    LessonFrame frame;
    frame.time_s = time_s;
    frame.dt_s = 1.0 / 60.0;
    frame.bodies.resize(kBodies);
    for (BodyState& body : frame.bodies) {
        body.where = BodyWhere::falling;
        body.pose_W.position.y() = 0.5;
    }
    return frame;
}

void add_row(Sheet& sheet, const char* what, const Cost& cost) {
    sheet.add({what, cost.median_us, cost.p99_us});
}

[[noreturn]] void give_up(const std::string& why) {
    throw std::runtime_error(why);
}

// A process that sends back what it gets: the least a round trip can cost.
Cost measure_bare(std::size_t bytes, const Timing& timing) {
    std::array<int, 2> ends{};
    if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()) != 0) {
        give_up("no socket pair can be made");
    }
    constexpr std::size_t kAnswerBytes = 64;
    std::vector<char> buffer(bytes);
    const pid_t pid = fork();
    if (pid == 0) {
        close(ends[0]);
        while (read(ends[1], buffer.data(), bytes) > 0 &&
               write(ends[1], buffer.data(), kAnswerBytes) > 0) {
        }
        _exit(0);
    }
    close(ends[1]);
    const Cost cost = measure_cost(
        [&] {
            if (write(ends[0], buffer.data(), bytes) < 0 ||
                read(ends[0], buffer.data(), bytes) < 0) {
                give_up("the bare process has gone");
            }
        },
        timing);
    close(ends[0]);
    waitpid(pid, nullptr, 0);
    return cost;
}

void measure_process(Sheet& sheet, const LessonFiles& files, const Timing& timing) {
    add_row(sheet, "start of a lesson",
            measure_cost([&] { keep(LessonProcess::start(files)); }, {timing.samples / 50, 1, 1}));
    const auto process = must(LessonProcess::start(files));
    const auto there_and_back = [&, time_s = 0.0]() mutable {
        (void)must(process->exchange(make_frame(time_s += 1.0 / 60.0)));
    };
    add_row(sheet, "frame of 8 bodies, there and back", measure_cost(there_and_back, timing));
}

void measure_host(Sheet& sheet, const Timing& timing) {
    LoadMessage message;
    message.lesson = {"lesson.lua", kLesson};
    LessonHost host(message, {});
    LessonReply reply;
    if (host.load()) {
        give_up("the lesson does not load");
    }
    const auto frame = [&, time_s = 0.0]() mutable {
        if (host.run_frame(make_frame(time_s += 1.0 / 60.0), reply)) {
            give_up("the lesson failed");
        }
    };
    add_row(sheet, "the same without a process", measure_cost(frame, timing));
}

Report run_lesson_process(Run& run) {
    Sheet sheet{
        "lesson-process",
        "A lesson in a process of its own",
        "A lesson of eight falling bodies is started, then asked for frame after frame; each start "
        "and each frame is timed.",
        "Sixty frames a second cost well under a hundredth of a processor: there is nothing to "
        "gain by letting a lesson's text into the program's own process.",
        {"what", "median us", "99 % us"}};
    const Timing timing{run.pick(20000, 1000), 1, 200};
    const ScratchFolder folder;
    folder.write("lesson.lua", kLesson);
    LessonFiles files;
    files.folder = folder.path();
    measure_process(sheet, files, timing);
    run.progress(0.6);
    measure_host(sheet, timing);
    Bytes bytes;
    encode(make_frame(0.0), bytes);
    add_row(sheet, "a bare message of that size, there and back",
            measure_bare(bytes.size(), timing));
    return {sheet};
}

const Registration kLessonProcess{
    {"lesson-process", "start and frames of a lesson's process", run_lesson_process}};

}  // namespace
}  // namespace fulcrum::bench
