// A lesson that is played frame by frame, as the session would, and what it prints.
#pragma once

#include "tests/unit/runtime/lua/lesson_folder.h"

#include <catch2/catch.hpp>

#include <memory>
#include <utility>
#include <vector>

namespace fulcrum::runtime::test {

/// The beginning of a lesson that tells a story: what follows stands from line 11 on.
inline constexpr const char* kStory = R"(
local story = require "story"
local wait, wait_for = story.wait, story.wait_for
L:question "q" { prompt = "?", answers = { "{thing}" }, right = function(a) return true end }
function L:start(world)
  local apple = world:body { name = "apple", movable = true }
  local egg = world:body { name = "egg", movable = true }
  world:bucket {}
  story(L, function()
)";

/// A lesson that plays `tell` as a game, from line 9 on.
inline std::string game_text(const std::string& tell) {
    return R"(
local game = require "game"
local story = require "story"
L:question "q" { prompt = "?", answers = { "{thing}" }, right = function(a) return true end }
function L:start(world)
  world:body { name = "apple" }
  game.play(L, world, function(round)
)" + tell + "\n  end)\nend";
}

/// A lesson that is fed frames and whose prints are collected.
struct Player {
    LessonFolder folder;
    std::unique_ptr<LessonProcess> process;
    std::string prints;
    std::string error;
    LessonReply last;
    double time_s = 0.0;

    void start(const std::string& body, const std::string& hand = {}) {
        auto started = folder.start(lesson_text(body), hand);
        REQUIRE(started);
        process = std::move(*started);
        for (const std::string& line : process->prints_while_loading()) {
            prints += line + ';';
        }
    }
    void step(std::vector<LessonEvent> events = {}, double dt_s = 0.25) {
        LessonFrame frame = frame_for(process->description(), time_s);
        frame.dt_s = dt_s;
        frame.tool_pose_W.position = Vector3(0, 0.3, 0);
        frame.events = std::move(events);
        time_s += dt_s;
        auto reply = process->exchange(frame);
        if (!reply) {
            error = to_sentence(reply.error());
            return;
        }
        last = std::move(*reply);
        for (const LessonCommand& command : last.commands) {
            if (const auto* print = std::get_if<PrintCommand>(&command)) {
                prints += print->text + ';';
            }
        }
    }
};

}  // namespace fulcrum::runtime::test
