#include "runtime/effect/tool/check_tool.h"
#include "runtime/effect/tool/tool_bodies.h"
#include "runtime/effect/tool/tool_body_list.h"
#include "runtime/effect/tool/tool_notices.h"
#include "runtime/files/shape_cache.h"
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

std::shared_ptr<const CollisionMesh> make_cube(double side_m) {
    return touchable(make_box(Vector3::Constant(side_m)));
}

struct Scene {
    LessonDescription lesson;
    std::vector<SolidPlan> solids;

    explicit Scene(double voxel_m = 0.0) {
        lesson.hand.tool = ToolDescription{};
        lesson.hand.tool->voxel_m = voxel_m;
        lesson.hand.line = 9;
    }
    void add(const std::shared_ptr<const CollisionMesh>& mesh) {
        solids.push_back({static_cast<std::int32_t>(solids.size()), mesh, Pose{}});
        lesson.bodies.push_back(make_solid("cube" + std::to_string(solids.size()),
                                           static_cast<SourceLine>(solids.size() + 1)));
    }
    [[nodiscard]] Expected<ToolBodyList> list() const { return list_tool_bodies(lesson, solids); }
};

// With 24 voxels of margin, as all are counted.
double count_voxels(const ToolBodyList& list) {
    double n = 0.0;
    for (const ToolBodyList::Mesh& each : list.meshes) {
        const Vector3 size_m = each.mesh.upper_B() - each.mesh.lower_B();
        n += (size_m / each.voxel_m + Vector3::Constant(24.0)).prod();
    }
    return n;
}

// A block of 40 x 20 x 40 cm, as thick as is asked for, and a ball of 1 cm in the hand, 30 cm up.
LessonDescription make_scene(ToolMethod method) {
    LessonDescription lesson = make_lesson();
    lesson.hand.tool->shape = SphereShape{0.01};
    lesson.hand.tool->method = method;
    return lesson;
}

std::vector<std::string> notices_of(const LessonDescription& lesson, const Vector3& size_m) {
    return plan_of(lesson, load_as(size_m)).notices;
}

constexpr ToolMethod kMethods[]{ToolMethod::field_sampling, ToolMethod::voxel_sampling,
                                ToolMethod::implicit_penalty};

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

TEST_CASE("tool bodies: as many as a lesson may have share the voxels that there are") {
    Scene scene;
    double alone_m = 0.0;
    double last_m = 0.0;
    for (int n = 1; n <= 16; ++n) {
        scene.add(make_cube(0.1));
        const auto list = value_of(scene.list());
        REQUIRE(list.meshes.size() == static_cast<std::size_t>(n));
        CHECK(count_voxels(list) <= (1.0 + 1.0e-9) * kMostVoxels);  // by rounding
        for (const ToolBodyList::Mesh& each : list.meshes) {
            CHECK(each.voxel_m == list.meshes.front().voxel_m);
        }
        CHECK(list.meshes.front().voxel_m >= last_m);
        last_m = list.meshes.front().voxel_m;
        alone_m = n == 1 ? last_m : alone_m;
    }
    // A few are as fine as one; sixteen not much coarser, and the share is used.
    CHECK(alone_m == Approx(0.1 / std::cbrt(4.0e6)));
    CHECK(last_m > 1.05 * alone_m);
    CHECK(last_m < 1.5 * alone_m);
    CHECK(count_voxels(*scene.list()) > 0.99 * kMostVoxels);
}

TEST_CASE("tool bodies: bodies of one mesh are made once") {
    for (const ToolMethod method : {ToolMethod::field_sampling, ToolMethod::voxel_sampling}) {
        Scene scene(0.004);
        scene.lesson.hand.tool->method = method;
        const auto shared = make_cube(0.1);
        scene.add(shared);
        scene.add(make_cube(0.2));
        scene.add(shared);
        const auto list = value_of(scene.list());
        CHECK(list.mesh_of == std::vector<std::size_t>{0, 1, 0});
        ShapeCache none{{}};
        std::vector<std::string> told;
        const auto bodies = value_of(make_tool_bodies(
            scene.lesson, list, 1.0e-3,
            [&](double /*share*/, std::string_view what) {
                told.emplace_back(what);
                return true;
            },
            none));
        CHECK(none.counts().n_made == 2);
        CHECK(bodies.sources == std::vector<ShapeSource>(3, ShapeSource::made));
        CHECK(std::count(told.begin(), told.end(), "cube3") == 0);
        if (method == ToolMethod::field_sampling) {
            REQUIRE(bodies.fields.size() == 3);
            CHECK(bodies.fields[0] == bodies.fields[2]);
            CHECK(bodies.fields[0] != bodies.fields[1]);
            CHECK(bodies.grids.empty());
        } else {
            REQUIRE(bodies.grids.size() == 3);
            CHECK(bodies.grids[0] == bodies.grids[2]);
            CHECK(bodies.grids[0] != bodies.grids[1]);
        }
    }
}

TEST_CASE("tool bodies: voxels too small or too many are refused with those that would do") {
    const auto would_do = [](const Scene& scene, const std::string& begins) {
        const std::string text = refusal_of(scene.list());
        INFO(text);
        CHECK(text.find("lesson.lua:9: " + begins) == 0);
        const std::string advice = "leave out the tool's voxel, or make it ";
        const std::size_t at = text.find(advice);
        REQUIRE(at != std::string::npos);
        Scene coarser = scene;
        coarser.lesson.hand.tool->voxel_m = std::stod(text.substr(at + advice.size()));
        CHECK(coarser.list().has_value());
        coarser.lesson.hand.tool->voxel_m *= 0.85;
        CHECK_FALSE(coarser.list().has_value());
        coarser.lesson.hand.tool->voxel_m = 0.0;
        CHECK(coarser.list().has_value());
    };
    Scene one(0.0005);
    one.add(make_cube(0.3));
    would_do(one, "voxels of 0.5 mm are too small for the cube1 that the tool meets: at most 480");
    Scene many(0.001);
    for (int i = 0; i < 12; ++i) {
        many.add(make_cube(0.2));
    }
    would_do(many,
             "voxels of 1 mm are too many for what the tool meets: 135 million, and at most 64");
}

TEST_CASE("tool bodies: a material is refused at its body's line, but by a god-object") {
    Scene scene;
    scene.add(make_cube(0.1));
    scene.add(make_cube(0.2));
    scene.lesson.bodies[1].material = 0;
    CHECK(
        refusal_of(scene.list()) ==
        "lesson.lua:3: the cube2 has a material, and a tool of points feels its shape alone; leave "
        "out the material, or give the tool method = \"god_object\", which feels friction and "
        "texture.");
    scene.lesson.hand.tool->method = ToolMethod::god_object;
    CHECK(scene.list());
}

TEST_CASE("tool notices: a wall thinner than two voxels is told, with the voxel that does") {
    for (const ToolMethod method : kMethods) {
        LessonDescription lesson = make_scene(method);
        lesson.hand.tool->voxel_m = 0.004;
        CHECK(notices_of(lesson, {0.4, 0.02, 0.4}).empty());
        const auto told = notices_of(lesson, {0.4, 0.003, 0.4});
        REQUIRE(told.size() == 1);
        CAPTURE(told[0]);
        CHECK(told[0].find("lesson.lua:4: the block: it has walls of 3 mm, and voxels of ") == 0);
        const std::string words = "give the tool a voxel of ";
        const auto at = told[0].find(words);
        REQUIRE(at != std::string::npos);
        lesson.hand.tool->voxel_m = std::stod(told[0].substr(at + words.size()));
        CHECK(lesson.hand.tool->voxel_m == Approx(0.0015));
        CHECK(notices_of(lesson, {0.4, 0.003, 0.4}).empty());
        // So thin that no voxels of that body do.
        const auto foil = notices_of(lesson, {0.4, 0.0005, 0.4});
        REQUIRE(foil.size() == 1);
        check_lacks(foil[0], {words});
        check_says(foil[0], {"m thick or more"});
    }
}

TEST_CASE("tool notices: a tool that begins inside a body is told, and one that does not is not") {
    for (const ToolMethod method : kMethods) {
        LessonDescription lesson = make_scene(method);
        const Vector3 size_m(0.4, 0.2, 0.4);
        CHECK(notices_of(lesson, size_m).empty());
        for (const double height_m : {0.0, 0.09, 0.105}) {
            lesson.hand.centre_W = {0.05, height_m, 0.0};
            const auto told = notices_of(lesson, size_m);
            REQUIRE(told.size() == 1);
            CHECK(told[0] ==
                  "lesson.lua:7: the tool begins inside the block, and nothing is felt of it until "
                  "it is outside; put the hand's centre or the block elsewhere.");
        }
        lesson.bodies[0].visible = false;  // put somewhere later
        CHECK(notices_of(lesson, size_m).empty());
    }
}
