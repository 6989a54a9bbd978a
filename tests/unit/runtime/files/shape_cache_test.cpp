#include "runtime/files/shape_cache.h"

#include "tests/support/scratch_folder.h"
#include "tests/unit/runtime/files/shape_cache_fixture.h"
#include "tests/unit/runtime/rig.h"

#include <chrono>
#include <sys/stat.h>

using namespace fulcrum::runtime::test;

TEST_CASE("shape cache: what was made once is read the next time, by another program too") {
    const ScratchFolder scratch;
    Maker maker;
    for (int i = 0; i < 3; ++i) {
        ShapeCache cache(keep_all(scratch.path() / "new" / "folder"));
        const auto shell = maker.make(cache, key_of(1));
        REQUIRE(shell);
        CHECK(shell->x_m == shell_of(200).x_m);
        CHECK(cache.told().empty());
        CHECK(cache.counts().n_made == (i == 0 ? 1 : 0));
        CHECK(cache.counts().n_kept == (i == 0 ? 1 : 0));
        CHECK(cache.counts().n_read == (i == 0 ? 0 : 1));
        CHECK(cache.counts().n_refused == 0);
    }
    CHECK(maker.n_made == 1);
    struct stat about {};
    REQUIRE(::stat(find_only(scratch.path() / "new" / "folder").c_str(), &about) == 0);
    CHECK((about.st_mode & 0777U) == 0600);
}

TEST_CASE("shape cache: fields, voxels and pointshells by mesh and settings") {
    const ScratchFolder scratch;
    ShapeCache cache(keep_all(scratch.path()));
    const VoxelFrame frame = make_field_frame(ball(), 24).value();
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

TEST_CASE("shape cache: a shape is read again for the same mesh and settings, and for no others") {
    const ScratchFolder scratch;
    const VoxelFrame frame = make_field_frame(ball(), 24, 5.0).value();
    const auto with = [&](auto change) {
        VoxelFrame changed = frame;
        change(changed);
        return changed;
    };
    ShapeCache cache(keep_all(scratch.path()));
    const auto field = [&](const VoxelFrame& of, const DistanceFieldSettings& settings) {
        return recall_distance_field(cache, ball(), of, settings).has_value();
    };
    const double eighth_m = 0.125 * frame.voxel_m;
    const std::vector<std::function<bool()>> all{
        [&] { return field(frame, {}); },
        [&] { return field(with([&](auto& f) { f.lower_O.x() -= eighth_m; }), {}); },
        [&] { return field(with([&](auto& f) { f.lower_O.y() -= eighth_m; }), {}); },
        [&] { return field(with([&](auto& f) { f.lower_O.z() -= eighth_m; }), {}); },
        [&] { return field(with([&](auto& f) { f.voxel_m *= 1.001; }), {}); },
        [&] { return field(with([](auto& f) { f.n_cells[0] += 8; }), {}); },
        [&] { return field(with([](auto& f) { f.n_cells[1] += 8; }), {}); },
        [&] { return field(with([](auto& f) { f.n_cells[2] += 8; }), {}); },
        [&] { return field(frame, {.band_voxels = 2.5}); },
        [&] { return field(frame, {.sheet_voxels = 1.0}); },
        [&] { return recall_voxels(cache, ball(), {.voxel_m = 0.1}).has_value(); },
        [&] { return recall_voxels(cache, ball(), {.voxel_m = 0.11}).has_value(); },
        [&] {
            return recall_voxels(cache, ball(), {.voxel_m = 0.1, .offset_layers = 1}).has_value();
        },
        [&] {
            return recall_voxels(cache, ball(), {.voxel_m = 0.1, .proximity_layers = 2})
                .has_value();
        },
        [&] { return recall_surface_pointshell(cache, ball(), 100).has_value(); },
        [&] { return recall_surface_pointshell(cache, ball(), 101).has_value(); },
        [&] { return recall_measured_solid(cache, ball()).has_value(); },
        [&] { return recall_measured_solid(cache, make_sphere(1.0, 4).value()).has_value(); }};
    for (int round = 1; round <= 2; ++round) {
        for (std::size_t i = 0; i < all.size(); ++i) {
            INFO("the shape with number " << i);
            CHECK(all[i]());
        }
        CHECK(cache.counts().n_made == static_cast<int>(all.size()));
        CHECK(cache.counts().n_read == static_cast<int>(all.size()) * (round - 1));
    }
    // As many threads as there are make the same shape.
    CHECK(field(frame, {.n_threads = 1}));
    CHECK(cache.counts().n_made == static_cast<int>(all.size()));
    CHECK(cache.told().empty());
}

TEST_CASE("shape cache: an open body's field is made once, and read at the next start") {
    const ScratchFolder scratch;
    std::vector<TriangleCorners> triangles = ball().triangles();
    triangles.erase(triangles.begin(), triangles.begin() + 7);
    const TriangleMesh open = TriangleMesh::build(ball().vertices_B(), triangles).value();
    const VoxelFrame frame = make_field_frame(open, 48).value();
    for (int start = 0; start < 2; ++start) {
        ShapeCache cache(keep_all(scratch.path()));
        const auto field = recall_distance_field(cache, open, frame, {});
        REQUIRE(field);
        CHECK(field->counts().n_open_edges > 0);
        CHECK(cache.counts().n_made == 1 - start);
        CHECK(cache.counts().n_refused == 0);
        CHECK(cache.told().empty());
        const auto solid = recall_measured_solid(cache, open);
        REQUIRE(solid);
        CHECK(solid->by_samples);
        CHECK(solid->moments.second_m5 == measure_solid(open)->moments.second_m5);
        CHECK(cache.counts().n_made == 2 - 2 * start);
    }
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
        CHECK(cache.counts().n_refused == 1);
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

TEST_CASE("shape cache: a folder that is a link, or that others may write to, is not used") {
    const ScratchFolder scratch;
    Maker maker;
    const fs::path own = scratch.path() / "own";
    ShapeCache first(keep_all(own));
    REQUIRE(maker.make(first, key_of(1)));
    fs::create_directory_symlink(own, scratch.path() / "link");
    ShapeCache linked(keep_all(scratch.path() / "link"));
    REQUIRE(maker.make(linked, key_of(1)));
    REQUIRE(maker.make(linked, key_of(2)));
    CHECK(maker.n_made == 3);
    // Once, whatever is asked for after that.
    CHECK(linked.told() ==
          std::vector<std::string>{(scratch.path() / "link").string() +
                                   ": this is a link, where a folder should be; what took long to "
                                   "make is made again each time."});
    fs::permissions(own, fs::perms::others_write, fs::perm_options::add);
    ShapeCache open(keep_all(own));
    REQUIRE(maker.make(open, key_of(1)));
    CHECK(maker.n_made == 4);
    CHECK(open.told().size() == 1);
    CHECK(std::distance(fs::directory_iterator(own), {}) == 1);
}

TEST_CASE("shape cache: a whole shape that is not the one asked for is told, and made again") {
    const ScratchFolder scratch;
    // With room for a thicker band.
    const VoxelFrame frame = make_field_frame(ball(), 24, 4.0).value();
    const DistanceField field = DistanceField::build(ball(), frame).value();
    VoxelFrame moved = frame;
    moved.lower_O.x() -= 0.01 * frame.voxel_m;
    VoxelFrame finer = frame;
    finer.voxel_m *= 0.999;
    const DistanceFieldSettings sheet{.band_voxels = 3.0, .sheet_voxels = 1.0};
    const auto is_made_again = [&](const Bytes& lie, const auto& ask) {
        ShapeCache cache(keep_all(scratch.path()));
        (void)ask(cache);
        const fs::path path = find_only(scratch.path());
        // The key that it is asked for by, with right checksums, and other contents.
        const Digest key = [&] {
            Digest found{};
            const std::string hex = path.stem().string();
            for (std::size_t i = 0; i < found.size(); ++i) {
                found[i] = static_cast<std::byte>(std::stoi(hex.substr(2 * i, 2), nullptr, 16));
            }
            return found;
        }();
        Bytes changed = lie;
        std::copy(key.begin(), key.end(), changed.begin() + 16);
        const auto sealed = static_cast<std::ptrdiff_t>(changed.size() - sizeof(Digest));
        const Digest checksum =
            compute_sha256(std::span(changed).first(static_cast<std::size_t>(sealed)));
        std::copy(checksum.begin(), checksum.end(), changed.begin() + sealed);
        keep(cache, key, changed);
        const bool is_refused =
            ask(cache) && cache.counts().n_refused == 1 && cache.told().size() == 1 &&
            cache.told().front().find("is not the one that was asked for") != std::string::npos;
        fs::remove(path);
        return is_refused;
    };
    const auto ask_field = [&](ShapeCache& cache) {
        return recall_distance_field(cache, ball(), frame, {}).has_value();
    };
    const Digest none{};
    CHECK_FALSE(is_made_again(encode(field, none), ask_field));
    CHECK(is_made_again(encode(DistanceField::build(ball(), moved).value(), none), ask_field));
    CHECK(is_made_again(encode(DistanceField::build(ball(), finer).value(), none), ask_field));
    CHECK(is_made_again(
        encode(DistanceField::build(ball(), frame, {.band_voxels = 2.5}).value(), none),
        ask_field));
    CHECK(
        is_made_again(encode(DistanceField::build(ball(), frame, sheet).value(), none), ask_field));
    const auto ask_voxels = [&](ShapeCache& cache) {
        return recall_voxels(cache, ball(), {.voxel_m = 0.1}).has_value();
    };
    CHECK(is_made_again(encode(voxelise(ball(), {.voxel_m = 0.11}).value(), none), ask_voxels));
    CHECK(is_made_again(
        encode(voxelise(ball(), {.voxel_m = 0.1, .offset_layers = 1}).value(), none), ask_voxels));
    const auto ask_shell = [&](ShapeCache& cache) {
        return recall_surface_pointshell(cache, ball(), 100).has_value();
    };
    CHECK(is_made_again(encode(shell_of(99), none), ask_shell));
    // Of the right size and frame, with what no maker makes of that mesh.
    Pointshell far = shell_of(100);
    CHECK_FALSE(is_made_again(encode(far, none), ask_shell));
    far.z_m[41] = 28.0F;
    CHECK(is_made_again(encode(far, none), ask_shell));
    VoxelGrid grid = voxelise(ball(), {.voxel_m = 0.1}).value();
    CHECK_FALSE(is_made_again(encode(grid, none), ask_voxels));
    grid.cells.front() = VoxelClass::surface;
    CHECK(is_made_again(encode(grid, none), ask_voxels));
    const TriangleMesh smaller = make_sphere(0.8, 3).value();
    CHECK(is_made_again(encode(DistanceField::build(smaller, frame).value(), none), ask_field));
    const auto ask_solid = [&](ShapeCache& cache) {
        return recall_measured_solid(cache, ball()).has_value();
    };
    CHECK_FALSE(is_made_again(encode(measure_solid(ball()).value(), none), ask_solid));
    CHECK(is_made_again(encode(measure_solid(smaller).value(), none), ask_solid));
}

TEST_CASE("shape cache: what will not be kept is not made into bytes") {
    const ScratchFolder scratch;
    scratch.write("file", "");
    int n_asked = 0;
    const auto write = [&](ShapeCacheSettings settings) {
        ShapeCache cache(std::move(settings));
        cache.write(key_of(1), 1.0, 1000, [&] {
            ++n_asked;
            return Bytes(1000);
        });
    };
    write({});
    write({.folder = scratch.path() / "a", .least_build_s = 1.5});
    write({.folder = scratch.path() / "a", .most_bytes = 999});
    write({.folder = scratch.path() / "a", .most_file_bytes = 999});
    write({.folder = scratch.path() / "file" / "below"});
    CHECK(n_asked == 0);
    CHECK_FALSE(fs::exists(scratch.path() / "a"));
    write({.folder = scratch.path() / "a", .most_bytes = 1000, .most_file_bytes = 1000});
    CHECK(n_asked == 1);
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
    const std::string old_unfinished = to_hex(key_of(5)) + ".shape.1.0.tmp";
    const std::string new_unfinished = to_hex(key_of(6)) + ".shape.1.0.tmp";
    const std::vector<std::string> others{"notes.txt",
                                          "notes.tmp",
                                          "notes.1.0.tmp",
                                          "a.shape",
                                          "a.shape.1.0.tmp",
                                          to_hex(key_of(7)) + ".shape.tmp",
                                          to_hex(key_of(7)) + ".shape.old"};
    scratch.write(old_unfinished, "unfinished");
    scratch.write(new_unfinished, "being written");
    fs::last_write_time(scratch.path() / old_unfinished, now - std::chrono::hours(2));
    for (const std::string& other : others) {
        scratch.write(other, std::string(one, 'x'));
        fs::last_write_time(scratch.path() / other, now - std::chrono::hours(100));
    }
    REQUIRE(maker.make(cache, key_of(3)));
    CHECK(maker.n_made == 4);
    CHECK(fs::exists(path_of(0)));
    CHECK_FALSE(fs::exists(path_of(1)));
    CHECK(fs::exists(path_of(2)));
    CHECK(fs::exists(path_of(3)));
    CHECK_FALSE(fs::exists(scratch.path() / old_unfinished));
    CHECK(fs::exists(scratch.path() / new_unfinished));
    for (const std::string& other : others) {
        INFO(other);
        CHECK(fs::exists(scratch.path() / other));
    }
    // What is larger than all that may be kept drives nothing out.
    settings.most_bytes = one / 2;
    ShapeCache narrow(settings);
    REQUIRE(maker.make(narrow, key_of(9)));
    CHECK(narrow.told().size() == 1);
    CHECK(narrow.counts().n_kept == 0);
    CHECK(fs::exists(path_of(3)));
}

TEST_CASE("shape cache: it lies in the user's cache folder") {
    const auto folder = default_shape_cache_folder();
    REQUIRE(folder);
    CHECK(folder->is_absolute());
    CHECK(folder->filename() == "shapes");
    CHECK(folder->parent_path().filename() == "fulcrum");
}
