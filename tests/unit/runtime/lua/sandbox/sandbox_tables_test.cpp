#include "tests/unit/runtime/lua/told_lessons.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

/// What a game that does this is told within twenty frames.
std::string told_game(const std::string&, const std::string& in) {
    Player player;
    player.start(game_text(in));
    for (int frame = 0; frame < 20 && player.error.empty(); ++frame) {
        player.step();
    }
    return player.error;
}

/// What a hand that moves so is told.
std::string told_motion(const std::string&, const std::string& in) {
    Player player;
    player.folder.write(
        "hand.lua",
        "local motion = require 'motion'\nreturn motion.play(function(world)\n" + in + "\nend)");
    player.start("function L:start(world) world:body { name = 'apple' } end", "hand.lua");
    player.step();
    return player.error;
}

TableReader told_scripts() {
    TableReader reader = told_lessons();
    reader.probes["in_game"] = told_game;
    reader.probes["in_motion"] = told_motion;
    reader.probes["in_story"] = [](const std::string&, const std::string& in) {
        return LessonFolder().begin(kStory + in + " end) end");
    };
    return reader;
}

}  // namespace

TEST_CASE("sandbox: what a lesson is told is what the tables say") {
    hold_tables(FULCRUM_SOURCE_DIR "/tests/unit/runtime/lua/sandbox", told_scripts);
}
