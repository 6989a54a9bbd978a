// What a lesson in a process of its own costs: start, and the round trip of a frame, beside two baselines of the same run: the same
// host without a process, and a bare message of the same size to a process and back. Prints CSV.
#include "haptics/base/clock.h"
#include "runtime/lua/lesson_host.h"
#include "runtime/lua/lesson_process.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace {

using namespace fulcrum;
using namespace fulcrum::runtime;

constexpr int kWarmUp = 500;
constexpr int kRounds = 20000;
constexpr int kStarts = 40;
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

void print_row(const char* what, std::vector<double>& times_s) {
    std::sort(times_s.begin(), times_s.end());
    const auto at = [&](double share) {
        return 1e6 *
               times_s[static_cast<std::size_t>(share * static_cast<double>(times_s.size() - 1))];
    };
    std::printf("%s,%zu,%.1f,%.1f,%.1f\n", what, times_s.size(), at(0.5), at(0.99), at(1.0));
}

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

template <class Step>
void measure(const char* what, Step step) {
    std::vector<double> times_s;
    for (int i = 0; i < kWarmUp + kRounds; ++i) {
        const double begun_s = monotonic_now_s();
        step(i / 60.0);
        if (i >= kWarmUp) {
            times_s.push_back(monotonic_now_s() - begun_s);
        }
    }
    print_row(what, times_s);
}

/// A process that sends back what it gets: the least a round trip can cost.
void measure_bare(std::size_t bytes) {
    std::array<int, 2> ends{};
    if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()) != 0) {
        return;
    }
    const pid_t pid = fork();
    std::vector<char> buffer(bytes);
    if (pid == 0) {
        close(ends[0]);
        ssize_t n = 0;
        while ((n = read(ends[1], buffer.data(), bytes)) > 0) {
            if (write(ends[1], buffer.data(), 64) < 0) {
                break;
            }
        }
        _exit(0);
    }
    close(ends[1]);
    measure("bare round trip", [&](double) {
        if (write(ends[0], buffer.data(), bytes) < 0 || read(ends[0], buffer.data(), bytes) < 0) {
            std::exit(1);
        }
    });
    close(ends[0]);
    waitpid(pid, nullptr, 0);
}

void measure_starts(const LessonFiles& files) {
    std::vector<double> times_s;
    for (int i = 0; i < kStarts; ++i) {
        const double begun_s = monotonic_now_s();
        const auto process = LessonProcess::start(files);
        times_s.push_back(monotonic_now_s() - begun_s);
    }
    print_row("start", times_s);
}

}  // namespace

int main(int argc, char** argv) {
    if (const auto socket = lesson_process_socket(argc, argv)) {
        return lesson_process_main(*socket);
    }
    std::string pattern =
        (std::filesystem::temp_directory_path() / "fulcrum-bench-XXXXXX").string();
    LessonFiles files;
    files.folder = mkdtemp(pattern.data());
    std::ofstream(files.folder / "lesson.lua") << kLesson;
    std::puts("what,n,median_us,p99_us,max_us");
    measure_starts(files);
    auto process = LessonProcess::start(files);
    if (!process) {
        std::fprintf(stderr, "%s\n", to_sentence(process.error()).c_str());
        return 1;
    }
    measure("exchange of 8 bodies", [&](double time_s) {
        if (!(*process)->exchange(make_frame(time_s))) {
            std::exit(1);
        }
    });
    LoadMessage message;
    message.lesson = {"lesson.lua", kLesson};
    LessonHost host(message, {});
    LessonReply reply;
    if (host.load()) {
        return 1;
    }
    measure("the same without a process", [&](double time_s) {
        if (host.run_frame(make_frame(time_s), reply)) {
            std::exit(1);
        }
    });
    Bytes bytes;
    encode(make_frame(0.0), bytes);
    measure_bare(bytes.size());
    std::filesystem::remove_all(files.folder);
    return 0;
}
