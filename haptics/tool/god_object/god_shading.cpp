// The step path of god_shading.h.
#include "haptics/tool/god_object/god_shading.h"

namespace fulcrum {
namespace {

constexpr double kLeastAlong =
    0.5;  // of the true direction's, 60 degrees: what is farther off is no smooth body's

}  // namespace

Vector3 find_felt_normal_O(const GodShading* object, const GodShading* tool,
                           const GodContact& contact, const Pose& X_OT) noexcept {
    const bool on_edges = contact.pair == FeaturePair::edge_edge;
    Vector3 sum = Vector3::Zero();
    if (object != nullptr && contact.pair != FeaturePair::vertex_face &&
        (!on_edges || object->is_even(contact.object_triangle, contact.object_feature))) {
        sum += object->normal_B(contact.object_triangle, contact.on_object_O, contact.normal_O);
    }
    if (tool != nullptr && contact.pair != FeaturePair::face_vertex &&
        (!on_edges || tool->is_even(contact.tool_triangle, contact.tool_feature))) {
        const Quaternion turn_TO = X_OT.orientation.conjugate();
        const Vector3 at_T = turn_TO * (contact.on_tool_O - X_OT.position);
        sum -= X_OT.orientation *
               tool->normal_B(contact.tool_triangle, at_T, -(turn_TO * contact.normal_O));
    }
    const double length = sum.norm();
    const bool is_near = sum.dot(contact.normal_O) > kLeastAlong * length;
    return is_near ? Vector3(sum / length) : contact.normal_O;
}

}  // namespace fulcrum
