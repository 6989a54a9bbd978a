#include "haptics/tool/tool_motion.h"

#include "haptics/math/length.h"

namespace fulcrum {

Pose compute_between(const Pose& from, const Pose& to, double share) noexcept {
    return share > 0.0 ? Pose{from.position + share * (to.position - from.position),
                              from.orientation.slerp(share, to.orientation)}
                       : from;
}

ToolWay find_way(const ToolMotion& motion, const Pose& end_W, double reach_m) noexcept {
    ToolWay way;
    way.from_OT = motion.object_before_W.inverse() * motion.before_W;
    way.to_OT = motion.object.pose_W.inverse() * end_W;
    way.longest_m = compute_length(Vector3(way.to_OT.position - way.from_OT.position)) +
                    reach_m * way.from_OT.orientation.angularDistance(way.to_OT.orientation);
    return way;
}

void put_back(const ToolMotion& motion, const ToolWay& way, double share, double kept,
              RigidState& end) noexcept {
    const MovingFrame& object = motion.object;
    end.pose_W = object.pose_W * compute_between(way.from_OT, way.to_OT, share);
    const Vector3 carried = compute_velocity_at(object, end.pose_W.position);
    end.velocity_W.linear = carried + kept * (end.velocity_W.linear - carried);
    end.velocity_W.angular =
        object.velocity_W.angular + kept * (end.velocity_W.angular - object.velocity_W.angular);
}

}  // namespace fulcrum
