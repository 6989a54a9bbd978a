#include "runtime/app/places.h"
#include "runtime/app/site_file.h"
#include "runtime/app/watched_files.h"
#include "runtime/scene/description.h"
#include "tests/unit/runtime/rig.h"

#include <chrono>
#include <sys/stat.h>
#include <unistd.h>

using namespace fulcrum::runtime::test;
namespace fs = std::filesystem;
using namespace std::chrono_literals;

namespace {

// A small installation in a folder of its own.
struct Installation {
    ScratchFolder folder;
    fs::path root = folder.path();
    Installation() {
        for (const char* part : {"scenarios/gravity", "scenarios/empty", "scripts/lib",
                                 "assets/words", "build/dev/assets/models"}) {
            fs::create_directories(root / part);
        }
        std::ofstream(root / "scenarios" / "gravity" / "lesson.lua") << "return nil";
        std::ofstream(root / "build" / "dev" / "assets" / "models" / "apple.glb") << "x";
    }
    [[nodiscard]] Places places() const {
        return find_places_from(root / "build" / "dev" / "fulcrum", {own()}).value();
    }
    // Where the user's data is.
    [[nodiscard]] fs::path own() const { return root / "home" / "share"; }
};

void write_text(const std::filesystem::path& file, const std::string& text) {
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file) << text;
}

// A user's folder for settings of the test's own.
class OwnSettings {
  public:
    OwnSettings() {
        const char* const value = std::getenv("XDG_CONFIG_HOME");
        before_ = value == nullptr ? "" : value;
        ::setenv("XDG_CONFIG_HOME", folder_.path().c_str(), 1);
    }
    ~OwnSettings() {
        if (before_.empty()) {
            ::unsetenv("XDG_CONFIG_HOME");
        } else {
            ::setenv("XDG_CONFIG_HOME", before_.c_str(), 1);
        }
    }
    OwnSettings(const OwnSettings&) = delete;
    OwnSettings& operator=(const OwnSettings&) = delete;
    [[nodiscard]] std::filesystem::path own_file() const {
        return folder_.path() / "fulcrum" / "site.conf";
    }
    [[nodiscard]] std::filesystem::path shared_file() const {
        return folder_.path() / "shared.conf";
    }

  private:
    ScratchFolder folder_;
    std::string before_;
};

std::string complaint(const std::string& text) {
    const auto site = parse_site_file(text, "site.conf");
    return site ? "" : to_sentence(site.error());
}

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

TEST_CASE("places: the folder above the program with lessons, scripts and words is the checkout") {
    const Installation installation;
    const Places places = installation.places();
    CHECK(places.scenarios == installation.root / "scenarios");
    CHECK(places.models == installation.root / "build" / "dev" / "assets" / "models");
    CHECK(places.helpers == installation.root / "build" / "dev");
    fs::remove_all(installation.root / "assets");
    CHECK_FALSE(find_places_from(installation.root / "build" / "dev" / "fulcrum", {}));
    CHECK_FALSE(find_places_from("/nowhere/at/all/fulcrum", {}));
}

TEST_CASE("places: an installed program finds its data and helpers below any prefix") {
    const Installation installation;
    const fs::path prefix = installation.root / "prefix";
    const fs::path data = prefix / "share" / "fulcrum";
    for (const char* part : {"scenarios", "scripts/lib", "assets/words"}) {
        fs::create_directories(data / part);
    }
    fs::create_directories(prefix / "libexec" / "fulcrum");
    const auto places =
        value_of(find_places_from(prefix / "bin" / "fulcrum", {installation.own()}));
    CHECK(places.scenarios == data / "scenarios");
    CHECK(places.scripts_lib == data / "scripts" / "lib");
    CHECK(places.words == data / "assets" / "words");
    CHECK(places.models == data / "assets" / "models");
    CHECK(places.helpers == prefix / "libexec" / "fulcrum");
    // Alone in another folder it finds that data all the same.
    const auto alone = value_of(
        find_places_from("/nowhere/at/all/fulcrum", {installation.own(), prefix / "share"}));
    CHECK(alone.scenarios == data / "scenarios");
    CHECK(alone.helpers == "/nowhere/at/all");
}

TEST_CASE("places: lessons of the user's own stand beside the others, before any of one name") {
    const Installation installation;
    const fs::path own = installation.own() / "fulcrum" / "scenarios";
    for (const char* name : {"stone", "gravity"}) {
        fs::create_directories(own / name);
        std::ofstream(own / name / "lesson.lua") << "return nil";
    }
    const Places places = installation.places();
    CHECK(list_lesson_names(places) == std::vector<std::string>{"gravity", "stone"});
    CHECK(find_lesson(places, "stone") == own / "stone");
    CHECK(find_lesson(places, "gravity") == own / "gravity");
    // Who has no home folder has none.
    const auto none =
        value_of(find_places_from(installation.root / "build" / "dev" / "fulcrum", {fs::path()}));
    CHECK(list_lesson_names(none) == std::vector<std::string>{"gravity"});
}

TEST_CASE("places: a lesson is found by name and by folder; a slip gets the nearest name") {
    const Installation installation;
    const Places places = installation.places();
    CHECK(find_lesson(places, "gravity") == installation.root / "scenarios" / "gravity");
    CHECK(find_lesson(places, (installation.root / "scenarios" / "gravity").string()));
    CHECK(find_lesson(places,
                      (installation.root / "scenarios" / "gravity" / "lesson.lua").string()) ==
          installation.root / "scenarios" / "gravity");
    CHECK(list_lesson_names(places) == std::vector<std::string>{"gravity"});
    check_says(refusal_of(find_lesson(places, "gravty")), {"did you mean gravity"});
    CHECK_FALSE(find_lesson(places, "empty"));
}

TEST_CASE("places: a model's name cannot leave its folder") {
    const Installation installation;
    const Places places = installation.places();
    const fs::path lesson = places.scenarios / "gravity";
    CHECK(find_model(places, lesson, "apple") == places.models / "apple.glb");
    CHECK(find_model(places, lesson, "pear").empty());
    CHECK(find_model(places, lesson, "../models/apple").empty());
    CHECK(find_model(places, lesson, "").empty());
    // Without a lesson no file of the folder in which the program was started is one.
    const fs::path started_in = fs::current_path();
    fs::current_path(places.models);
    CHECK(find_model(places, {}, "apple") == places.models / "apple.glb");
    fs::current_path(started_in);
}

TEST_CASE("places: what lies in a folder comes in order; a folder that cannot be read is empty") {
    const Installation installation;
    const fs::path scenarios = installation.root / "scenarios";
    CHECK(entries_of(scenarios) ==
          std::vector<fs::path>{scenarios / "empty", scenarios / "gravity"});
    CHECK(entries_of(scenarios / "nowhere").empty());
    CHECK(entries_of(scenarios / std::string(300, 'a')).empty());
}

TEST_CASE("site file: four limits, comments and empty lines") {
    const auto site = value_of(parse_site_file(
        "# this room\n\nforce_limit = 3 # newtons\r\n\ttorque_limit=0.2\nspeed_limit = "
        "2\nenergy_limit = 1.5",
        "f"));
    CHECK(site.force_N == 3.0);
    CHECK(site.torque_Nm == 0.2);
    CHECK(site.speed_m_per_s == 2.0);
    CHECK(site.energy_J == 1.5);
    const auto nothing = value_of(parse_site_file("", "f"));
    CHECK_FALSE(nothing.force_N);
    // Said twice, the smaller holds.
    CHECK(parse_site_file("force_limit = 2\nforce_limit = 4", "f")->force_N == 2.0);
}

TEST_CASE("site file: what is no limit is told with its line, and nothing is guessed") {
    check_says(complaint("force_limit = 3\nforse_limit = 2"), {"site.conf:2"});
    for (const char* const bad :
         {"force_limit", "= 3", "force_limit 3", "force_limit = ", "force_limit = three",
          "force_limit = 3 N", "force_limit = 0.4", "force_limit = 10.1", "force_limit = nan",
          "force_limit = inf", "force_limit = -1", "torque_limit = 1.1", "speed_limit = 0",
          "energy_limit = 21", "\xff\xfe", "force_limit = 3 force_limit = 2"}) {
        INFO(bad);
        check_says(complaint(bad), {"site.conf:1"});
    }
}

TEST_CASE("site file: of the computer's, the user's and the command line's the least holds") {
    const OwnSettings settings;
    const auto find = [&](std::optional<double> asked_N) {
        return value_of(find_site_limits(asked_N, settings.shared_file()));
    };
    CHECK(find({}).force_N == SafetySettings{}.max_force_N);
    CHECK(find(10.0).force_N == 10.0);
    CHECK(find(2.0).force_N == 2.0);
    // A gentler force is gentler to the wrist.
    CHECK(find(2.5).torque_Nm == Approx(0.5 * SafetySettings{}.max_torque_Nm));
    write_text(settings.shared_file(), "force_limit = 4\nenergy_limit = 2\n");
    CHECK(find(10.0).force_N == 4.0);
    CHECK(find(3.0).force_N == 3.0);
    CHECK(find({}).energy_J == 2.0);
    write_text(settings.own_file(),
               "force_limit = 2\nenergy_limit = 9\nspeed_limit = 1\ntorque_limit = 0.1\n");
    CHECK(find(10.0).force_N == 2.0);
    CHECK(find({}).energy_J == 2.0);
    CHECK(find({}).speed_m_per_s == 1.0);
    CHECK(find({}).torque_Nm == 0.1);
    // Files may allow more than is usual.
    write_text(settings.shared_file(), "force_limit = 8\n");
    write_text(settings.own_file(), "");
    CHECK(find({}).force_N == 8.0);
}

TEST_CASE("site file: one that cannot be read keeps every lesson from starting") {
    const OwnSettings settings;
    write_text(settings.shared_file(), "force_limit = 99\n");
    CHECK_FALSE(find_site_limits({}, settings.shared_file()));
    std::filesystem::remove(settings.shared_file());
    std::filesystem::create_directory(settings.shared_file());
    CHECK_FALSE(find_site_limits({}, settings.shared_file()));
    std::filesystem::remove(settings.shared_file());
    write_text(settings.own_file(), std::string(70'000, '#'));
    CHECK_FALSE(find_site_limits({}, settings.shared_file()));
    write_text(settings.own_file(), "force_limit = 1");
    CHECK(find_site_limits({}, settings.shared_file()));
}

TEST_CASE("site file: a link that leads nowhere is no place without limits") {
    const OwnSettings settings;
    const std::filesystem::path shared = settings.shared_file();
    std::filesystem::create_symlink("/nowhere/site.conf", shared);
    CHECK(error_of(find_site_limits({}, shared)).where == shared.string());
    // A folder on the way is on a share that is away.
    const std::filesystem::path share = shared.parent_path() / "share";
    std::filesystem::create_symlink("/nowhere", share);
    CHECK(error_of(find_site_limits({}, share / "site.conf")).where == share.string());
    // One that leads somewhere is followed.
    std::filesystem::remove(shared);
    write_text(shared.parent_path() / "real.conf", "force_limit = 2");
    std::filesystem::create_symlink("real.conf", shared);
    CHECK(value_of(find_site_limits({}, shared)).force_N == 2.0);
}

TEST_CASE("site file: one that others may change, or whose folder they may, starts no lesson") {
    const OwnSettings settings;
    const std::filesystem::path shared = settings.shared_file();
    const auto is_refused = [&] {
        const auto limits = find_site_limits({}, shared);
        return !limits && limits.error().where == shared.string();
    };
    write_text(shared, "force_limit = 2");
    CHECK_FALSE(is_refused());
    REQUIRE(::chmod(shared.c_str(), 0666) == 0);
    CHECK(is_refused());
    REQUIRE(::chmod(shared.c_str(), 0644) == 0);
    CHECK_FALSE(is_refused());
    const std::filesystem::path folder = shared.parent_path();
    REQUIRE(::chmod(folder.c_str(), 0777) == 0);
    CHECK(is_refused());
    REQUIRE(::chmod(folder.c_str(), 01777) == 0);
    CHECK_FALSE(is_refused());
    if (::geteuid() == 0) {
        constexpr uid_t kNobody = 65534;
        REQUIRE(::chown(shared.c_str(), kNobody, kNobody) == 0);
        CHECK(is_refused());
    }
}

TEST_CASE("site file: a pipe in its place makes nobody wait, and no lesson starts") {
    const ScratchFolder folder;
    const auto file = folder.path() / "site.conf";
    REQUIRE(::mkfifo(file.c_str(), 0644) == 0);
    CHECK(error_of(load_site_file(file)).where == file.string());
}

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
    // Four times a second is often enough.
    CHECK(files.changed_by(7.0));
    CHECK_FALSE(files.changed_by(7.2));
    CHECK(files.changed_by(7.3));
}

TEST_CASE("watched files: a lesson is made of its sources, its pictures and its own models") {
    const Folder folder;
    folder.save("kettle.glb");
    folder.save("pail.gltf");
    folder.save("spoon.glb");
    folder.save("thumb.glb");
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
    lesson.hand.tool.emplace().model = "spoon";
    lesson.more_hands.emplace_back().cursor_model = "thumb";
    const auto held = files_of_lesson({}, folder.at, lesson, {});
    CHECK(has(held, folder.file("spoon.glb")));
    CHECK(has(held, folder.file("thumb.glb")));
    for (const char* name : {"lesson.lua", "felt.jpg", "kettle.glb", "pail.gltf"}) {
        CAPTURE(name);
        CHECK(has(files, folder.file(name)));
    }
}
