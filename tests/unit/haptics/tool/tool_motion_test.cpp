#include "haptics/tool/tool_motion.h"

#include "haptics/math/rotation.h"

#include <catch2/catch.hpp>

using namespace fulcrum;

namespace {

constexpr double kRounding = 1.0e-12;
constexpr double kDt_s = 0.001;

}  // namespace

TEST_CASE("tool motion: the way is the object's, and as long as its fastest point's at most") {
    // Both go together on a carousel: no way at all.
    MovingFrame object{{{0.3, -0.1, 0.2}, compute_exp({0.2, 1.0, -0.4})},
                       {{0.5, 0.1, 0.0}, {0.0, 3.0, 1.0}}};
    const Pose tool_O{{0.04, 0.02, -0.01}, compute_exp({0.1, 0.0, 0.3})};
    const Pose object_before = move_evenly(object, -kDt_s).pose_W;
    const ToolMotion together{object_before * tool_O, object_before, object};
    CHECK(find_way(together, object.pose_W * tool_O, 0.1).longest_m < kRounding);
    // Shifted by 5 mm and turned by 0.2 in the object's eyes: a point at 0.1 m goes 25 mm at most.
    const Pose moved_O{tool_O.position + Vector3(0.0, 0.003, 0.004),
                       compute_exp({0.0, 0.2, 0.0}) * tool_O.orientation};
    const ToolWay way = find_way(together, object.pose_W * moved_O, 0.1);
    CHECK(way.longest_m == Approx(0.025).epsilon(1.0e-9));
    CHECK((way.to_OT.position - moved_O.position).norm() < kRounding);
}

TEST_CASE(
    "tool motion: put back to none of the way the tool goes with the object, to all of it as it "
    "went") {
    const MovingFrame object{{{0.3, -0.1, 0.2}, compute_exp({0.2, 1.0, -0.4})},
                             {{0.5, 0.1, 0.0}, {0.0, 3.0, 1.0}}};
    const Pose before_O{{0.04, 0.02, -0.01}, compute_exp({0.1, 0.0, 0.3})};
    const Pose object_before = move_evenly(object, -kDt_s).pose_W;
    const ToolMotion motion{object_before * before_O, object_before, object};
    RigidState end;
    end.pose_W = object.pose_W * Pose{{0.05, 0.01, -0.01}, compute_exp({0.1, 0.2, 0.3})};
    end.velocity_W = {{1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}};
    const ToolWay way = find_way(motion, end.pose_W, 0.1);
    RigidState all = end;
    put_back(motion, way, 1.0, 1.0, all);
    CHECK((all.pose_W.position - end.pose_W.position).norm() < kRounding);
    CHECK((all.velocity_W.linear - end.velocity_W.linear).norm() < kRounding);
    CHECK((all.velocity_W.angular - end.velocity_W.angular).norm() < kRounding);
    RigidState none = end;
    put_back(motion, way, 0.0, 0.0, none);
    const Pose there = object.pose_W * before_O;
    CHECK((none.pose_W.position - there.position).norm() < kRounding);
    CHECK((none.velocity_W.linear - compute_velocity_at(object, there.position)).norm() <
          kRounding);
    CHECK((none.velocity_W.angular - object.velocity_W.angular).norm() < kRounding);
}
