#include "runtime/app/choice_picture.h"

#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

TEST_CASE("choice picture: a thing of the scene, else what is called as a model, else none") {
    const ScratchFolder models;
    const ScratchFolder folder;
    for (const auto& [where, name] : {std::pair{models.path(), "jupiter.glb"},
                                      {models.path(), "sun.glb"},
                                      {models.path(), "apple.glb"},
                                      {folder.path(), "felt.gltf"}}) {
        std::ofstream(where / name) << "x";
    }
    Places places;
    places.models = models.path();
    LessonDescription lesson;
    BodyDescription apple;
    apple.noun = "apple";
    apple.model = "red_apple";
    BodyDescription walls;
    walls.noun = "wall";
    walls.model = "hedge";
    walls.boxes.emplace_back();
    lesson.bodies = {apple, walls};
    const auto picture = [&](const AnswerSlots& meaning) {
        return find_choice_picture({"", true, meaning}, lesson, places, folder.path());
    };
    CHECK(picture({{"thing", "apple"}}) == "red_apple");
    CHECK(picture({{"planet", "Jupiter"}}) == "jupiter");
    CHECK(picture({{"planet", "the Sun"}}) == "sun");
    CHECK(picture({{"material", "felt"}}) == "felt");
    // What stands in the scene is nearer than what is only called so.
    CHECK(picture({{"planet", "Jupiter"}, {"thing", "apple"}}) == "red_apple");
    CHECK(picture({{"size", "big"}, {"planet", "Jupiter"}}) == "jupiter");
    // Many boxes together are no picture; a name that leads elsewhere is no model.
    CHECK(picture({{"thing", "wall"}}).empty());
    CHECK(picture({{"thing", "../models/sun"}}).empty());
    CHECK(picture({{"thing", ""}}).empty());
    CHECK(picture({}).empty());
}
