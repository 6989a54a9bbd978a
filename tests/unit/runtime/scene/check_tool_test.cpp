#include "runtime/scene/check_tool.h"

#include "tests/unit/runtime/scene/plan_scene.h"

using namespace fulcrum::runtime::test;

namespace {

// A block of 10 x 2 x 10 cm, met by a cylinder with this integrator.
const SolidLoader kBlock = load_as({0.1, 0.02, 0.1});

LessonDescription with_integrator(Integrator integrator) {
    LessonDescription lesson = make_lesson();
    lesson.hand.tool->integrator = integrator;
    lesson.hand.tool->voxel_m = 0.002;
    return lesson;
}

std::string refused(const LessonDescription& lesson) {
    return refusal(lesson, kBlock);
}

}  // namespace

TEST_CASE("check tool: the default, and a tool without mass by any integrator, are taken") {
    CHECK(refused(with_integrator(Integrator::backward_euler)).empty());
    for (const Integrator integrator : kIntegrators) {
        LessonDescription lesson = with_integrator(integrator);
        lesson.hand.tool->massless = true;
        CHECK(refused(lesson).empty());
    }
}

TEST_CASE("check tool: an integrator that shakes the tool is refused; what it is told does") {
    for (const double scale : {1.0, 5.0}) {
        for (const Integrator integrator :
             {Integrator::semi_implicit_euler, Integrator::verlet, Integrator::runge_kutta_4}) {
            LessonDescription lesson = with_integrator(integrator);
            lesson.hand.scale = scale;
            lesson.hand.tool->points = 1500;
            const std::string told = refused(lesson);
            CAPTURE(told);
            CHECK(told.find("lesson.lua:7: the tool: with 0.02 kg on 500 N/m, 1500 points and 1000 "
                            "steps a second " +
                            std::string(to_string(integrator)) + " shakes it") == 0);
            check_says(told, {"backward_euler holds it"});
            lesson.hand.tool->mass_kg = number_after(told, "a mass of at least ");
            REQUIRE(lesson.hand.tool->mass_kg > 0.02);
            CHECK(refused(lesson).empty());
            lesson.hand.tool->mass_kg *= 0.9;
            CHECK_FALSE(refused(lesson).empty());
        }
    }
}

TEST_CASE("check tool: where no mass is enough it says which spring does, or that none does") {
    // A ball touches with few points, and explicit Euler wants a stiff damper.
    LessonDescription lesson = with_integrator(Integrator::explicit_euler);
    lesson.hand.tool->shape = SphereShape{0.02};
    lesson.hand.tool->points = 200;
    lesson.hand.tool->stiffness_N_per_m = 50.0;
    const std::string told = refused(lesson);
    CAPTURE(told);
    lesson.hand.tool->mass_kg = number_after(told, "a mass of ");
    lesson.hand.tool->stiffness_N_per_m = number_after(told, "a stiffness of ");
    CHECK(lesson.hand.tool->mass_kg == 1.0);
    REQUIRE(lesson.hand.tool->stiffness_N_per_m > 50.0);
    CHECK(refused(lesson).empty());
    // A flat face with many points is too stiff for it whatever hangs on it; a turn that was chosen is left as it is.
    for (const double turn : {0.0, 0.5}) {
        LessonDescription flat = with_integrator(Integrator::explicit_euler);
        flat.hand.tool->turn_stiffness_Nm_per_rad = turn;
        check_says(refused(flat), {"shakes it; leave out integrator: backward_euler holds it"});
    }
}

TEST_CASE("check tool: a faster loop holds a lighter tool") {
    LessonDescription lesson = with_integrator(Integrator::semi_implicit_euler);
    lesson.hand.tool->points = 5000;
    const double at_1_kHz = number_after(refused(lesson), "a mass of at least ");
    lesson.hand.rate_hz = 2000.0;
    const double at_2_kHz = number_after(refused(lesson), "a mass of at least ");
    CHECK(at_2_kHz > 0.0);
    CHECK(at_2_kHz < 0.4 * at_1_kHz);
}

TEST_CASE("check tool: more points among voxels than a step has time for are refused") {
    for (const double rate_hz : {1000.0, 4000.0}) {
        LessonDescription lesson = with_integrator(Integrator::backward_euler);
        lesson.hand.rate_hz = rate_hz;
        lesson.hand.tool->method = ToolMethod::voxel_sampling;
        lesson.hand.tool->points = 200'000;
        const std::string told = refused(lesson);
        CAPTURE(told);
        CHECK(told.find("lesson.lua:7: the tool: 200000 points among voxels take 5 ms of each step "
                        "of ") == 0);
        check_says(told, {"method = \"field_sampling\""});
        const auto most = static_cast<int>(number_after(told, "at most "));
        CHECK(most == 20'000'000 / static_cast<int>(rate_hz));
        lesson.hand.tool->points = most + 1;
        CHECK_FALSE(refused(lesson).empty());
        lesson.hand.tool->points = most;
        CHECK(refused(lesson).empty());
        lesson.hand.tool->points = most + 1;
        lesson.hand.tool->method = ToolMethod::field_sampling;
        CHECK(refused(lesson).empty());
    }
}

TEST_CASE("check tool: a tool in fields that may take too long is told, with what would do") {
    const auto notices = [](int n_points, double rate_hz, ToolMethod method) {
        LessonDescription lesson = with_integrator(Integrator::backward_euler);
        lesson.hand.tool->points = n_points;
        lesson.hand.tool->method = method;
        lesson.hand.rate_hz = rate_hz;
        return compile_plan(lesson, {}, kBlock).value().notices;
    };
    const std::vector<std::string> told = notices(20000, 1000.0, ToolMethod::field_sampling);
    REQUIRE(told.size() == 1);
    CHECK(told[0].find("lesson.lua:7: the tool: where all of its 20000 points touch") == 0);
    check_says(told[0], {"a step has 0.5 ms"});
    const double n_most = number_after(told[0], "at most ");
    REQUIRE(n_most > 1000.0);
    CHECK(notices(static_cast<int>(n_most), 1000.0, ToolMethod::field_sampling).empty());
    CHECK(notices(static_cast<int>(n_most) + 100, 1000.0, ToolMethod::field_sampling).size() == 1);
    CHECK(notices(static_cast<int>(n_most), 4000.0, ToolMethod::field_sampling).size() == 1);
    CHECK(notices(2000, 1000.0, ToolMethod::voxel_sampling).empty());
}

TEST_CASE("check tool: that there are too many points is told before anything is made") {
    LessonDescription lesson = with_integrator(Integrator::backward_euler);
    lesson.hand.tool->method = ToolMethod::voxel_sampling;
    lesson.hand.tool->points = 200'000;
    bool is_begun = false;
    PlanOptions options;
    options.progress = [&](double /*share*/, std::string_view /*what*/) {
        is_begun = true;
        return true;
    };
    check_says(refusal_of(compile_plan(lesson, options, kBlock)), {"200000 points among voxels"});
    CHECK_FALSE(is_begun);
}
