#include "runtime/effect/tool/plan_tool.h"

#include "haptics/loop/haptic_loop.h"
#include "haptics/tool/tool_plan.h"
#include "runtime/files/shape_cache.h"
#include "runtime/scene/explain.h"
#include "tests/unit/runtime/scene/plan_scene.h"

#include <nlohmann/json.hpp>

using namespace fulcrum::runtime::test;

TEST_CASE("plan: a tool in the hand is a stage of its own, instead of the proxy's") {
    for (const ToolMethod method :
         {ToolMethod::field_sampling, ToolMethod::voxel_sampling, ToolMethod::implicit_penalty}) {
        LessonDescription lesson = make_lesson();
        lesson.hand.tool->method = method;
        const auto plan = plan_of(lesson);
        CHECK(plan.haptic.tool->penalty.has_value() == (method == ToolMethod::implicit_penalty));
        CHECK(validate(plan.haptic));
        CHECK(plan.has("haptic", "tool"));
        CHECK_FALSE(plan.has("haptic", "proxy"));
        CHECK_FALSE(plan.has("haptic", "forces: coupling"));
        REQUIRE(plan.haptic.tool);
        CHECK(plan.haptic.tool->n_objects() == 1);
        const std::string text = explain(lesson, plan);
        check_says(text, {"a cylinder meets bodies", "lesson.lua:7"});
        const bool in_rows = method == ToolMethod::voxel_sampling;
        CHECK((text.find(" 2000 points, backward Euler, 500 N/m") != std::string::npos) != in_rows);
        check_says(text, {"block            4", name_of(method)});
        // The same for programs.
        const auto tool = nlohmann::json::parse(explain_json(lesson, plan, nullptr)).at("tool");
        CHECK(tool["name"] == "cylinder");
        CHECK(tool["method"] == name_of(method));
        CHECK((tool["points"] == 2000) != in_rows);
        REQUIRE(tool["bodies"].size() == 1);
        CHECK(tool["bodies"][0]["name"] == lesson.bodies[0].name);
        CHECK(tool["source"] == "made");
        CHECK(tool["bodies"][0]["source"] == "made");
        CHECK(tool["bodies"][0]["memory_bytes"] > 100'000);
        const double voxel_m = tool["bodies"][0]["voxel_m"];
        CHECK(tool["bodies"][0]["voxels"][0].get<double>() * voxel_m > 0.4);
    }
}

TEST_CASE("plan: a god-object's tool meets the triangles of bodies, and turns on the same spring") {
    LessonDescription lesson = make_lesson();
    lesson.hand.tool->method = ToolMethod::god_object;
    const auto plan = plan_of(lesson);
    REQUIRE(plan.haptic.tool);
    CHECK(validate(plan.haptic));
    const auto& objects = std::get<std::vector<GodObjectPlan>>(plan.haptic.tool->objects);
    REQUIRE(objects.size() == 1);
    CHECK(objects[0].object->swept().n_triangles() == 12);
    const GodObjectSettings settings = make_god_object_settings(*plan.haptic.tool);
    const ToolCouplingSettings& coupling = plan.haptic.tool->settings.coupling;
    CHECK(settings.coupling.shift.stiffness_N_per_m * settings.inertia.moments_kg_m2.y() /
              settings.inertia.mass_kg ==
          Approx(coupling.turn.stiffness_Nm_per_rad));
    const std::string text = explain(lesson, plan);
    check_says(text, {"god_object, ", "12 triangles"});
    check_lacks(text, {"backward Euler"});
    const auto tool = nlohmann::json::parse(explain_json(lesson, plan, nullptr)).at("tool");
    CHECK(tool["method"] == "god_object");
    CHECK(tool["bodies"][0]["triangles"] == 12);
}

TEST_CASE("plan: without a tool nothing of it is there") {
    LessonDescription lesson = make_lesson();
    lesson.hand.tool.reset();
    const auto plan = plan_of(lesson);
    CHECK(plan.haptic.tool == nullptr);
    CHECK_FALSE(plan.has("haptic", "tool"));
    CHECK(plan.has("haptic", "proxy"));
    for (const char* words : {"The tool in the hand", "voxel"}) {
        check_lacks(explain(lesson, plan), {words});
        check_lacks(explain_json(lesson, plan, nullptr), {"\"tool\":"});
    }
}

TEST_CASE("plan: a tool's mass and springs are as the hand feels them, at every scale") {
    for (const double scale : {1.0, 4.0}) {
        LessonDescription lesson = make_lesson();
        lesson.hand.scale = scale;
        lesson.hand.tool->mass_kg = 0.04;
        lesson.hand.tool->stiffness_N_per_m = 300.0;
        lesson.hand.tool->turn_stiffness_Nm_per_rad = 0.2;
        const auto plan = plan_of(lesson);
        const VoxelToolSettings& settings = plan.haptic.tool->settings;
        CHECK(settings.inertia.mass_kg == Approx(0.04 / scale));
        CHECK(settings.coupling.shift.stiffness_N_per_m == Approx(300.0 / scale));
        CHECK(settings.coupling.turn.stiffness_Nm_per_rad == Approx(0.2 * scale));
        // A cylinder of 4 x 10 cm: m r^2 / 2 about its axis.
        CHECK(settings.inertia.moments_kg_m2.minCoeff() ==
              Approx(0.5 * 0.04 / scale * 0.02 * 0.02).epsilon(0.01));
    }
}

TEST_CASE("plan: a turn without a stiffness of its own has its far end as stiff as the spring") {
    const auto plan = plan_of(make_lesson());
    const double reach_m = std::hypot(0.02, 0.05);
    CHECK(plan.haptic.tool->settings.coupling.turn.stiffness_Nm_per_rad ==
          Approx(500.0 * reach_m * reach_m).epsilon(0.03));
}

TEST_CASE("plan: each shape is a tool, and a model too") {
    for (const CursorShape& shape :
         {CursorShape{SphereShape{0.02}}, CursorShape{BoxShape{Vector3(0.01, 0.03, 0.02)}},
          CursorShape{CapsuleShape{0.01, 0.03}}, CursorShape{CylinderShape{0.01, 0.03}}}) {
        LessonDescription lesson = make_lesson();
        lesson.hand.tool->shape = shape;
        CHECK(refusal(lesson) == "");
    }
    LessonDescription lesson = make_lesson();
    lesson.hand.tool->shape = std::monostate{};
    lesson.hand.tool->model = "stick";
    const auto plan = plan_of(lesson);
    CHECK(name_of(*lesson.hand.tool) == "stick");
    // It is held upright, as its model stands, whatever its principal axes are.
    const VoxelToolSettings& settings = plan.haptic.tool->settings;
    CHECK(settings.grip_T.norm() < 1e-9);
    const Vector3 thin = settings.handle_turn * Vector3::UnitX();
    CHECK(std::abs(thin.y()) == Approx(1.0));
}

TEST_CASE("plan: a tool that is a ball or a box by its model is felt as large as its shape says") {
    const auto reach_of = [](const char* model, const CursorShape& shape) {
        LessonDescription lesson = make_lesson();
        lesson.hand.tool->model = model;
        lesson.hand.tool->shape = shape;
        const auto plan = plan_of(lesson);
        const auto& objects = std::get<std::vector<FieldSamplingPlan>>(plan.haptic.tool->objects);
        return objects.front().shell->reach_m();
    };
    CHECK(reach_of("sphere", SphereShape{0.03}) == Approx(0.03).epsilon(0.01));
    CHECK(reach_of("earth", SphereShape{0.07}) == Approx(0.07).epsilon(0.01));
    CHECK(reach_of("box", BoxShape{Vector3::Constant(0.02)}) ==
          Approx(0.02 * std::sqrt(3.0)).epsilon(0.05));
}

TEST_CASE("plan: what a tool meets is made once and then read, and people are told which") {
    for (const ToolMethod method : {ToolMethod::field_sampling, ToolMethod::voxel_sampling}) {
        const ScratchFolder scratch;
        LessonDescription lesson = make_lesson();
        lesson.hand.tool->method = method;
        lesson.hand.tool->shape = std::monostate{};
        lesson.hand.tool->model = "stick";
        const auto compile_with = [&](ShapeCache& shapes) {
            return compile_plan(lesson, {.shapes = &shapes}, load_block);
        };
        ShapeCache first({.folder = scratch.path() / "shapes", .least_build_s = 0.0});
        const auto made = value_of(compile_with(first));
        CHECK(made.tool_shapes == std::vector{ShapeSource::made, ShapeSource::made});
        check_says(explain(lesson, made), {"points made now", "B, made now\n"});
        CHECK(first.counts().n_kept == 3);  // the body, the tool's points and what it encloses
        ShapeCache second({.folder = scratch.path() / "shapes", .least_build_s = 0.0});
        const auto read = value_of(compile_with(second));
        CHECK(read.tool_shapes == std::vector{ShapeSource::cache, ShapeSource::cache});
        check_says(explain(lesson, read), {"points from the cache", "B, from the cache\n"});
        CHECK(second.counts().n_read == 3);
        const auto json = nlohmann::json::parse(explain_json(lesson, read, nullptr)).at("tool");
        CHECK(json["source"] == "cache");
        CHECK(json["bodies"][0]["source"] == "cache");
        CHECK(second.counts().n_made == 0);
        CHECK(second.told().empty());
        // Without one all is made, and the same.
        const auto without = plan_of(lesson);
        CHECK(without.tool_shapes == made.tool_shapes);
        CHECK(validate(read.haptic));
        CHECK(without.haptic.tool->settings.inertia.moments_kg_m2 ==
              read.haptic.tool->settings.inertia.moments_kg_m2);
        // What is damaged is told, once each, and made again.
        for (const auto& entry : std::filesystem::directory_iterator(scratch.path() / "shapes")) {
            std::filesystem::resize_file(entry.path(), 100);
        }
        ShapeCache third({.folder = scratch.path() / "shapes", .least_build_s = 0.0});
        const auto again = value_of(compile_with(third));
        CHECK(again.tool_shapes == made.tool_shapes);
        CHECK(third.told().size() == 3);
    }
}

TEST_CASE("plan: how far a tool's bodies have come is told, and they can be stopped") {
    LessonDescription lesson = make_lesson();
    lesson.bodies.push_back(lesson.bodies.front());
    lesson.bodies.back().name = lesson.bodies.back().noun = "wall";
    lesson.hand.tool->voxel_m = 0.002;
    std::vector<std::pair<double, std::string>> told;
    PlanOptions options;
    options.progress = [&](double share, std::string_view what) {
        told.emplace_back(share, what);
        return true;
    };
    REQUIRE(compile_plan(lesson, options, load_block));
    REQUIRE(told.size() >= 3);
    CHECK(std::is_sorted(told.begin(), told.end(),
                         [](const auto& a, const auto& b) { return a.first < b.first; }));
    // The tool's mass and points first.
    CHECK(told.front().second == "the cylinder");
    CHECK(told.front().first < 1.0 / 3.0);
    CHECK(std::count_if(told.begin(), told.end(),
                        [](const auto& each) { return each.second == "block"; }) > 0);
    CHECK(told.back().second == "wall");
    CHECK(told.back().first > 0.5);
    CHECK(told.back().first <= 1.0);
    for (const char* at : {"the cylinder", "block", "wall"}) {
        options.progress = [&](double /*share*/, std::string_view what) { return what != at; };
        check_says(refusal_of(compile_plan(lesson, options, load_block)), {"stopped before"});
    }
}

TEST_CASE("plan: who has a body with holes met by a tool's field is told what they lead to") {
    const LessonDescription lesson = make_lesson();
    CHECK(plan_of(lesson).notices.empty());
    const auto load_open = [](const BodyDescription& /*body*/) {
        const TriangleMesh block = make_box(Vector3(0.4, 0.04, 0.1)).value();
        std::vector<TriangleCorners> triangles = block.triangles();
        triangles.pop_back();
        return TriangleMesh::build(block.vertices_B(), triangles)
            .and_then([](const TriangleMesh& mesh) { return CollisionMesh::create(mesh); });
    };
    const auto plan = plan_of(lesson, load_open);
    REQUIRE(plan.notices.size() == 1);
    CHECK(plan.notices.front().find("lesson.lua:4: the block: the mesh has 3 open edges") == 0);
    LessonDescription voxels = lesson;
    voxels.hand.tool->method = ToolMethod::voxel_sampling;
    CHECK(compile_plan(voxels, {}, load_open)->notices.empty());
}

TEST_CASE("plan: a tool feels an open mesh with nothing in it as a sheet, from both sides") {
    const auto load_leaf = [](const BodyDescription& /*body*/) {
        return TriangleMesh::build(
                   {{-0.2, 0.0, -0.1}, {0.2, 0.0, -0.1}, {0.2, 0.0, 0.1}, {-0.2, 0.0, 0.1}},
                   {{0, 1, 2}, {0, 2, 3}})
            .and_then([](const TriangleMesh& mesh) { return CollisionMesh::create(mesh); });
    };
    const auto plan = plan_of(make_lesson(), load_leaf);
    REQUIRE(plan.notices.size() == 1);
    CAPTURE(plan.notices.front());
    CHECK(plan.notices.front().find("lesson.lua:4: the block: its mesh is open and encloses "
                                    "nothing, so a tool feels it as a sheet") == 0);
    REQUIRE(plan.haptic.tool);
    const std::unique_ptr<ToolSolver> tool = make_tool(*plan.haptic.tool);
    const auto is_free_at = [&](double y_m) {
        tool->place(Pose::at({0.0, y_m, 0.0}));
        return tool->is_free(std::vector<MovingFrame>(plan.haptic.solids.size()));
    };
    // The cylinder's ends are 5 cm from its middle.
    for (const double side : {1.0, -1.0}) {
        CHECK_FALSE(is_free_at(side * 0.05));
        CHECK(is_free_at(side * 0.052));
    }
}

TEST_CASE("plan: mistakes with a tool get one sentence and a line") {
    LessonDescription lesson = make_lesson();
    lesson.bodies[0].solid = false;
    CHECK(refusal(lesson).find("lesson.lua:7: the hand has a tool, and no body is solid") == 0);
    lesson = make_lesson();
    lesson.hand.tool->voxel_m = 0.0005;
    CHECK(refusal(lesson).find("lesson.lua:7: voxels of 0.5 mm are too small for the block") == 0);
    lesson = make_lesson();
    MaterialDescription wood;
    wood.felt.name = "wood";
    lesson.materials.push_back(wood);
    lesson.bodies[0].material = 0;
    CHECK(refusal(lesson).find(
              "lesson.lua:4: the block has a material, and a tool of points feels") == 0);
    lesson = make_lesson();
    lesson.bucket.present = true;
    CHECK(refusal(lesson).find("lesson.lua:7: the hand has a tool and a bucket") == 0);
    lesson = make_lesson();
    lesson.hand.tool->shape = std::monostate{};
    CHECK(refusal(lesson).find("lesson.lua:7: the tool") == 0);
    // What encloses nothing, and what is too large to be turned, before any body is made.
    const auto refused_first = [](const LessonDescription& of, const SolidLoader& load) {
        PlanOptions options;
        bool body_begun = false;
        options.progress = [&](double /*share*/, std::string_view what) {
            body_begun = body_begun || what == "block";
            return true;
        };
        const auto plan = compile_plan(of, options, load);
        CHECK_FALSE(body_begun);
        return plan ? "" : to_sentence(plan.error());
    };
    lesson = make_lesson();
    lesson.hand.tool->shape = std::monostate{};
    lesson.hand.tool->model = "paper";
    CHECK(refused_first(
              lesson,
              [](const BodyDescription& body) {
                  return body.model == "paper"
                             ? make_plate(0.1, 0.1, 4).and_then([](const TriangleMesh& mesh) {
                                   return CollisionMesh::create(mesh);
                               })
                             : load_block(body);
              }) ==
          "lesson.lua:7: the tool: the mesh encloses nothing, so it has no mass; close its holes, "
          "or give the tool a shape.");
    lesson = make_lesson();
    lesson.hand.tool->shape = BoxShape{Vector3::Constant(1.0)};
    check_says(refused_first(lesson, load_block), {"give it a turn_stiffness of at most 10"});
}

TEST_CASE("plan: a tool has half of each step in a live run, else as long as it takes") {
    for (const double rate_hz : {1000.0, 4000.0}) {
        for (const ToolMethod method : {ToolMethod::field_sampling, ToolMethod::voxel_sampling}) {
            LessonDescription lesson = make_lesson();
            lesson.hand.rate_hz = rate_hz;
            lesson.hand.tool->method = method;
            lesson.hand.tool->points = 1000;
            const auto live = plan_of(lesson, load_block, {.live = true});
            CHECK(live.haptic.tool->settings.budget_us == Approx(0.5e6 / rate_hz));
            CHECK(live.haptic.tool->settings.clock == BudgetClock::measured);
            CHECK(plan_of(lesson).haptic.tool->settings.budget_us == 0.0);
            CHECK(validate(live.haptic));
            const auto json = nlohmann::json::parse(explain_json(lesson, live, nullptr));
            CHECK(json.at("tool").at("live_time_us") == 0.5e6 / rate_hz);
        }
    }
}
