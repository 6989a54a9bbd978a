#include "haptics/geometry/shape.h"
#include "haptics/levels/level_bytes.h"
#include "haptics/voxel/shape_bytes.h"
#include "haptics/voxel/voxelise.h"
#include "runtime/files/shape_cache.h"
#include "tests/support/scratch_folder.h"
#include "tests/unit/runtime/files/own_program.h"
#include "tests/unit/runtime/files/shape_cache_fixture.h"
#include "tests/unit/runtime/rig.h"

#include <chrono>
#include <csignal>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

using namespace fulcrum::runtime::test;

namespace {

// Whether a file with that ending comes to be there within ten seconds.
bool wait_for(const fs::path& folder, const char* ending) {
    const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    while (std::chrono::steady_clock::now() < until) {
        std::error_code error;
        for (fs::directory_iterator at(folder, error), end; !error && at != end;
             at.increment(error)) {
            if (at->path().extension() == ending) {
                return true;
            }
        }
        std::this_thread::sleep_for(std::chrono::microseconds(50));
    }
    return false;
}

}  // namespace

// On a disk that holds five shapes of twelve pages: what a program there finds, where a disk can be made.
TEST_CASE("shape cache: on a full disk the longest unused shapes go; then nothing more is kept") {
    const ScratchFolder scratch;
    const Bytes bytes = encode(shell_of(2000), key_of(0));
    const auto path_of = [&](double i) { return scratch.path() / (to_hex(key_of(i)) + ".shape"); };
    const auto is_alone = [&](std::initializer_list<int> kept) {
        return std::all_of(kept.begin(), kept.end(),
                           [&](int i) { return fs::exists(path_of(i)); }) &&
               std::distance(fs::directory_iterator(scratch.path()), {}) ==
                   static_cast<std::ptrdiff_t>(kept.size());
    };
    constexpr int kNoDisk = 77;
    const pid_t program = ::fork();
    if (program == 0) {
        if (!put_small_disk(scratch.path(), 256)) {
            ::_exit(kNoDisk);
        }
        ShapeCache cache(keep_all(scratch.path()));
        const auto now = fs::file_time_type::clock::now();
        for (int i = 0; i < 5; ++i) {
            keep(cache, key_of(i), bytes);
            fs::last_write_time(path_of(i), now - std::chrono::minutes(10 - i));
        }
        bool is_fine = is_alone({0, 1, 2, 3, 4}) && cache.told().empty();
        // The sixth drives the first out.
        keep(cache, key_of(5), bytes);
        is_fine = is_fine && is_alone({1, 2, 3, 4, 5}) && cache.told().empty() &&
                  cache.counts().n_kept == 6;
        // More than there is even when all are gone: it is told, once, and that is the end of it.
        keep(cache, key_of(6), Bytes(300000));
        keep(cache, key_of(7), bytes);
        is_fine = is_fine && is_alone({}) && cache.told().size() == 1 &&
                  cache.told().front().find(": this shape can't be kept: No space left") !=
                      std::string::npos &&
                  cache.counts().n_kept == 6;
        ::_exit(is_fine ? 0 : 1);
    }
    int status = -1;
    REQUIRE(::waitpid(program, &status, 0) == program);
    REQUIRE(WIFEXITED(status));
    if (WEXITSTATUS(status) == kNoDisk) {
        WARN("skipped: no small disk can be made here");
        return;
    }
    CHECK(WEXITSTATUS(status) == 0);
}

TEST_CASE("shape cache: where files may not become long, what is shorter is still kept") {
    const ScratchFolder scratch;
    CHECK(wait_for_program(start_program([&] {
        const rlimit limit{10000, 10000};
        ShapeCache cache(keep_all(scratch.path()));
        if (::signal(SIGXFSZ, SIG_IGN) == SIG_ERR || ::setrlimit(RLIMIT_FSIZE, &limit) != 0) {
            return false;
        }
        Maker maker;
        const auto large = recall_surface_pointshell(cache, ball(), 1000);
        const bool is_told = large && large->size() == 1000 && cache.told().size() == 1;
        return is_told && maker.make(cache, key_of(1)) && maker.make(cache, key_of(1)) &&
               maker.n_made == 1 && cache.counts().n_kept == 1 && cache.told().size() == 1;
    })));
    CHECK(std::distance(fs::directory_iterator(scratch.path()), {}) == 1);
}

TEST_CASE("shape cache: a writer killed at any time leaves whole shapes or none") {
    const ScratchFolder scratch;
    const Bytes bytes = encode(shell_of(20000), key_of(1));
    int n_unfinished = 0;
    for (int trial = 0; trial < 24; ++trial) {
        const pid_t writer = start_program([&] {
            ShapeCache cache(keep_all(scratch.path()));
            for (;;) {
                keep(cache, key_of(1), bytes);
            }
            return true;
        });
        // In the middle of a file, or some time after the first was whole.
        const bool was_there = wait_for(scratch.path(), trial % 2 == 0 ? ".tmp" : ".shape");
        std::this_thread::sleep_for(std::chrono::microseconds(40 * trial));
        ::kill(writer, SIGKILL);
        ::waitpid(writer, nullptr, 0);
        REQUIRE(was_there);
        ShapeCache cache(keep_all(scratch.path()));
        if (const auto kept = cache.read(key_of(1))) {
            REQUIRE(*kept == bytes);
        }
        REQUIRE(cache.told().empty());
        for (const auto& entry : fs::directory_iterator(scratch.path())) {
            if (entry.path().extension() == ".tmp") {
                ++n_unfinished;
                fs::remove(entry.path());
            }
        }
    }
    ShapeCache cache(keep_all(scratch.path()));
    CHECK(cache.read(key_of(1)));
    // Some were killed in the middle of a file, or nothing was tried.
    CHECK(n_unfinished > 0);
}

TEST_CASE("shape cache: programs at once drive out each other's, and get what they asked for") {
    const ScratchFolder scratch;
    const std::uint64_t one = encode(shell_of(200), key_of(0)).size();
    std::vector<pid_t> programs;
    for (int program = 0; program < 4; ++program) {
        programs.push_back(start_program([&] {
            ShapeCacheSettings settings = keep_all(scratch.path());
            settings.most_bytes = 3 * one;
            Maker maker;
            for (int i = 0; i < 100; ++i) {
                ShapeCache cache(settings);
                const auto shell = maker.make(cache, key_of((7 * i + program) % 5));
                if (!shell || shell->x_m.size() != 200 || !cache.told().empty()) {
                    return false;
                }
            }
            return true;
        }));
    }
    for (const pid_t program : programs) {
        CHECK(wait_for_program(program));
    }
}

// With FULCRUM_WRITE_SEEDS set they are written anew first, for a new layout.
TEST_CASE("shape bytes: the fuzzer begins with shapes of today's layout") {
    const TriangleMesh box = make_box(Vector3::Ones()).value();
    const Digest key{};
    const std::vector<std::pair<std::string, Bytes>> seeds{
        {"field", encode(DistanceField::build(box, make_field_frame(box, 16, 2.0).value(),
                                              {.band_voxels = 2.0})
                             .value(),
                         key)},
        {"voxels", encode(voxelise(box, {.voxel_m = 0.4}).value(), key)},
        {"pointshell", encode(make_surface_pointshell(box, 5).value(), key)},
        {"levels",
         encode(*ContactLevels::create(make_sphere(1.0, 1).value(), {.within_m = 0.1}).value(),
                key)},
        {"solid", encode(MeasuredSolid{compute_solid_moments(box), true}, key)}};
    for (const auto& [name, bytes] : seeds) {
        const std::string path = FULCRUM_SOURCE_DIR "/tests/fuzz/corpus/shape/" + name;
        if (std::getenv("FULCRUM_WRITE_SEEDS") != nullptr) {
            std::ofstream(path, std::ios::binary)
                .write(reinterpret_cast<const char*>(bytes.data()),
                       static_cast<std::streamsize>(bytes.size()));
        }
        std::ifstream file(path, std::ios::binary);
        const std::string kept{std::istreambuf_iterator<char>(file), {}};
        INFO(name << " is of another layout; run this test once with FULCRUM_WRITE_SEEDS=1");
        CHECK(std::ranges::equal(std::as_bytes(std::span(kept)), bytes));
    }
}
