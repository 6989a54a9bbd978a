// A tool whose contacts are found by contact levels of detail, as a plan has it.
#include "haptics/loop/haptic_loop.h"
#include "haptics/tool/tool_plan.h"
#include "runtime/effect/tool/plan_tool.h"
#include "runtime/files/shape_cache.h"
#include "runtime/scene/explain.h"
#include "tests/unit/runtime/scene/plan_scene.h"

#include <nlohmann/json.hpp>

using namespace fulcrum::runtime::test;

namespace {

// A bumpy ball of 5 cm, and a block beside it.
LessonDescription by_levels() {
    LessonDescription lesson = make_lesson();
    lesson.bodies = {make_solid("ball"), make_solid("block")};
    lesson.bodies[1].position_W = {0.3, 0.0, 0.0};
    lesson.hand.tool->method = ToolMethod::implicit_penalty;
    lesson.hand.tool->contact = ContactFinding::levels;
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

const std::vector<LevelContactsPlan>& objects_of(const Plan& plan) {
    return std::get<std::vector<LevelContactsPlan>>(plan.haptic.tool->objects);
}

}  // namespace

TEST_CASE("plan: contact by levels is one word, and what it is made of is told") {
    const LessonDescription lesson = by_levels();
    const auto plan = plan_of(lesson, load);
    CHECK(validate(plan.haptic));
    REQUIRE(objects_of(plan).size() == 2);
    const LevelContactsPlan& ball = objects_of(plan).front();
    CHECK(ball.tool == objects_of(plan).back().tool);
    CHECK(ball.settings.tolerance_m == Approx(kUsualDetail * ball.tool->size_m()));
    CHECK(ball.settings.budget_us == 0.0);
    // Levels look as far as clusters do: a tenth of the tool, and half of the finest voxel that fields would have.
    LessonDescription by_fields = lesson;
    by_fields.hand.tool->contact = ContactFinding::fields;
    const auto fields = plan_of(by_fields, load);
    CHECK(plan.haptic.tool->penalty->clusters.within_m ==
          Approx(fields.haptic.tool->penalty->clusters.within_m).epsilon(0.1));
    CHECK(ball.object->settings().within_m == plan.haptic.tool->penalty->clusters.within_m);
    const std::string text = explain(lesson, plan);
    CAPTURE(text);
    const std::string levels = std::to_string(ball.object->n_levels()) + " levels, " +
                               std::to_string(ball.object->n_pieces()) + " pieces, ";
    check_says(
        text, {"implicit_penalty, contact by levels: ", "contact is what is nearer than ", levels});
    check_lacks(text, {"voxels of"});
    const auto json = nlohmann::json::parse(explain_json(lesson, plan, nullptr)).at("tool");
    CHECK(json["contact"]["found_by"] == "levels");
    CHECK(json["contact"]["tolerance_m"] == ball.settings.tolerance_m);
    CHECK(json["contact"]["memory_bytes"] == ball.tool->memory_bytes());
    CHECK(json["bodies"][0]["levels"] == ball.object->n_levels());
    CHECK(json["bodies"][0]["pieces"] == ball.object->n_pieces());
    CHECK(json["bodies"][0]["memory_bytes"] == ball.object->memory_bytes());
    // By fields nothing of it is made or told.
    check_lacks(explain(by_fields, fields), {"levels"});
    CHECK_FALSE(nlohmann::json::parse(explain_json(by_fields, fields, nullptr))["tool"].contains(
        "contact"));
    CHECK(std::holds_alternative<std::vector<FieldSamplingPlan>>(fields.haptic.tool->objects));
}

TEST_CASE("plan: levels are made once, then read, and made anew where they are spoiled") {
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
        return plan_of(by_levels(), load, options);
    };
    const ShapeCacheSettings settings{.folder = scratch.path() / "shapes", .least_build_s = 0.0};
    ShapeCache first(settings);
    double last_share = 0.0;
    const auto made = compile_with(first, &last_share);
    CHECK(made.tool_shapes == std::vector<ShapeSource>(3, ShapeSource::made));
    ShapeCache second(settings);
    const auto read = compile_with(second);
    CHECK(read.tool_shapes == std::vector<ShapeSource>(3, ShapeSource::cache));
    CHECK(second.told().empty());
    CHECK(second.counts().n_made == 0);
    check_says(explain(by_levels(), read), {"B, from the cache"});
    const auto is_same = [&](const Plan& plan) {
        const Digest key{};
        for (std::size_t i = 0; i < 2; ++i) {
            if (encode(*objects_of(plan)[i].object, key) !=
                    encode(*objects_of(made)[i].object, key) ||
                encode(*objects_of(plan)[i].tool, key) != encode(*objects_of(made)[i].tool, key)) {
                return false;
            }
        }
        return true;
    };
    CHECK(is_same(read));
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
        CHECK(third.counts().n_refused >= 3);
        CHECK(third.told().size() == static_cast<std::size_t>(third.counts().n_refused));
        CHECK(is_same(again));
    }
}

TEST_CASE("plan: whoever waits for levels may stop them") {
    PlanOptions options;
    options.progress = [](double /*share*/, std::string_view what) { return what != "ball"; };
    LessonDescription lesson = by_levels();
    lesson.hand.tool->contact = ContactFinding::levels;
    CHECK(
        refusal_of(compile_plan(lesson, options, [](const BodyDescription& /*body*/) {
            return make_bumpy_sphere(0.05, 40, 0.05, 100.0).and_then([](const TriangleMesh& mesh) {
                return CollisionMesh::create(mesh);
            });
        })).find("lesson.lua:4: the ball: ") == 0);
}

TEST_CASE("plan: a thread finds contact or moves a god-object beside the steps if live, else not") {
    LessonDescription lesson = by_levels();
    const auto is_stage = [](const PlanStage& stage) { return stage.loop == "contact"; };
    const auto runs_beside = [](const Plan& plan) {
        const auto tool = make_tool(*plan.haptic.tool);
        auto* const solver = dynamic_cast<BesideSolver*>(tool.get());
        return solver != nullptr && solver->beside() != nullptr;
    };
    for (const ContactFinding contact : {ContactFinding::levels, ContactFinding::fields}) {
        lesson.hand.tool->contact = contact;
        const auto live = plan_of(lesson, load, {.live = true});
        CHECK(validate(live.haptic));
        CHECK_FALSE(make_implicit_penalty_plan(*live.haptic.tool).settings.own_rounds);
        CHECK(runs_beside(live));
        // Under a virtual clock each step does; what is listed is the same but for the reason.
        const auto quiet = plan_of(lesson, load);
        CHECK(make_implicit_penalty_plan(*quiet.haptic.tool).settings.own_rounds);
        CHECK_FALSE(runs_beside(quiet));
        for (const auto& plan : {live, quiet}) {
            const auto stage = std::ranges::find_if(plan.stages, is_stage);
            REQUIRE(stage != plan.stages.end());
            CHECK(stage->name == "finding");
            CHECK(stage->rate_hz == 2000.0);
            CHECK(stage->line == 7);
        }
        check_says(explain(lesson, live), {"a thread finds contact beside the haptic loop"});
        check_says(explain(lesson, quiet), {"In a live run a thread of its own finds contact"});
    }
    // A god-object's motion is beside too.
    lesson.hand.tool->method = ToolMethod::god_object;
    lesson.hand.tool->contact = ContactFinding::fields;
    const Plan god = plan_of(lesson, load, {.live = true});
    const Plan quiet_god = plan_of(lesson, load);
    CHECK(validate(god.haptic));
    CHECK(runs_beside(god));
    CHECK_FALSE(runs_beside(quiet_god));
    CHECK(std::ranges::find_if(god.stages, is_stage)->name == "motion");
    check_says(explain(lesson, god), {"a thread moves the tool beside the haptic loop"});
    check_says(explain(lesson, quiet_god), {"In a live run a thread of its own moves it"});
    // Points that push by fields find nothing beside.
    lesson.hand.tool->method = ToolMethod::field_sampling;
    const auto fields = plan_of(lesson, load, {.live = true});
    CHECK_FALSE(runs_beside(fields));
    CHECK(std::ranges::none_of(fields.stages, is_stage));
    check_lacks(explain(lesson, fields), {"a thread"});
}

TEST_CASE("plan: a live run has a budget for contact, the lesson's or half of a step") {
    LessonDescription lesson = by_levels();
    const auto budget_us = [&](bool live) {
        PlanOptions options;
        options.live = live;
        const auto plan = plan_of(lesson, load, options);
        return make_implicit_penalty_plan(*plan.haptic.tool).settings.budget_us;
    };
    CHECK(budget_us(false) == 0.0);
    CHECK(budget_us(true) == 500.0);
    lesson.hand.tool->budget_us = 120.0;
    CHECK(budget_us(false) == 0.0);
    CHECK(budget_us(true) == 120.0);
    check_says(explain(lesson, plan_of(lesson, load)), {"it has 120 us of each step"});
    lesson.hand.rate_hz = 4000.0;
    CHECK(budget_us(true) == 120.0);
    lesson.hand.tool->budget_us = 130.0;
    CHECK(refusal(lesson, load) ==
          "lesson.lua:7: the tool: its contacts may take 130 us of each step, and at 4000 steps a "
          "second there are 125 us for it; give it a budget of at most 125, or leave that out.");
    // Fields have none: they are as fast as they are.
    lesson.hand.tool->contact = ContactFinding::fields;
    lesson.hand.tool->budget_us = 0.0;
    CHECK(budget_us(true) == 0.0);
}

TEST_CASE("plan: a tool that begins wholly inside a body is told, though no surfaces are near") {
    LessonDescription lesson = by_levels();
    lesson.bodies[1].model = "cage";
    lesson.bodies[1].position_W = lesson.hand.centre_W;
    const auto plan = plan_of(lesson, load);
    REQUIRE(plan.notices.size() == 1);
    check_says(plan.notices[0], {"begins inside the block"});
    lesson.bodies[1].position_W = lesson.hand.centre_W + Vector3(5.0, 0.0, 0.0);
    CHECK(plan_of(lesson, load).notices.empty());
}

TEST_CASE("plan: what is wrong with a mesh that is met by levels is told in a sentence") {
    LessonDescription lesson = by_levels();
    lesson.bodies[1].model = "leaf";
    const auto plan = plan_of(lesson, load);
    REQUIRE(plan.notices.size() == 1);
    CHECK(plan.notices[0] ==
          "lesson.lua:4: the block: its mesh is open, so on which side of it a tool is may be felt "
          "wrong; close it, with all fronts outwards.");
}
