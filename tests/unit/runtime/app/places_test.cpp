#include "runtime/app/places.h"

#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;
namespace fs = std::filesystem;

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
}

TEST_CASE("places: what lies in a folder comes in order; a folder that cannot be read is empty") {
    const Installation installation;
    const fs::path scenarios = installation.root / "scenarios";
    CHECK(entries_of(scenarios) ==
          std::vector<fs::path>{scenarios / "empty", scenarios / "gravity"});
    CHECK(entries_of(scenarios / "nowhere").empty());
    CHECK(entries_of(scenarios / std::string(300, 'a')).empty());
}
