#include "runtime/app/choice_picture.h"

#include "tests/unit/runtime/rig.h"

#include <fstream>
#include <utility>

using namespace fulcrum::runtime::test;

namespace {

// Models in a folder of their own, and a lesson with an apple, a wall, and a block each of wood and of metal.
struct Pictured {
    ScratchFolder models;
    ScratchFolder folder;
    Places places;
    LessonDescription lesson;

    Pictured() {
        for (const auto& [where, name] : {std::pair{models.path(), "jupiter.glb"},
                                          {models.path(), "sun.glb"},
                                          {models.path(), "apple.glb"},
                                          {folder.path(), "felt.gltf"}}) {
            std::ofstream(where / name) << "x";
        }
        places.models = models.path();
        BodyDescription apple;
        apple.noun = "apple";
        apple.model = "red_apple";
        BodyDescription walls;
        walls.noun = "wall";
        walls.model = "hedge";
        walls.boxes.emplace_back();
        lesson.bodies = {apple, walls};
        for (const char* name : {"wood", "metal"}) {
            BodyDescription block;
            block.noun = std::string(name) + " block";
            block.model = "box";
            block.material = static_cast<std::int32_t>(lesson.materials.size());
            lesson.bodies.push_back(block);
            lesson.materials.push_back({{}, name, {}});
        }
    }
    std::string of(const std::string& word) const {
        return find_word_picture(word, lesson, places, folder.path()).model;
    }
    /// "model look" of each.
    std::vector<std::string> of_all(const std::vector<AnswerSlots>& meanings) const {
        std::vector<AnswerChoice> choices;
        for (const AnswerSlots& meaning : meanings) {
            choices.push_back({"", false, meaning});
        }
        std::vector<std::string> all;
        for (const ChoicePicture& picture :
             find_choice_pictures(choices, lesson, places, folder.path())) {
            all.push_back(picture.model + (picture.look.empty() ? "" : " " + picture.look));
        }
        return all;
    }
};

}  // namespace

TEST_CASE("choice picture: a thing of the scene, else what is called as a model, else none") {
    const Pictured room;
    CHECK(room.of("apple") == "red_apple");
    CHECK(room.of("Jupiter") == "jupiter");
    CHECK(room.of("the Sun") == "sun");
    CHECK(room.of("felt") == "felt");
    // Many boxes together are no picture; a name that leads elsewhere is no model.
    CHECK(room.of("wall").empty());
    CHECK(room.of("../models/sun").empty());
    CHECK(room.of("").empty());
}

TEST_CASE("choice pictures: they show what parts the choices, or nothing") {
    const Pictured room;
    using Texts = std::vector<std::string>;
    CHECK(room.of_all({{{"thing", "apple"}}, {{"thing", "Jupiter"}}}) ==
          Texts{"red_apple", "jupiter"});
    // What all of them say is no difference.
    CHECK(room.of_all({{{"thing", "apple"}, {"other", "the Sun"}},
                       {{"thing", "apple"}, {"other", "Jupiter"}}}) == Texts{"sun", "jupiter"});
    CHECK(room.of_all({{{"thing", "apple"}, {"other", "Jupiter"}},
                       {{"thing", "Jupiter"}, {"other", "apple"}}}) ==
          Texts{"red_apple", "jupiter"});
    // Adjectives have no picture; one beside another's is none either.
    CHECK(room.of_all({{{"thing", "apple"}, {"feel", "hard"}},
                       {{"thing", "apple"}, {"feel", "soft"}}}) == Texts{"", ""});
    CHECK(room.of_all({{{"thing", "apple"}}, {{"thing", "wall"}}}) == Texts{"", ""});
    CHECK(room.of_all({{{"place", "on"}, {"thing", "apple"}},
                       {{"place", "under"}, {"thing", "apple"}},
                       {{"place", "on"}, {"thing", "Jupiter"}}}) == Texts{"", "", ""});
    // Two boxes are told from each other by what they are made of.
    CHECK(room.of_all({{{"thing", "wood block"}}, {{"thing", "metal block"}}}) ==
          Texts{"box wood", "box metal"});
    CHECK(room.of_all({}).empty());
}
