#include "runtime/scene/check_tool.h"

#include "haptics/collision/collision_mesh.h"
#include "haptics/geometry/shape.h"
#include "runtime/scene/plan.h"

#include <catch2/catch.hpp>

#include <memory>
#include <regex>
#include <string>
#include <vector>

using namespace fulcrum;
using namespace fulcrum::runtime;

namespace {

LessonDescription make_lesson(Integrator integrator) {
    LessonDescription lesson;
    lesson.title = lesson.id = "tool";
    BodyDescription body;
    body.name = body.noun = body.model = "block";
    body.solid = true;
    lesson.bodies.push_back(body);
    lesson.hand.tool = ToolDescription{};
    lesson.hand.tool->integrator = integrator;
    lesson.hand.tool->voxel_m = 0.002;
    lesson.hand.line = 7;
    return lesson;
}

Expected<std::shared_ptr<const CollisionMesh>> load_block(const BodyDescription& /*body*/) {
    return make_box({0.1, 0.02, 0.1}).and_then([](const TriangleMesh& mesh) {
        return CollisionMesh::create(mesh);
    });
}

// What is said of it; empty where it is taken.
std::string refusal(const LessonDescription& lesson) {
    const auto plan = compile_plan(lesson, {}, load_block);
    return plan ? "" : to_sentence(plan.error());
}

// The number that follows `words`; 0 where they aren't said.
double number_after(const std::string& sentence, const std::string& words) {
    std::smatch found;
    return std::regex_search(sentence, found, std::regex(words + " ([0-9.e-]+)"))
               ? std::stod(found[1])
               : 0.0;
}

}  // namespace

TEST_CASE("check tool: the default, and a tool without mass by any integrator, are taken") {
    CHECK(refusal(make_lesson(Integrator::backward_euler)).empty());
    for (const Integrator integrator : kIntegrators) {
        LessonDescription lesson = make_lesson(integrator);
        lesson.hand.tool->massless = true;
        CHECK(refusal(lesson).empty());
    }
}

TEST_CASE(
    "check tool: an integrator that shakes the tool is refused, and what the sentence says does") {
    for (const double scale : {1.0, 5.0}) {
        for (const Integrator integrator :
             {Integrator::semi_implicit_euler, Integrator::verlet, Integrator::runge_kutta_4}) {
            LessonDescription lesson = make_lesson(integrator);
            lesson.hand.scale = scale;
            lesson.hand.tool->points = 1500;
            const std::string told = refusal(lesson);
            CAPTURE(told);
            CHECK(told.find("lesson.lua:7: the tool: with 0.02 kg on 500 N/m, 1500 points and 1000 "
                            "steps a second " +
                            std::string(to_string(integrator)) + " shakes it") == 0);
            CHECK(told.find("backward_euler holds it") != std::string::npos);
            lesson.hand.tool->mass_kg = number_after(told, "a mass of at least");
            REQUIRE(lesson.hand.tool->mass_kg > 0.02);
            CHECK(refusal(lesson).empty());
            lesson.hand.tool->mass_kg *= 0.9;
            CHECK_FALSE(refusal(lesson).empty());
        }
    }
}

TEST_CASE(
    "check tool: where no mass is enough it says which spring does beside the largest, or that "
    "none does") {
    // A ball touches with few points, and explicit Euler wants a stiff damper.
    LessonDescription lesson = make_lesson(Integrator::explicit_euler);
    lesson.hand.tool->shape = SphereShape{0.02};
    lesson.hand.tool->points = 200;
    lesson.hand.tool->stiffness_N_per_m = 50.0;
    const std::string told = refusal(lesson);
    CAPTURE(told);
    lesson.hand.tool->mass_kg = number_after(told, "a mass of");
    lesson.hand.tool->stiffness_N_per_m = number_after(told, "a stiffness of");
    CHECK(lesson.hand.tool->mass_kg == 1.0);
    REQUIRE(lesson.hand.tool->stiffness_N_per_m > 50.0);
    CHECK(refusal(lesson).empty());
    // A flat face with many points is too stiff for it whatever hangs on it; a turn that was chosen is left as it is.
    for (const double turn : {0.0, 0.5}) {
        LessonDescription flat = make_lesson(Integrator::explicit_euler);
        flat.hand.tool->turn_stiffness_Nm_per_rad = turn;
        CHECK(refusal(flat).find("shakes it; leave out integrator: backward_euler holds it") !=
              std::string::npos);
    }
}

TEST_CASE("check tool: a faster loop holds a lighter tool") {
    LessonDescription lesson = make_lesson(Integrator::semi_implicit_euler);
    lesson.hand.tool->points = 5000;
    const double at_1_kHz = number_after(refusal(lesson), "a mass of at least");
    lesson.hand.rate_hz = 2000.0;
    const double at_2_kHz = number_after(refusal(lesson), "a mass of at least");
    CHECK(at_2_kHz > 0.0);
    CHECK(at_2_kHz < 0.4 * at_1_kHz);
}

TEST_CASE(
    "check tool: more points among voxels than a step has time for are refused, and as many as are "
    "said are taken") {
    for (const double rate_hz : {1000.0, 4000.0}) {
        LessonDescription lesson = make_lesson(Integrator::backward_euler);
        lesson.hand.rate_hz = rate_hz;
        lesson.hand.tool->method = ToolMethod::voxel_sampling;
        lesson.hand.tool->points = 200'000;
        const std::string told = refusal(lesson);
        CAPTURE(told);
        CHECK(told.find("lesson.lua:7: the tool: 200000 points among voxels take 5 ms of each step "
                        "of ") == 0);
        CHECK(told.find("method = \"field_sampling\"") != std::string::npos);
        const auto most = static_cast<int>(number_after(told, "at most"));
        CHECK(most == 20'000'000 / static_cast<int>(rate_hz));
        lesson.hand.tool->points = most + 1;
        CHECK_FALSE(refusal(lesson).empty());
        lesson.hand.tool->points = most;
        CHECK(refusal(lesson).empty());
        lesson.hand.tool->points = most + 1;
        lesson.hand.tool->method = ToolMethod::field_sampling;
        CHECK(refusal(lesson).empty());
    }
}

TEST_CASE(
    "check tool: a tool in fields that may take longer than its time is told, with what would do") {
    const auto notices = [](int n_points, double rate_hz, ToolMethod method) {
        LessonDescription lesson = make_lesson(Integrator::backward_euler);
        lesson.hand.tool->points = n_points;
        lesson.hand.tool->method = method;
        lesson.hand.rate_hz = rate_hz;
        return compile_plan(lesson, {}, load_block).value().notices;
    };
    const std::vector<std::string> told = notices(20000, 1000.0, ToolMethod::field_sampling);
    REQUIRE(told.size() == 1);
    CHECK(told[0].find("lesson.lua:7: the tool: where all of its 20000 points touch") == 0);
    CHECK(told[0].find("a step has 0.5 ms") != std::string::npos);
    const double n_most = number_after(told[0], "at most");
    REQUIRE(n_most > 1000.0);
    CHECK(notices(static_cast<int>(n_most), 1000.0, ToolMethod::field_sampling).empty());
    CHECK(notices(static_cast<int>(n_most) + 100, 1000.0, ToolMethod::field_sampling).size() == 1);
    CHECK(notices(static_cast<int>(n_most), 4000.0, ToolMethod::field_sampling).size() == 1);
    CHECK(notices(2000, 1000.0, ToolMethod::voxel_sampling).empty());
}

TEST_CASE("check tool: that there are too many points is told before anything is made") {
    LessonDescription lesson = make_lesson(Integrator::backward_euler);
    lesson.hand.tool->method = ToolMethod::voxel_sampling;
    lesson.hand.tool->points = 200'000;
    bool is_begun = false;
    PlanOptions options;
    options.progress = [&](double /*share*/, std::string_view /*what*/) {
        is_begun = true;
        return true;
    };
    const auto refused = compile_plan(lesson, options, load_block);
    REQUIRE_FALSE(refused);
    CHECK(to_sentence(refused.error()).find("200000 points among voxels") != std::string::npos);
    CHECK_FALSE(is_begun);
}
