// A tool whose contacts are found by contact levels of detail, as a plan has it.
#include "haptics/collision/collision_mesh.h"
#include "haptics/geometry/shape.h"
#include "haptics/loop/haptic_loop.h"
#include "haptics/tool/tool_plan.h"
#include "runtime/files/shape_cache.h"
#include "runtime/scene/explain.h"
#include "runtime/scene/plan_tool.h"
#include "tests/support/scratch_folder.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

using namespace fulcrum;
using namespace fulcrum::runtime;

namespace {

// A bumpy ball of 5 cm, and a block beside it.
LessonDescription make_lesson() {
    LessonDescription lesson;
    lesson.title = lesson.id = "detail";
    for (const char* name : {"ball", "block"}) {
        BodyDescription body;
        body.name = body.noun = body.model = name;
        body.solid = body.visible = true;
        body.position_W = Vector3(body.name == "ball" ? 0.0 : 0.3, 0.0, 0.0);
        body.line = 4;
        lesson.bodies.push_back(body);
    }
    lesson.hand.tool = ToolDescription{};
    lesson.hand.tool->method = ToolMethod::implicit_penalty;
    lesson.hand.tool->contact = ContactFinding::levels;
    lesson.hand.line = 7;
    return lesson;
}

Expected<std::shared_ptr<const CollisionMesh>> load(const BodyDescription& body) {
    auto mesh = body.model == "ball"   ? make_bumpy_sphere(0.05, 12, 0.05, 100.0)
                : body.model == "cage" ? make_box(Vector3(2.0, 2.0, 2.0))
                                       : make_box(Vector3(0.1, 0.04, 0.1));
    return mesh.and_then([&](TriangleMesh whole) {
        if (body.model == "leaf") {
            whole = TriangleMesh::build(whole.vertices_B(), {whole.triangles()[0]}).value();
        }
        return CollisionMesh::create(whole);
    });
}

Expected<Plan> compile(const LessonDescription& lesson, const PlanOptions& options = {}) {
    return compile_plan(lesson, options, load);
}

const std::vector<LevelContactsPlan>& objects_of(const Plan& plan) {
    return std::get<std::vector<LevelContactsPlan>>(plan.haptic.tool->objects);
}

}  // namespace

TEST_CASE("plan: contact by levels is one word, and what it is made of is told") {
    const LessonDescription lesson = make_lesson();
    const auto plan = compile(lesson);
    REQUIRE(plan);
    CHECK(validate(plan->haptic));
    REQUIRE(objects_of(*plan).size() == 2);
    const LevelContactsPlan& ball = objects_of(*plan).front();
    CHECK(ball.tool == objects_of(*plan).back().tool);
    CHECK(ball.settings.tolerance_m == Approx(kUsualDetail * ball.tool->size_m()));
    CHECK(ball.settings.budget_us == 0.0);
    // Levels look as far as clusters do: a tenth of the tool, and half of the finest voxel that fields would have.
    LessonDescription by_fields = lesson;
    by_fields.hand.tool->contact = ContactFinding::fields;
    const auto fields = compile(by_fields);
    REQUIRE(fields);
    CHECK(plan->haptic.tool->penalty->clusters.within_m ==
          Approx(fields->haptic.tool->penalty->clusters.within_m).epsilon(0.1));
    CHECK(ball.object->settings().within_m == plan->haptic.tool->penalty->clusters.within_m);
    const std::string text = explain(lesson, *plan);
    CAPTURE(text);
    const std::string levels = std::to_string(ball.object->n_levels()) + " levels, " +
                               std::to_string(ball.object->n_pieces()) + " pieces, ";
    CHECK(text.find("implicit_penalty, contact by levels: ") != std::string::npos);
    CHECK(text.find("contact is what is nearer than ") != std::string::npos);
    CHECK(text.find(levels) != std::string::npos);
    CHECK(text.find("voxels of") == std::string::npos);
    const auto json = nlohmann::json::parse(explain_json(lesson, *plan, nullptr)).at("tool");
    CHECK(json["contact"]["found_by"] == "levels");
    CHECK(json["contact"]["tolerance_m"] == ball.settings.tolerance_m);
    CHECK(json["contact"]["memory_bytes"] == ball.tool->memory_bytes());
    CHECK(json["bodies"][0]["levels"] == ball.object->n_levels());
    CHECK(json["bodies"][0]["pieces"] == ball.object->n_pieces());
    CHECK(json["bodies"][0]["memory_bytes"] == ball.object->memory_bytes());
    // By fields nothing of it is made or told.
    CHECK(explain(by_fields, *fields).find("levels") == std::string::npos);
    CHECK_FALSE(nlohmann::json::parse(explain_json(by_fields, *fields, nullptr))["tool"].contains(
        "contact"));
    CHECK(std::holds_alternative<std::vector<FieldSamplingPlan>>(fields->haptic.tool->objects));
}

TEST_CASE(
    "plan: levels are made once, read at the next start, and made anew where they are spoiled") {
    const ScratchFolder scratch;
    const auto compile_with = [&](ShapeCache& shapes, double* last_share = nullptr) {
        PlanOptions options;
        options.shapes = &shapes;
        options.progress = [last_share](double share, std::string_view /*what*/) {
            if (last_share != nullptr) {
                CHECK(share >= *last_share);
                CHECK(share <= 1.0);
                *last_share = share;
            }
            return true;
        };
        return compile(make_lesson(), options);
    };
    const ShapeCacheSettings settings{.folder = scratch.path() / "shapes", .least_build_s = 0.0};
    ShapeCache first(settings);
    double last_share = 0.0;
    const auto made = compile_with(first, &last_share);
    REQUIRE(made);
    CHECK(made->tool_shapes == std::vector<ShapeSource>(3, ShapeSource::made));
    ShapeCache second(settings);
    const auto read = compile_with(second);
    REQUIRE(read);
    CHECK(read->tool_shapes == std::vector<ShapeSource>(3, ShapeSource::cache));
    CHECK(second.told().empty());
    CHECK(second.counts().n_made == 0);
    CHECK(explain(make_lesson(), *read).find("B, from the cache") != std::string::npos);
    const auto is_same = [&](const Plan& plan) {
        const Digest key{};
        for (std::size_t i = 0; i < 2; ++i) {
            if (encode(*objects_of(plan)[i].object, key) !=
                    encode(*objects_of(*made)[i].object, key) ||
                encode(*objects_of(plan)[i].tool, key) != encode(*objects_of(*made)[i].tool, key)) {
                return false;
            }
        }
        return true;
    };
    CHECK(is_same(*read));
    // Cut off, changed, or another's under this name.
    for (const int how : {0, 1, 2}) {
        std::vector<std::filesystem::path> files;
        for (const auto& entry : std::filesystem::directory_iterator(scratch.path() / "shapes")) {
            files.push_back(entry.path());
        }
        std::ranges::sort(files);
        REQUIRE(files.size() >= 4);
        const auto other = files.back();
        for (const auto& path : files) {
            if (how == 0) {
                std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2);
            } else if (how == 1) {
                std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
                file.seekp(200);
                file.put('\x55');
            } else if (path != other) {
                std::filesystem::copy_file(other, path,
                                           std::filesystem::copy_options::overwrite_existing);
            }
        }
        ShapeCache third(settings);
        const auto again = compile_with(third);
        REQUIRE(again);
        CHECK(third.counts().n_refused >= 3);
        CHECK(third.told().size() == static_cast<std::size_t>(third.counts().n_refused));
        CHECK(is_same(*again));
    }
}

TEST_CASE("plan: whoever waits for levels may stop them") {
    PlanOptions options;
    options.progress = [](double /*share*/, std::string_view what) { return what != "ball"; };
    LessonDescription lesson = make_lesson();
    lesson.hand.tool->contact = ContactFinding::levels;
    const auto stopped = compile_plan(lesson, options, [](const BodyDescription& /*body*/) {
        return make_bumpy_sphere(0.05, 40, 0.05, 100.0).and_then([](const TriangleMesh& mesh) {
            return CollisionMesh::create(mesh);
        });
    });
    REQUIRE_FALSE(stopped);
    CHECK(to_sentence(stopped.error()).find("lesson.lua:4: the ball: ") == 0);
}

TEST_CASE(
    "plan: in a live run a thread finds contact or moves a god-object beside the steps, in no "
    "other") {
    LessonDescription lesson = make_lesson();
    const auto is_stage = [](const PlanStage& stage) { return stage.loop == "contact"; };
    const auto runs_beside = [](const Plan& plan) {
        const auto tool = make_tool(*plan.haptic.tool);
        auto* const solver = dynamic_cast<BesideSolver*>(tool.get());
        return solver != nullptr && solver->beside() != nullptr;
    };
    for (const ContactFinding contact : {ContactFinding::levels, ContactFinding::fields}) {
        lesson.hand.tool->contact = contact;
        const auto live = compile(lesson, {.live = true});
        REQUIRE(live);
        CHECK(validate(live->haptic));
        CHECK_FALSE(make_implicit_penalty_plan(*live->haptic.tool).settings.own_rounds);
        CHECK(runs_beside(*live));
        // Under a virtual clock each step does; what is listed is the same but for the reason.
        const auto quiet = compile(lesson);
        REQUIRE(quiet);
        CHECK(make_implicit_penalty_plan(*quiet->haptic.tool).settings.own_rounds);
        CHECK_FALSE(runs_beside(*quiet));
        for (const auto& plan : {*live, *quiet}) {
            const auto stage = std::ranges::find_if(plan.stages, is_stage);
            REQUIRE(stage != plan.stages.end());
            CHECK(stage->name == "finding");
            CHECK(stage->rate_hz == 2000.0);
            CHECK(stage->line == 7);
        }
        CHECK(explain(lesson, *live).find("a thread finds contact beside the haptic loop") !=
              std::string::npos);
        CHECK(explain(lesson, *quiet).find("In a live run a thread of its own finds contact") !=
              std::string::npos);
    }
    // A god-object's motion is beside too.
    lesson.hand.tool->method = ToolMethod::god_object;
    lesson.hand.tool->contact = ContactFinding::fields;
    const auto god = compile(lesson, {.live = true});
    const auto quiet_god = compile(lesson);
    REQUIRE(god);
    REQUIRE(quiet_god);
    CHECK(validate(god->haptic));
    CHECK(runs_beside(*god));
    CHECK_FALSE(runs_beside(*quiet_god));
    CHECK(std::ranges::find_if(god->stages, is_stage)->name == "motion");
    CHECK(explain(lesson, *god).find("a thread moves the tool beside the haptic loop") !=
          std::string::npos);
    CHECK(explain(lesson, *quiet_god).find("In a live run a thread of its own moves it") !=
          std::string::npos);
    // Points that push by fields find nothing beside.
    lesson.hand.tool->method = ToolMethod::field_sampling;
    const auto fields = compile(lesson, {.live = true});
    REQUIRE(fields);
    CHECK_FALSE(runs_beside(*fields));
    CHECK(std::ranges::none_of(fields->stages, is_stage));
    CHECK(explain(lesson, *fields).find("a thread") == std::string::npos);
}

TEST_CASE("plan: a live run has a budget for contact, the lesson's or half of a step") {
    LessonDescription lesson = make_lesson();
    const auto budget_us = [&](bool live) {
        PlanOptions options;
        options.live = live;
        const auto plan = compile(lesson, options);
        REQUIRE(plan);
        return make_implicit_penalty_plan(*plan->haptic.tool).settings.budget_us;
    };
    CHECK(budget_us(false) == 0.0);
    CHECK(budget_us(true) == 500.0);
    lesson.hand.tool->budget_us = 120.0;
    CHECK(budget_us(false) == 0.0);
    CHECK(budget_us(true) == 120.0);
    CHECK(explain(lesson, *compile(lesson)).find("it has 120 us of each step") !=
          std::string::npos);
    lesson.hand.rate_hz = 4000.0;
    CHECK(budget_us(true) == 120.0);
    lesson.hand.tool->budget_us = 130.0;
    const auto refused = compile(lesson);
    REQUIRE_FALSE(refused);
    CHECK(to_sentence(refused.error()) ==
          "lesson.lua:7: the tool: its contacts may take 130 us of each step, and at 4000 steps a "
          "second there are 125 us for it; give it a budget of at most 125, or leave that out.");
    // Fields have none: they are as fast as they are.
    lesson.hand.tool->contact = ContactFinding::fields;
    lesson.hand.tool->budget_us = 0.0;
    CHECK(budget_us(true) == 0.0);
}

TEST_CASE("plan: a tool that begins wholly inside a body is told, though no surfaces are near") {
    LessonDescription lesson = make_lesson();
    lesson.bodies[1].model = "cage";
    lesson.bodies[1].position_W = lesson.hand.centre_W;
    const auto plan = compile(lesson);
    REQUIRE(plan);
    REQUIRE(plan->notices.size() == 1);
    CHECK(plan->notices[0].find("begins inside the block") != std::string::npos);
    lesson.bodies[1].position_W = lesson.hand.centre_W + Vector3(5.0, 0.0, 0.0);
    CHECK(compile(lesson)->notices.empty());
}

TEST_CASE("plan: what is wrong with a mesh that is met by levels is told in a sentence") {
    LessonDescription lesson = make_lesson();
    lesson.bodies[1].model = "leaf";
    const auto plan = compile(lesson);
    REQUIRE(plan);
    REQUIRE(plan->notices.size() == 1);
    CHECK(plan->notices[0] ==
          "lesson.lua:4: the block: its mesh is open, so on which side of it a tool is may be felt "
          "wrong; close it, with all fronts outwards.");
}
