#include "runtime/app/watched_files.h"

#include "runtime/app/places.h"
#include "runtime/scene/description.h"
#include "tests/unit/runtime/rig.h"

#include <chrono>

using namespace fulcrum::runtime::test;
namespace fs = std::filesystem;
using namespace std::chrono_literals;

namespace {

// A lesson's folder with a Lua file, a picture and a note that is no part of it.
struct Folder {
    ScratchFolder scratch;
    fs::path at = scratch.path();
    Folder() {
        for (const char* name : {"lesson.lua", "felt.jpg", "notes.txt"}) {
            save(name);
        }
    }
    [[nodiscard]] fs::path file(const std::string& name) const { return at / name; }
    void save(const std::string& name, const std::string& text = "x") const {
        std::ofstream(file(name)) << text;
    }
    /// As if it had been saved so much later; the clock of a file system may be too coarse to wait for.
    void save_later(const std::string& name, fs::file_time_type::duration by = 1s) const {
        fs::last_write_time(file(name), fs::last_write_time(file(name)) + by);
    }
};

bool has(const std::vector<fs::path>& files, const fs::path& file) {
    return std::ranges::find(files, file) != files.end();
}

}  // namespace

TEST_CASE("watched files: a picture that is saved again is noticed, a note beside it is not") {
    const Folder folder;
    WatchedFiles files;
    files.watch_folder(folder.at);
    files.watch_only({folder.file("lesson.lua"), folder.file("felt.jpg")});
    CHECK_FALSE(files.changed());
    folder.save_later("notes.txt");
    folder.save("new.lua");
    CHECK_FALSE(files.changed());
    folder.save_later("felt.jpg");
    CHECK(files.changed());
}

TEST_CASE("watched files: an older date, another size and a file that went are changes too") {
    const Folder folder;
    const auto change = GENERATE(0, 1, 2);
    CAPTURE(change);
    WatchedFiles files;
    files.watch_folder(folder.at);
    files.watch_only({folder.file("felt.jpg")});
    const auto written = fs::last_write_time(folder.file("felt.jpg"));
    if (change == 0) {
        folder.save_later("felt.jpg", -1s);
    } else if (change == 1) {
        folder.save("felt.jpg", "longer");
        fs::last_write_time(folder.file("felt.jpg"), written);
    } else {
        fs::remove(folder.file("felt.jpg"));
    }
    CHECK(files.changed());
}

TEST_CASE("watched files: what is saved while the lesson is being loaded is noticed") {
    const Folder folder;
    WatchedFiles files;
    files.watch_folder(folder.at);
    folder.save_later("lesson.lua");
    files.watch_only({folder.file("lesson.lua")});
    CHECK(files.changed());
}

TEST_CASE("watched files: while a lesson cannot be loaded, what comes into its folder counts") {
    const Folder folder;
    WatchedFiles files;
    files.watch_folder(folder.at);
    folder.save("more.txt");
    CHECK_FALSE(files.changed());
    const std::string name = GENERATE("missing.PNG", "helper.lua", "kettle.glb");
    CAPTURE(name);
    folder.save(name);
    CHECK(files.changed());
}

TEST_CASE("watched files: a lesson is made of its sources, its pictures and its own models") {
    const Folder folder;
    folder.save("kettle.glb");
    folder.save("pail.gltf");
    LessonDescription lesson;
    lesson.bucket.present = true;
    lesson.bucket.model = "pail";
    lesson.bodies.resize(2);
    lesson.bodies[0].model = "kettle";
    lesson.bodies[1].model = "nowhere";
    lesson.materials.resize(2);
    lesson.materials[0].image = "felt.jpg";
    const auto files = files_of_lesson({}, folder.at, lesson, {folder.file("lesson.lua")});
    CHECK(files.size() == 4);
    for (const char* name : {"lesson.lua", "felt.jpg", "kettle.glb", "pail.gltf"}) {
        CAPTURE(name);
        CHECK(has(files, folder.file(name)));
    }
}
