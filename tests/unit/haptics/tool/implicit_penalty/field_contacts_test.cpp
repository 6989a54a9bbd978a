#include "haptics/tool/implicit_penalty/field_contacts.h"

#include "haptics/dynamics/rigid_state.h"
#include "haptics/math/rotation.h"
#include "haptics/tool/voxel_tool.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/field_parts.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <rapidcheck.h>
#include <vector>

using namespace fulcrum;

namespace {

constexpr double kRadius_m = 0.05;

std::shared_ptr<const DistanceField> ball() {
    static const auto kField = test::make_field(make_sphere(kRadius_m, 48).value(), 64);
    return kField;
}

double most_m() {
    return FieldContacts::most_within_m(*ball());
}

Pointshell make_box_shell(int n_points) {
    return make_surface_pointshell(make_box({0.04, 0.02, 0.03}).value(), n_points).value();
}

std::unique_ptr<FieldContacts> make_finder(int n_points, double within_m = most_m()) {
    return FieldContacts::create(ball(), test::make_shell(make_box_shell(n_points)), within_m)
        .value();
}

// One after the other, by the field alone.
std::vector<Vector3> find_plainly(const DistanceField& field, const Pointshell& shell,
                                  const Pose& X_OT, double within_m) {
    std::vector<Vector3> near;
    for (std::size_t i = 0; i < shell.size(); ++i) {
        if (field.sample(X_OT * shell.position_T(i)).value_m < within_m) {
            near.push_back(shell.position_T(i));
        }
    }
    return near;
}

constexpr double kDt_s = 1.0e-3;
constexpr double kWall_m = 4.0e-3;  // thick

// A wall across y = 0, a voxel of it 0.8 mm.
FieldSampler::Field wall() {
    static const FieldSampler::Field kWall =
        test::make_field(make_box({0.05, kWall_m, 0.05}).value(), 64);
    return kWall;
}

FieldTool make_tool(const TriangleMesh& mesh, bool swept, ToolMass mass = ToolMass::massive) {
    VoxelToolSettings settings;
    settings.swept = swept;
    settings.mass = mass;
    settings.inertia = make_box_inertia(0.05, mesh.upper_B() - mesh.lower_B());
    settings.coupling.shift.stiffness_N_per_m = 500.0;
    settings.coupling.turn.stiffness_Nm_per_rad = 0.5;
    const FieldSamplingPlan plan{wall(), test::make_shell(mesh, 400), {.stiffness_N_per_m = 100.0}};
    return FieldTool::build(plan, settings).value();
}

TriangleMesh small_ball() {
    return make_sphere(1.0e-3, 8).value();
}

// The hand goes from one place to another and stays; where the tool is then.
double fly(FieldTool& tool, const Vector3& from, const Vector3& to, double speed_m_per_s,
           int n_rest = 50) {
    const double way_m = (to - from).norm();
    const Vector3 velocity = (to - from) / way_m * speed_m_per_s;
    const int n_flight = static_cast<int>(std::ceil(way_m / (speed_m_per_s * kDt_s)));
    tool.place(Pose::at(from));
    for (int i = 1; i <= n_flight + n_rest; ++i) {
        const bool flies = i < n_flight;
        const MovingFrame hand{Pose::at(flies ? Vector3(from + i * kDt_s * velocity) : to),
                               {flies ? velocity : Vector3(Vector3::Zero()), Vector3::Zero()}};
        REQUIRE(tool.step(hand, {}, i * kDt_s, kDt_s).moved);
    }
    return tool.state().pose_W.position.y();
}

}  // namespace

TEST_CASE("field contacts: what is near is found, all of it and nothing else") {
    const auto field = ball();
    const Pointshell shell = make_box_shell(3000);
    const auto finder = make_finder(3000);
    BoundedList<NearContact> near(3000);
    std::size_t most = 0;
    CHECK(rc::check([&] {
        const auto number = [] { return 1.0e-3 * *rc::gen::inRange(-1000, 1001); };
        const Vector3 way = Vector3(number(), number(), number() + 2.0).normalized();
        const Pose X_OT{(0.04 + 0.04 * std::abs(number())) * way,
                        compute_exp(3.0 * Vector3(number(), number(), number()))};
        near.clear();
        finder->find(X_OT, most_m(), near);
        std::vector<Vector3> plain = find_plainly(*field, shell, X_OT, most_m());
        // A point at the very limit may be on either side of it by single precision.
        const auto n_sure =
            static_cast<std::size_t>(std::ranges::count_if(plain, [&](const Vector3& p_T) {
                return field->sample(X_OT * p_T).value_m < most_m() - 1.0e-6;
            }));
        RC_ASSERT(near.count() >= n_sure);
        RC_ASSERT(near.count() <= plain.size() + 5);
        most = std::max(most, near.count());
        for (const NearContact& one : near.all()) {
            const double value_m = field->sample(X_OT * one.point_T).value_m;
            if (value_m > -DistanceField::kDeepFrom * field->band_m()) {
                RC_ASSERT(std::abs(one.depth_m + value_m) < 2.0e-6);
            }
            RC_ASSERT(one.depth_m > -most_m() - 1.0e-6);
        }
    }));
    CHECK(most > 100);
}

TEST_CASE("field contacts: depth and normal are those of the ball") {
    const auto finder = make_finder(2000);
    BoundedList<NearContact> near(2000);
    const Pose X_OT{{0.0, 0.056, 0.01}, compute_exp(Vector3(0.2, 0.4, -0.1))};
    finder->find(X_OT, most_m(), near);
    REQUIRE(near.count() > 50);
    const double voxel_m = ball()->frame().voxel_m;
    for (const NearContact& one : near.all()) {
        const Vector3 p_O = X_OT * one.point_T;
        // The mesh lies inside its ball by less than a hundredth of the radius.
        CHECK(std::abs(one.depth_m - (kRadius_m - p_O.norm())) < 0.01 * kRadius_m + 0.1 * voxel_m);
        CHECK(one.normal_O.norm() == Approx(1.0).epsilon(1e-9));
        CHECK(one.normal_O.dot(p_O.normalized()) > 0.98);
    }
}

TEST_CASE("field contacts: deeper than the band the depth goes on") {
    const auto finder = make_finder(500);
    BoundedList<NearContact> near(500);
    // All of the box lies in the ball.
    finder->find(Pose::at({0.0, 0.012, 0.0}), most_m(), near);
    CHECK(near.count() == 500);
    double deepest_m = 0.0;
    for (const NearContact& one : near.all()) {
        deepest_m = std::max(deepest_m, one.depth_m);
        CHECK(one.depth_m > 0.0);
        CHECK(one.normal_O.norm() == Approx(1.0).epsilon(1e-9));
    }
    CHECK(deepest_m > 2.0 * ball()->band_m());
}

TEST_CASE("field contacts: a list that is too short gets an even share") {
    const auto finder = make_finder(8000);
    const Pose X_OT = Pose::at({0.0, 0.055, 0.0});
    BoundedList<NearContact> all(8000);
    finder->find(X_OT, most_m(), all);
    BoundedList<NearContact> few(256);
    finder->find(X_OT, most_m(), few);
    REQUIRE(all.count() > 1000);
    CHECK(few.count() > 32);
    CHECK(few.count() < 256);
    const auto mean_of = [](const BoundedList<NearContact>& near) {
        Vector3 sum = Vector3::Zero();
        for (const NearContact& one : near.all()) {
            sum += one.point_T;
        }
        return Vector3(sum / static_cast<double>(near.count()));
    };
    CHECK((mean_of(all) - mean_of(few)).norm() < 0.003);
}

TEST_CASE("field contacts: far away there are none, and what cannot be is refused") {
    const auto field = ball();
    const auto shell = test::make_shell(make_box_shell(500));
    const auto finder = make_finder(500, 0.001);
    BoundedList<NearContact> near(500);
    for (const double far_m : {0.09, 1.0, 1.0e3}) {
        finder->find(Pose::at({far_m, 0.0, 0.0}), 0.001, near);
        CHECK(near.count() == 0);
    }
    CHECK(finder->memory_bytes() > field->memory_bytes());
    CHECK(finder->reach_m() == shell->reach_m());
    CHECK_FALSE(FieldContacts::create(nullptr, shell, 0.001));
    CHECK_FALSE(FieldContacts::create(field, nullptr, 0.001));
    for (const double within_m : {0.0, -1.0, 1.01 * most_m(), kNan}) {
        CHECK_FALSE(FieldContacts::create(field, shell, within_m));
    }
}

// A tool in a field that is swept (field_load.h): no wall of two voxels is passed, whoever moves, and what is slow is left alone.

TEST_CASE("field tool sweep: at any speed the tool stays before the wall; unswept it passes") {
    const Vector3 before(0.003, 0.03, -0.002);
    const Vector3 behind(0.003, -0.03, -0.002);
    bool passed_unswept = false;
    for (const ToolMass mass : {ToolMass::massive, ToolMass::massless}) {
        for (const double speed_m_per_s : {0.5, 2.0, 5.0, 20.0}) {
            INFO(static_cast<int>(mass) << ", " << speed_m_per_s << " m/s");
            FieldTool swept = make_tool(small_ball(), true, mass);
            // Its lowest points are no deeper than a voxel, from either side.
            CHECK(fly(swept, before, behind, speed_m_per_s) > 0.5 * kWall_m + 1.0e-3 - 9.0e-4);
            CHECK(fly(swept, behind, before, speed_m_per_s) < -0.5 * kWall_m - 1.0e-3 + 9.0e-4);
            FieldTool unswept = make_tool(small_ball(), false, mass);
            passed_unswept |= fly(unswept, before, behind, speed_m_per_s) < 0.0;
        }
    }
    CHECK(passed_unswept);
}

TEST_CASE("field tool sweep: a wall that moves through a still hand takes the tool along") {
    for (const double speed_m_per_s : {2.0, 5.0, 20.0}) {
        for (const bool swept : {true, false}) {
            FieldTool tool = make_tool(small_ball(), swept);
            const MovingFrame hand{Pose::at({0.0, 0.02, 0.0}), {}};
            tool.place(hand.pose_W);
            const int n = static_cast<int>(std::ceil(0.04 / (speed_m_per_s * kDt_s)));
            double y_m = 0.0;
            for (int i = 1; i <= n; ++i) {
                y_m = i * kDt_s * speed_m_per_s;
                const MovingFrame moving{Pose::at({0.0, y_m, 0.0}),
                                         {{0.0, speed_m_per_s, 0.0}, Vector3::Zero()}};
                REQUIRE(tool.step(hand, moving, i * kDt_s, kDt_s).moved);
            }
            INFO(speed_m_per_s << " m/s, swept " << swept);
            const double ahead_m = tool.state().pose_W.position.y() - y_m;
            CHECK((ahead_m > 0.5 * kWall_m) == swept);
        }
    }
}

TEST_CASE("field tool sweep: a turn stops a voxel deep; what is slow goes as without, to the bit") {
    // 4 cm long and thin; its tip reaches the wall at sin(angle) 2 cm = 1.2 cm.
    const TriangleMesh bar = make_box({0.04, 2.0e-4, 2.0e-4}).value();
    const FieldSampling sampling =
        FieldSampling::build({wall(), test::make_shell(bar, 2000), {}}).value();
    const double voxel_m = wall()->frame().voxel_m;
    const double over_m = 0.012;
    const MovingFrame object{Pose::at({0.3, 0.2, 0.1}), {{0.0, 1.0, 0.0}, {0.0, 2.0, 0.0}}};
    const Vector3 at = object.pose_W.position + Vector3(0.0, 0.5 * kWall_m + over_m, 0.0);
    RigidState end;
    end.pose_W = {at, compute_exp({0.0, 0.0, 1.3})};
    end.velocity_W = {{0.0, 1.0, 0.0}, {0.0, 2.0, 7.0}};
    // Object and tool go up together, and the object is where it was seen from.
    const ToolMotion motion{Pose::at(at), object.pose_W, object};
    REQUIRE(sampling.stop_at_touch(motion, 0.0, end));
    const double angle = AngleAxis(end.pose_W.orientation).angle();
    CHECK(angle == Approx(std::asin((over_m + voxel_m) / 0.02)).margin(0.25 * voxel_m / 0.016));
    CHECK((end.pose_W.position - at).norm() < 1.0e-12);
    CHECK(end.velocity_W.linear.y() == Approx(1.0));
    CHECK(end.velocity_W.angular.y() == Approx(2.0));
    CHECK(end.velocity_W.angular.z() == Approx(7.0 * angle / 1.3));
    // A turn that ends before is no matter, nor one that is no number.
    RigidState short_turn = end;
    short_turn.pose_W.orientation = compute_exp({0.0, 0.0, 0.6});
    CHECK_FALSE(sampling.stop_at_touch(motion, 0.0, short_turn));
    RigidState none = end;
    none.pose_W.position.x() = std::nan("");
    CHECK_FALSE(sampling.stop_at_touch(motion, 0.0, none));
    // What was deeper than a voxel may leave, and goes no deeper.
    RigidState out = end;
    out.pose_W.orientation = compute_exp({0.0, 0.0, 0.2});
    const ToolMotion leaving{{at, compute_exp({0.0, 0.0, 0.715})}, object.pose_W, object};
    CHECK_FALSE(sampling.stop_at_touch(leaving, 1.5 * voxel_m, out));
    RigidState deeper = end;
    deeper.pose_W.orientation = compute_exp({0.0, 0.0, 1.3});
    REQUIRE(sampling.stop_at_touch(leaving, 1.5 * voxel_m, deeper));
    CHECK(AngleAxis(deeper.pose_W.orientation).angle() < 0.72);
    const Vector3 before(0.003, 0.01, -0.002);
    const Vector3 pressed(0.003, 0.002, -0.002);
    FieldTool swept = make_tool(small_ball(), true);
    FieldTool unswept = make_tool(small_ball(), false);
    (void)fly(swept, before, pressed, 0.1, 200);
    (void)fly(unswept, before, pressed, 0.1, 200);
    CHECK(swept.state().pose_W.position == unswept.state().pose_W.position);
    CHECK(swept.state().velocity_W.linear == unswept.state().velocity_W.linear);
    // Ten million voxels away, where the field can say nothing.
    const Vector3 far(8000.0, 0.0, 0.0);
    const double y_m = fly(swept, far, far + Vector3(0.0, 0.1, 0.0), 20.0, 500);
    CHECK(y_m > 0.09);
    CHECK(fly(unswept, far, far + Vector3(0.0, 0.1, 0.0), 20.0, 500) == y_m);
}
