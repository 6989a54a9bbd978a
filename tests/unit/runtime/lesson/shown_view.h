// A lesson of two things as it is seen in a frame.
#pragma once

#include "runtime/lesson/compose_view.h"
#include "tests/unit/runtime/lesson/session_fixture.h"

namespace fulcrum::runtime::test {

struct Shown {
    LessonDescription lesson = two_things();
    Plan plan = compile_plan(lesson, {}, nullptr).value();
    SessionHud hud{};
    WorldSnapshot world{};
    Scenery scenery{};

    Shown() {
        world.n_bodies = 2;
        scenery.world = &world;
    }
    [[nodiscard]] runtime::View view() const {
        return compose_view(lesson, plan, hud, scenery, words());
    }
};

}  // namespace fulcrum::runtime::test
