// What a lesson may choose by its name, in small lessons of one choice each: what is felt is what the law says.
#include "tests/lessons/program.h"
#include "tests/lessons/record_judge.h"

#include <algorithm>
#include <cmath>
#include <string>

using namespace fulcrum::test;

namespace {

constexpr double kHand_N_per_m = 300.0;  // of the simulated hand
constexpr double kUsual_N_per_m = 500.0;

// A hand that comes down over (x, z) from 0.5 m, stays at `low_m` from 2 s to 4 s, and goes up again.
std::string press_text(double x_m, double low_m) {
    const auto place = [&](double y_m) {
        return "{ " + std::to_string(x_m) + ", " + std::to_string(y_m) + ", 0 }";
    };
    return "local motion = require 'motion'\nreturn motion.play(function()\n  motion.start_at " +
           place(0.5) + "\n  motion.wait(1)\n  motion.move_to(" + place(low_m) +
           ", 1)\n  motion.wait(2)\n  motion.move_to(" + place(0.5) + ", 1)\nend)\n";
}

struct Played {
    std::string explained;
    Record record;
};

// A lesson that declares this, its plan, and what its hand felt in 5 s.
Played play(const std::string& declared, const std::string& hand) {
    const Sandbox sandbox;
    sandbox.write("one/lesson.lua",
                  "local L = lesson { id = 'one', title = 'One', level = 'A1', minutes = 1 }\n"
                  "function L:start(world)\n" +
                      declared + "\nend\nreturn L\n");
    sandbox.write("one/hand.lua", hand);
    const ProgramRun plan = sandbox.run("explain one");
    INFO(plan.output);
    REQUIRE(plan.exit_code == 0);
    check_run(sandbox.run("run one --headless --hand one/hand.lua --seconds 5 --record r.rec"), 0);
    return {plan.output, read_run(sandbox.path("r.rec"))};
}

std::string floor_text(const std::string& more = "") {
    return "  world:body { name = 'floor', model = 'box', size = { 0.2, 0.1, 0.2 }, at = { 0, "
           "0.25, "
           "0 }, solid = true" +
           more + " }\n";
}
constexpr double kFloor_m = 0.3;

double find_held_N(const Record& record) {
    return sample_at(record, 3.9).applied_W.force.y();
}

// Hand and wall as two springs.
double expect_N(double depth_m, double wall_N_per_m = kUsual_N_per_m) {
    return depth_m / (1.0 / kHand_N_per_m + 1.0 / wall_N_per_m);
}

}  // namespace

TEST_CASE("choices: the hand's speed is found by the method that is named") {
    for (const char* method :
         {"finite_difference", "filtered_difference", "adaptive_window", "kalman"}) {
        CAPTURE(method);
        const Played played =
            play("  world:hand { velocity = '" + std::string(method) + "' }\n" + floor_text(),
                 press_text(0.0, 0.29));
        check_says(played.explained, {std::string("a velocity, by ") + method});
        CHECK(find_held_N(played.record) == Approx(expect_N(0.01)).margin(0.02));
        const bool is_filtered = std::string_view(method) == "filtered_difference";
        const double share = is_filtered ? 1.0 - std::exp(-2.0 * M_PI * 80.0 * 0.001) : 1.0;
        double largest_error = 0.0;
        for (std::size_t i = 1500; i < 2500; ++i) {
            const RecordSample& before = played.record.samples[i - 1];
            const RecordSample& now = played.record.samples[i];
            const double rise_m_per_s =
                (now.pose_D.position.y() - before.pose_D.position.y()) / 0.001;
            const double by_law = std::lerp(before.twist_W.linear.y(), rise_m_per_s, share);
            largest_error = std::max(largest_error, std::abs(now.twist_W.linear.y() - by_law));
        }
        // Of the two that have a closed form nothing is left; the others are smoother, and late.
        const bool is_closed = is_filtered || std::string_view(method) == "finite_difference";
        CHECK((largest_error < 1.0e-6) == is_closed);
        CHECK(largest_error < 0.1);
    }
}

TEST_CASE("choices: at half the usual rate the same is felt, in half the rounds") {
    const Played played =
        play("  world:hand { rate = 500 }\n" + floor_text(), press_text(0.0, 0.29));
    check_says(played.explained, {"500 Hz"});
    CHECK(played.record.header.rate_Hz == 500.0);
    CHECK(std::abs(static_cast<double>(played.record.samples.size()) - 2500.0) < 3.0);
    CHECK(find_held_N(played.record) == Approx(expect_N(0.01)).margin(0.02));
    CHECK(find_trouble(played.record).empty());
}

TEST_CASE("choices: rigid bodies are stepped no oftener than the hand is") {
    const Played played = play(
        "  world:hand { rate = 500 }\n  world:body { name = 'block', model = 'box', mass = "
        "0.1, at = { 0, 0.05, 0 }, rigid = true }",
        press_text(0.0, 0.2));
    CHECK(played.explained.find("1000 Hz") == std::string::npos);
    REQUIRE(!played.record.bodies.empty());
    for (const RecordBody& body : played.record.bodies) {
        CHECK(std::abs(body.state.pose_W.position.y() - 0.05) < 1.0e-3);
    }
}

TEST_CASE("choices: H-COLLIDE leads a god-object the same way as the bounding tree, to the bit") {
    const auto with = [](const std::string& structure) {
        return play("  world:hand { proxy = 'god_object', structure = '" + structure + "' }\n" +
                        floor_text(),
                    press_text(0.09, 0.29));
    };
    const Played tree = with("bounding_tree");
    const Played hashed = with("h_collide");
    check_says(hashed.explained, {"god-object, found by h_collide; hard, massless"});
    check_lacks(tree.explained, {"h_collide"});
    REQUIRE(tree.record.samples.size() == hashed.record.samples.size());
    CHECK(largest_force_N(tree.record) > 1.0);
    for (std::size_t i = 0; i < tree.record.samples.size(); ++i) {
        REQUIRE(tree.record.samples[i].applied_W.force == hashed.record.samples[i].applied_W.force);
    }
}

TEST_CASE("choices: an edge bends the push where it is within the crease, and nowhere else") {
    // A tenth of the box's half size from its edge, where the normal has turned by 40 degrees of the corner's 55.
    const auto lean = [](const std::string& shaded) {
        const Played played = play("  world:hand { proxy = 'god_object' }\n" + floor_text(shaded),
                                   press_text(0.09, 0.29));
        const Vector3& force_N = sample_at(played.record, 3.9).applied_W.force;
        return std::abs(force_N.x()) / force_N.y();
    };
    CHECK(lean("") < 0.01);
    CHECK(lean(", rounded = true") < 0.01);
    CHECK(lean(", rounded = true, crease = 89") < 0.01);
    CHECK(lean(", rounded = true, crease = 91") > 0.3);
}

TEST_CASE("choices: a spring that saturates gives no more, however deep it is pressed") {
    const auto held_N = [](const std::string& saturation, double depth_m) {
        const Played played = play(
            "  world:hand {}\n  local m = world:material { name = 'dough', stiffness = 500, "
            "damping "
            "= 5" +
                saturation + " }\n" + floor_text(", material = m"),
            press_text(0.0, kFloor_m - depth_m));
        return find_held_N(played.record);
    };
    const std::string saturates = ", saturation = { force = 1, linear_range = 0.001 }";
    // In its linear range it is the spring that it would be.
    CHECK(held_N(saturates, 0.0015) == Approx(held_N("", 0.0015)).margin(1.0e-3));
    // It has given all that it has from 1 mm + 3 (1 - 0.5) N / (2 x 500 N/m) on, 2.5 mm.
    CHECK(held_N(saturates, 0.008) == Approx(1.0).margin(0.01));
    CHECK(held_N(saturates, 0.016) == Approx(1.0).margin(0.01));
    CHECK(held_N("", 0.016) > 2.5);
    // Without a range it is even up to half the force: 1 mm.
    CHECK(held_N(", saturation = { force = 1 }", 0.0015) ==
          Approx(held_N(saturates, 0.0015)).margin(1.0e-6));
}

TEST_CASE("choices: a hull cursor reaches as far as its model does") {
    // An egg's top, found by a point from above, and by a box's underside that the egg is pressed against from below.
    const Played felt = play(
        "  world:hand { proxy = 'god_object' }\n"
        "  world:body { name = 'egg', solid = true, felt_shape = 'hull', at = "
        "{ 0, 0.25, 0 }, radius = 0.05 }",
        press_text(0.0, 0.26));
    const double top_m = 0.01 + find_held_N(felt.record) / expect_N(1.0);
    CHECK(top_m > 0.02);
    const Played pressed = play(
        "  world:hand { cursor = 'hull', cursor_model = 'egg' }\n  world:body { name = 'roof', "
        "model = 'box', size = { 0.3, 0.1, 0.3 }, at = { 0, 0.6, 0 }, solid = true }",
        "local motion = require 'motion'\nreturn motion.play(function()\n  motion.start_at { 0, "
        "0.4, 0 }\n  motion.wait(1)\n  motion.move_to({ 0, 0.52, 0 }, 1)\n  "
        "motion.wait(2)\nend)\n");
    const double reach_m = 0.03 - find_held_N(pressed.record) / expect_N(1.0);
    CHECK(reach_m == Approx(top_m).margin(2.0e-4));
    check_says(pressed.explained, {"friction cone"});
}

TEST_CASE("choices: contacts of rigid bodies are solved by the method that is named, and rest") {
    for (const char* method : {"newton", "dantzig", "iterative"}) {
        CAPTURE(method);
        const Played played = play(
            "  world:contacts { method = '" + std::string(method) +
                "' }\n  world:hand {}\n  for i = 1, 3 do\n    world:body { name = 'block_' .. i, "
                "model = 'box', size = { 0.1, 0.1, 0.1 }, mass = 0.2, at = { 0, 0.1 * i - 0.05, 0 "
                "}, rigid = true }\n  end",
            press_text(0.3, 0.4));
        check_says(played.explained, {std::string("solved by ") + method, "lesson.lua:3"});
        for (const RecordBody& body : played.record.bodies) {
            const double rest_m = 0.1 * (body.body + 1) - 0.05;
            CHECK(std::abs(body.state.pose_W.position.y() - rest_m) < 2.0e-4);
        }
    }
}

TEST_CASE("choices: linearised contacts hold a tool as planes do where it rests") {
    const auto held_N = [](const std::string& model) {
        const Played played = play(
            "  world:hand { tool = { shape = 'ball', radius = 0.02, method = "
            "'implicit_penalty'" +
                model + " } }\n" + floor_text(),
            press_text(0.0, 0.31));
        check_says(played.explained, {"soft, massive"});
        return find_held_N(played.record);
    };
    const double planes_N = held_N("");
    CHECK(planes_N == Approx(expect_N(0.01)).epsilon(0.05));
    CHECK(held_N(", contact_model = 'linearised'") == Approx(planes_N).epsilon(0.05));
}
