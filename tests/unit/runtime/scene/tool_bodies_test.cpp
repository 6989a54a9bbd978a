#include "runtime/scene/tool_bodies.h"

#include "runtime/files/shape_cache.h"
#include "tests/unit/runtime/scene/plan_scene.h"

using namespace fulcrum::runtime::test;

namespace {

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

}  // namespace

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
