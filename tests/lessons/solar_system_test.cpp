// The lesson on planets, played to its end by its own simulated hand and pupil.
#include "tests/lessons/program.h"

#include <cmath>
#include <numbers>
#include <vector>

using namespace fulcrum::test;

namespace {

// Scene indices, in the order of lesson.lua: the Sun, then of each planet its way, the far one and the near one, and behind the
// Earth that is compared with and the star the Moon from near and from far.
enum Body : int { far_earth = 8, earth = 9, jupiter = 15, moon = 27, far_moon = 28 };

}  // namespace

TEST_CASE("solar-system: the hand turns the Earth at its side, near its pole, and then Jupiter") {
    const Sandbox sandbox;
    REQUIRE(sandbox.run("run solar-system --headless --record r.rec").exit_code == 0);
    const Record record = read_run(sandbox.path("r.rec"));
    const double first_s = time_of(record, RecordEventKind::touched, earth);
    const double last_s = time_of(record, RecordEventKind::touched, jupiter);
    REQUIRE(first_s > 0.0);
    REQUIRE(last_s > first_s);
    // It drags the surface sideways: friction, not only a push.
    double sideways_N = 0.0;
    for (const RecordSample& sample : record.samples) {
        if (sample.time_s > first_s && sample.time_s < last_s) {
            sideways_N = std::max(sideways_N, std::abs(sample.commanded_W.force.x()));
        }
    }
    CHECK(sideways_N > 0.3);
}

TEST_CASE("solar-system: the same day shows the same sky") {
    const Sandbox sandbox;
    const std::string run = "run solar-system --headless --seconds 5 --screenshot ";
    REQUIRE(sandbox.run(run + "a.png").exit_code == 0);
    REQUIRE(sandbox.run(run + "b.png").exit_code == 0);
    CHECK(bytes_of(sandbox.path("a.png")) == bytes_of(sandbox.path("b.png")));
}

TEST_CASE("solar-system: the Moon goes round the Earth, and is beside it where moons are counted") {
    const Sandbox sandbox;
    REQUIRE(sandbox.run("run solar-system --headless --seconds 30 --record r.rec").exit_code == 0);
    const Record record = read_run(sandbox.path("r.rec"));
    fulcrum::Vector3 earth_W = fulcrum::Vector3::Zero();
    double earth_s = -1.0;
    double last = 0.0;
    double turned = 0.0;
    int n = 0;
    constexpr double year_over_s = 16.0;  // then today's sky is shown again
    std::vector<fulcrum::BodyState> near_moon;
    for (const RecordBody& body : record.bodies) {
        if (body.body == far_earth) {
            earth_W = body.state.pose_W.position;
            earth_s = body.time_s;
        } else if (body.body == moon) {
            near_moon.push_back(body.state);
        } else if (body.body == far_moon && body.time_s == earth_s && earth_s < year_over_s &&
                   body.state.where == fulcrum::BodyWhere::placed) {
            const fulcrum::Vector3 away_W = body.state.pose_W.position - earth_W;
            CHECK(away_W.norm() == Approx(0.034).margin(1e-6));
            const double angle = std::atan2(-away_W.z(), away_W.x());
            turned += n++ > 0 ? std::remainder(angle - last, 2.0 * std::numbers::pi) : 0.0;
            last = angle;
        }
    }
    // A sidereal month has 27.32 days.
    CHECK(turned / (2.0 * std::numbers::pi) == Approx(365.26 / 27.32).margin(0.05));
    REQUIRE(near_moon.size() >= 2);
    CHECK(near_moon.back().where == fulcrum::BodyWhere::hidden);
    const fulcrum::BodyState& seen = near_moon[near_moon.size() - 2];
    CHECK(seen.where == fulcrum::BodyWhere::placed);
    const double away_m = (seen.pose_W.position - fulcrum::Vector3(0.0, 0.45, -1.1)).norm();
    CHECK(away_m > 0.21);  // outside the Earth
    CHECK(away_m < 0.4);
}

TEST_CASE("solar-system: the learner goes where they want, and each planet is seen once") {
    const Sandbox sandbox;
    sandbox.write("hand.lua", R"(
      local motion = require "motion"
      return motion.play(function(world)
        motion.start_at { 0.25, 0.35, 0.6 }
        for _, name in ipairs { "neptune", "neptune", "venus", "mars" } do
          local far, seen = world:find(name .. "-far"), world:find(name)
          motion.wait_until(function() return far.where ~= "hidden" end)
          for _ = 1, 12 do
            motion.move_to({ far.x, far.y + 0.25, far.z }, 0.5)
            motion.move_to(far, 0.5)
            motion.wait_until(function() return seen.where ~= "hidden" end, 1.5)
            if seen.where ~= "hidden" then break end
          end
        end
      end))");
    sandbox.write("say.txt", "eight planets\nit has two moons\none moon\nHow big is Mars?\n");
    // Neptune a second time is none; then nobody chooses, and is helped: the Earth, which is asked about, and no more.
    check_run(
        sandbox.run("run solar-system --headless --seconds 400 --hand hand.lua --say say.txt"), {},
        {"Go to a planet, and stay there.", "This is Neptune", "This is Venus", "This is Mars",
         "Put your hand on a planet that has a line around it.", "Let's go to the Earth.",
         "This is the Earth"},
        {"This is Mercury"});
}
