#include "runtime/files/shape_cache.h"

#include "haptics/geometry/shape.h"
#include "tests/support/scratch_folder.h"

#include <catch2/catch.hpp>

#include <chrono>
#include <csignal>
#include <fstream>
#include <string>
#include <sys/stat.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace fulcrum::runtime {
namespace {

namespace fs = std::filesystem;

ShapeCacheSettings keep_all(const fs::path& folder) {
    return {.folder = folder, .least_build_s = 0.0};
}

TriangleMesh ball() {
    return make_sphere(1.0, 3).value();
}

Pointshell shell_of(int n) {
    return make_surface_pointshell(ball(), n).value();
}

Digest key_of(double number) {
    return compute_shape_key(ShapeKind::pointshell, ball(), std::vector<double>{number});
}

// The only shape in the folder.
fs::path find_only(const fs::path& folder) {
    std::vector<fs::path> all;
    for (const auto& entry : fs::directory_iterator(folder)) {
        all.push_back(entry.path());
    }
    REQUIRE(all.size() == 1);
    REQUIRE(all.front().extension() == ".shape");
    return all.front();
}

// How often the shell was made.
struct Maker {
    int n_made = 0;
    Expected<Pointshell> make(ShapeCache& cache, const Digest& key) {
        return recall(cache, key, decode_pointshell, [this] {
            ++n_made;
            return Expected<Pointshell>(shell_of(200));
        });
    }
};

TEST_CASE("shape cache: what was made once is read the next time, by another program too") {
    const ScratchFolder scratch;
    Maker maker;
    for (int i = 0; i < 3; ++i) {
        ShapeCache cache(keep_all(scratch.path() / "new" / "folder"));
        const auto shell = maker.make(cache, key_of(1));
        REQUIRE(shell);
        CHECK(shell->x_m == shell_of(200).x_m);
        CHECK(cache.told().empty());
    }
    CHECK(maker.n_made == 1);
    struct stat about {};
    REQUIRE(::stat(find_only(scratch.path() / "new" / "folder").c_str(), &about) == 0);
    CHECK((about.st_mode & 0777U) == 0600);
}

TEST_CASE("shape cache: fields, voxels and pointshells by mesh and settings") {
    const ScratchFolder scratch;
    ShapeCache cache(keep_all(scratch.path()));
    const VoxelFrame frame = DistanceField::make_frame(ball(), 24).value();
    for (int i = 0; i < 2; ++i) {
        REQUIRE(recall_distance_field(cache, ball(), frame, {}));
        REQUIRE(recall_distance_field(cache, ball(), frame, {.band_voxels = 2.5}));
        REQUIRE(recall_voxels(cache, ball(), {.voxel_m = 0.1}));
        REQUIRE(recall_voxels(cache, ball(), {.voxel_m = 0.1, .offset_layers = 1}));
        REQUIRE(recall_surface_pointshell(cache, ball(), 100));
        CHECK(std::distance(fs::directory_iterator(scratch.path()), {}) == 5);
    }
    CHECK(recall_voxels(cache, ball(), {.voxel_m = 0.1})->cells ==
          voxelise(ball(), {.voxel_m = 0.1})->cells);
    // What cannot be made is refused as ever, and not kept.
    CHECK_FALSE(recall_voxels(cache, ball(), {.voxel_m = -1.0}));
    CHECK(std::distance(fs::directory_iterator(scratch.path()), {}) == 5);
    CHECK(cache.told().empty());
}

TEST_CASE("shape cache: a file that is cut off, changed or empty is told, and made again") {
    const ScratchFolder scratch;
    Maker maker;
    ShapeCache first(keep_all(scratch.path()));
    REQUIRE(maker.make(first, key_of(1)));
    const fs::path path = find_only(scratch.path());
    const auto size = fs::file_size(path);
    const auto damage = [&](int how) {
        if (how < 2) {
            fs::resize_file(path, how == 0 ? size / 2 : 0);
        } else {
            std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
            file.seekp(static_cast<std::streamoff>(how == 2 ? 70 : size - 5));
            file.put('\x55');
        }
    };
    for (int how = 0; how < 4; ++how) {
        damage(how);
        ShapeCache cache(keep_all(scratch.path()));
        REQUIRE(maker.make(cache, key_of(1))->x_m == shell_of(200).x_m);
        CHECK(maker.n_made == how + 2);
        REQUIRE(cache.told().size() == 1);
        CHECK(cache.told().front().find(path.string() + ": the kept shape ") == 0);
        // And the next one reads it again.
        REQUIRE(maker.make(cache, key_of(1)));
        CHECK(maker.n_made == how + 2);
    }
}

TEST_CASE("shape cache: a link, a folder, a pipe and a file too large are not read") {
    const ScratchFolder scratch;
    Maker maker;
    ShapeCacheSettings settings = keep_all(scratch.path());
    ShapeCache first(settings);
    REQUIRE(maker.make(first, key_of(1)));
    const fs::path path = find_only(scratch.path());
    const fs::path elsewhere = scratch.path() / "elsewhere";
    fs::rename(path, elsewhere);
    const auto is_told = [&](const ShapeCacheSettings& with) {
        ShapeCache cache(with);
        const int before = maker.n_made;
        return maker.make(cache, key_of(1)).has_value() && maker.n_made == before + 1 &&
               !cache.told().empty();
    };
    fs::create_symlink(elsewhere, path);
    CHECK(is_told(settings));
    fs::remove(path);
    fs::create_directory(path);
    CHECK(is_told(settings));
    fs::remove(path);
    REQUIRE(::mkfifo(path.c_str(), 0600) == 0);
    CHECK(is_told(settings));
    fs::remove(path);
    fs::rename(elsewhere, path);
    settings.most_file_bytes = 100;
    CHECK(is_told(settings));
}

TEST_CASE("shape cache: no folder, and one that cannot be made, cost nothing but time") {
    Maker maker;
    ShapeCache none({});
    REQUIRE(maker.make(none, key_of(1)));
    CHECK(none.told().empty());
    const ScratchFolder scratch;
    scratch.write("file", "");
    ShapeCache blocked(keep_all(scratch.path() / "file" / "below"));
    REQUIRE(maker.make(blocked, key_of(1)));
    CHECK(blocked.told().size() >= 1);
    // What is made fast is not worth a file.
    ShapeCache slow_only({.folder = scratch.path() / "shapes", .least_build_s = 3600.0});
    REQUIRE(maker.make(slow_only, key_of(1)));
    CHECK_FALSE(fs::exists(scratch.path() / "shapes"));
    CHECK(maker.n_made == 3);
}

TEST_CASE("shape cache: above its size the shapes unused for longest go; unfinished files too") {
    const ScratchFolder scratch;
    const std::uint64_t one = encode(shell_of(200), key_of(0)).size();
    ShapeCacheSettings settings = keep_all(scratch.path());
    settings.most_bytes = 3 * one + one / 2;
    Maker maker;
    ShapeCache cache(settings);
    const auto now = fs::file_time_type::clock::now();
    const auto path_of = [&](double i) { return scratch.path() / (to_hex(key_of(i)) + ".shape"); };
    for (int i = 0; i < 3; ++i) {
        REQUIRE(maker.make(cache, key_of(i)));
        fs::last_write_time(path_of(i), now - std::chrono::hours(10 - i));
    }
    // Number 0 is used again, so number 1 is the oldest when the fourth comes.
    REQUIRE(maker.make(cache, key_of(0)));
    scratch.write("old.1.0.tmp", "unfinished");
    scratch.write("new.1.0.tmp", "being written");
    scratch.write("notes.txt", "somebody's");
    fs::last_write_time(scratch.path() / "old.1.0.tmp", now - std::chrono::hours(2));
    REQUIRE(maker.make(cache, key_of(3)));
    CHECK(maker.n_made == 4);
    CHECK(fs::exists(path_of(0)));
    CHECK_FALSE(fs::exists(path_of(1)));
    CHECK(fs::exists(path_of(2)));
    CHECK(fs::exists(path_of(3)));
    CHECK_FALSE(fs::exists(scratch.path() / "old.1.0.tmp"));
    CHECK(fs::exists(scratch.path() / "new.1.0.tmp"));
    CHECK(fs::exists(scratch.path() / "notes.txt"));
    // What is larger than all that may be kept drives nothing out.
    settings.most_bytes = one / 2;
    ShapeCache narrow(settings);
    REQUIRE(maker.make(narrow, key_of(9)));
    CHECK(narrow.told().size() == 1);
    CHECK(fs::exists(path_of(3)));
}

// Runs `work` in a program of its own, which has its parent's memory but shares nothing.
template <class Work>
pid_t start(const Work& work) {
    const pid_t child = ::fork();
    if (child == 0) {
        ::_exit(work() ? 0 : 1);
    }
    REQUIRE(child > 0);
    return child;
}

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

TEST_CASE("shape cache: a writer killed at any time leaves whole shapes or none") {
    const ScratchFolder scratch;
    const Bytes bytes = encode(shell_of(20000), key_of(1));
    int n_unfinished = 0;
    for (int trial = 0; trial < 24; ++trial) {
        const pid_t writer = start([&] {
            ShapeCache cache(keep_all(scratch.path()));
            for (;;) {
                cache.write(key_of(1), bytes);
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

TEST_CASE(
    "shape cache: programs at once read, write and drive out each other's, and get what they asked "
    "for") {
    const ScratchFolder scratch;
    const std::uint64_t one = encode(shell_of(200), key_of(0)).size();
    std::vector<pid_t> programs;
    for (int program = 0; program < 4; ++program) {
        programs.push_back(start([&] {
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
        int status = -1;
        REQUIRE(::waitpid(program, &status, 0) == program);
        CHECK(status == 0);
    }
}

TEST_CASE("shape cache: it lies in the user's cache folder") {
    const auto folder = default_shape_cache_folder();
    REQUIRE(folder);
    CHECK(folder->is_absolute());
    CHECK(folder->filename() == "shapes");
    CHECK(folder->parent_path().filename() == "fulcrum");
}

}  // namespace
}  // namespace fulcrum::runtime
