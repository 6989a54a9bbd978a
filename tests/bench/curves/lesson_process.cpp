#include "runtime/lua/process/lesson_process.h"

#include "haptics/field/linearised_wrench.h"
#include "runtime/lua/host/lesson_host.h"
#include "tests/bench/harness/curve.h"
#include "tests/support/scratch_folder.h"
#include "tests/unit/runtime/lua/hosted_lesson.h"

#include <stdexcept>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace fulcrum::bench {
namespace {

// What a lesson in a process of its own costs: start, and the round trip of a frame, beside two baselines of the same run:
// the same host without a process, and a bare message of the same size to a process and back.

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

// A force that a lesson computes in Lua: how often it is asked, and what is done between its answers.
//
//   held        the newest answer's force, until the next one comes
//   linearised  the program's way: force and slopes of the newest answer, blended in (field/linearised_wrench.h)
//   per step    asked at every haptic step: what the program never does, for Lua may stop for milliseconds

constexpr double kHapticRate_Hz = 1000.0;
constexpr double kStiffness_N_per_m = 200.0;
constexpr double kWidth_m = 0.02;
constexpr double kDamping_Ns_per_m = 2.0;
constexpr int kEvaluations = 13;  // of the function, for a force with its slopes: 1 + 2 x 6

// A well of gaussian form, 2.4 N deep at its steepest, with a little drag.
constexpr const char* kLaw =
    "world:hand {}:force(function(tool)\n"
    "  local square = tool.x * tool.x + tool.y * tool.y + tool.z * tool.z\n"
    "  local k = -200 * math.exp(-square / (2 * 0.02 * 0.02))\n"
    "  return k * tool.x - 2 * tool.vx, k * tool.y - 2 * tool.vy, k * tool.z - 2 * tool.vz\n"
    "end)";

Vector3 compute_true_force(const Vector3& position_W, const Vector3& velocity_W) {
    const double k =
        -kStiffness_N_per_m * std::exp(-position_W.squaredNorm() / (2.0 * kWidth_m * kWidth_m));
    return k * position_W - kDamping_Ns_per_m * velocity_W;
}

// A hand that goes to and fro through the well, 4 cm at about 1 Hz: 0.25 m/s at its fastest.
struct Hand {
    Vector3 position_W;
    Vector3 velocity_W;
};
Hand hand_at(double time_s) {
    constexpr double w = 2.0 * std::numbers::pi;
    const double a = 0.04;
    const double b = 0.015;
    return {{a * std::sin(w * time_s), b * std::sin(1.7 * w * time_s), 0.0},
            {a * w * std::cos(w * time_s), 1.7 * b * w * std::cos(1.7 * w * time_s), 0.0}};
}

// The lesson in this process, asked for its force.
class Lesson {
  public:
    explicit Lesson(const std::string& start) {
        if (const std::string trouble = lesson_.start(start); !trouble.empty()) {
            throw std::runtime_error(trouble);
        }
        frame_ = lesson_.frame();
    }
    void play(double time_s) {
        const Hand hand = hand_at(time_s);
        frame_.time_s = time_s;
        frame_.tool_pose_W.position = hand.position_W;
        frame_.tool_twist_W.linear = hand.velocity_W;
        if (const std::string trouble = lesson_.play(frame_); !trouble.empty()) {
            throw std::runtime_error(trouble);
        }
    }
    [[nodiscard]] LinearisedWrench answer() const {
        return lesson_.commands<runtime::LessonForceCommand>().front().force;
    }

  private:
    runtime::test::HostedLesson lesson_;
    runtime::LessonFrame frame_;
};

struct Rendering {
    double rms_N = 0.0;
    double worst_N = 0.0;
    double jump_N =
        0.0;  // the largest change from one step to the next, beyond the true force's own
};

// Plays the hand and compares what is felt with the law. An answer comes one haptic step after it was asked for.
Rendering render(double rate_Hz, bool linearised, double seconds) {
    Lesson lesson(kLaw);
    LinearisedWrenchStage stage{LinearisedWrenchSettings{}};
    LinearisedWrench newest;
    newest.stamp_s = -1.0;
    LinearisedWrench on_its_way = newest;
    Rendering result;
    double sum = 0.0;
    Vector3 last_error_N = Vector3::Zero();
    const int every = static_cast<int>(std::lround(kHapticRate_Hz / rate_Hz));
    const int n = static_cast<int>(seconds * kHapticRate_Hz);
    const int settled = static_cast<int>(kHapticRate_Hz / 2.0);
    for (int i = 0; i < n; ++i) {
        const double now_s = i / kHapticRate_Hz;
        newest = on_its_way;
        if (i % every == 0) {
            lesson.play(now_s);
            on_its_way = lesson.answer();
            newest = every == 1 ? on_its_way : newest;
        }
        const Hand hand = hand_at(now_s);
        const Vector3 felt_N =
            linearised ? stage.step(newest, hand.position_W, hand.velocity_W, now_s).force
                       : newest.force_W;
        const Vector3 error_N = felt_N - compute_true_force(hand.position_W, hand.velocity_W);
        if (i > settled) {
            sum += error_N.squaredNorm();
            result.worst_N = std::max(result.worst_N, error_N.norm());
            result.jump_N = std::max(result.jump_N, (error_N - last_error_N).norm());
        }
        last_error_N = error_N;
    }
    result.rms_N = std::sqrt(sum / (n - settled - 1));
    return result;
}

// What one haptic step spends on the answers it uses, seen over both processes.
struct Prices {
    Cost haptic_linearised;
    Cost exchange;  // of a frame with the lesson's process, the function left out
    double evaluation_us = 0.0;
    double evaluation_p99_us = 0.0;
};

// A frame there and back, between two processes as in the program.
Cost measure_exchange(const Timing& timing) {
    const ScratchFolder folder;
    folder.write("lesson.lua", "return lesson { id = \"t\", title = \"T\" }\n");
    runtime::LessonFiles files;
    files.folder = folder.path();
    const auto process = must(runtime::LessonProcess::start(files));
    double time_s = 0.0;
    return measure_cost(
        [&] {
            runtime::LessonFrame frame;
            frame.time_s = time_s += 0.001;
            frame.dt_s = 0.001;
            (void)must(process->exchange(frame));
        },
        timing);
}

Prices measure_prices(Run& run) {
    const Timing timing{run.pick(2000, 300), 1, 100};
    double time_s = 1.0;
    Lesson with(kLaw);
    const Cost full = measure_cost([&] { with.play(time_s += 0.001); }, timing);
    Lesson without("world:hand {}");
    const Cost empty = measure_cost([&] { without.play(time_s += 0.001); }, timing);
    LinearisedWrenchStage stage{LinearisedWrenchSettings{}};
    const LinearisedWrench answer = with.answer();
    const Hand hand = hand_at(time_s);
    Prices prices;
    prices.exchange = measure_exchange(timing);
    prices.haptic_linearised = measure_cost(
        [&] { keep(stage.step(answer, hand.position_W, hand.velocity_W, time_s += 1e-6)); },
        {run.pick(2000, 300), 32, 100}, sizeof(LinearisedWrenchStage));
    prices.evaluation_us = std::max(full.median_us - empty.median_us, 0.0) / kEvaluations;
    prices.evaluation_p99_us = std::max(full.p99_us - empty.median_us, 0.0) / kEvaluations;
    return prices;
}

CostPoint make_point(const std::string& series, double rate_Hz, const Rendering& rendering,
                     const Prices& prices) {
    const double share = rate_Hz / kHapticRate_Hz;
    const bool linearised = series == "linearised";
    const double evaluations = linearised ? kEvaluations : 1.0;
    // What asks at every step would have to do so in the loop's own process.
    const Cost exchange = series == "per step" ? Cost{0.0, 0.0} : prices.exchange;
    const Cost stage = linearised ? prices.haptic_linearised : Cost{0.0, 0.0, sizeof(Wrench)};
    return {series,
            rate_Hz,
            rendering.rms_N,
            {share * (exchange.median_us + evaluations * prices.evaluation_us) + stage.median_us,
             share * (exchange.p99_us + evaluations * prices.evaluation_p99_us) + stage.p99_us,
             stage.bytes},
            {rendering.worst_N, rendering.jump_N}};
}

Report run_lua_force(Run& run) {
    CostCurve curve;
    curve.name = "lua-force";
    curve.title = "A force computed in Lua";
    curve.work =
        "A hand moves through a gaussian well of 200 N/m and 2 cm with 2 Ns/m of drag, 4 cm to and "
        "fro at 1 Hz, felt at 1 kHz; the function is asked at the given rate and its answer "
        "arrives a step later (per step: in the same step). Time is that of both processes, spread "
        "over the haptic steps: a frame's way to the lesson's process and back (not for per step, "
        "which runs Lua inside the haptic loop) and its evaluations, each a 13th of what a frame "
        "with the function takes longer than one without.";
    curve.reference = "analytic: the well's own force at each haptic step";
    curve.knob = {"rate of the Lua function", "Hz", true};
    curve.error = {"force error, rms", "N", true};
    curve.extras = {{"largest error", "N", true}, {"largest jump in a step", "N", true}};
    curve.default_series = "linearised";
    curve.default_knob = 62.5;
    curve.advice =
        "A lesson's frames come 60 times a second anyway: there the linearised answer is four "
        "times as exact as the held one and jumps a hundredth as much from step to step. Asking in "
        "every step is exact and cheap in the mean, but puts Lua's pauses into the loop that must "
        "never wait, so the program does not offer it.";
    const double seconds = run.pick(10.0, 2.0);
    const Prices prices = measure_prices(run);
    const std::vector<double> rates_Hz{15.625, 31.25, 62.5, 125.0, 250.0, 500.0};
    for (const char* series : {"held", "linearised"}) {
        for (const double rate_Hz : rates_Hz) {
            run.progress(static_cast<double>(curve.points.size()) / 13.0, series);
            curve.points.push_back(
                make_point(series, rate_Hz,
                           render(rate_Hz, series == std::string("linearised"), seconds), prices));
        }
    }
    curve.points.push_back(
        make_point("per step", kHapticRate_Hz, render(kHapticRate_Hz, false, seconds), prices));
    return {curve};
}

const Registration kLuaForce{
    {"lua-force", "rate of a Lua force function: held, linearised, per step", run_lua_force}};

}  // namespace
}  // namespace fulcrum::bench
