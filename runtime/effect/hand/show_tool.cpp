#include "runtime/effect/hand/show_tool.h"

#include "haptics/math/length.h"
#include "runtime/effect/kite/show_kite.h"
#include "runtime/scene/shape_models.h"

#include <optional>
#include <string>

namespace fulcrum::runtime {
namespace {

// What holds a kite's line, where it is nothing else.
bool has_reel(const LessonDescription& lesson) {
    return lesson.kite && !lesson.hand.tool && !lesson.bucket.present &&
           !has_shaped_cursor(lesson.hand);
}

// How large a hand is that points: as large in every picture.
double hand_scale(const CameraDescription& camera) {
    constexpr double kFrom_m = 1.3;  // there it is as large as a child's
    return (camera.eye_W - camera.target_W).norm() / kFrom_m;
}

// A hand that points there, as it lies before whoever looks: the finger up, to the left and away, its back to the eye. `tip_m`: the radius of
// its round tip about that place; 0: the tip ends there.
void point_hand(const CameraDescription& camera, const Vector3& at_W, double tip_m,
                ViewBody& hand) {
    constexpr double kAside_rad = -0.45;
    constexpr double kLean_rad = 0.65;
    const Vector3 forward = compute_direction(Vector3(camera.target_W - camera.eye_W));
    const Vector3 right = compute_direction(Vector3(forward.cross(Vector3::UnitY())));
    Matrix3 turn;
    turn << -right, right.cross(forward), forward;
    const Quaternion held = Quaternion(turn) * Quaternion(AngleAxis(kLean_rad, Vector3::UnitX())) *
                            Quaternion(AngleAxis(kAside_rad, Vector3::UnitZ()));
    hand.pose_W = {at_W + tip_m * (held * Vector3::UnitY()), held};
    hand.scale = Vector3::Constant(tip_m > 0.0 ? tip_m / kFingertip_m : hand_scale(camera));
}

// Of the hand that is drawn for a point, 0, or for a ball that is about as large as its fingertip; nothing where something else is drawn.
std::optional<double> fingertip_m(const LessonDescription& lesson) {
    constexpr double kAlike = 2.0;
    if (lesson.hand.tool || lesson.bucket.present || has_reel(lesson) ||
        !lesson.hand.cursor_model.empty()) {
        return std::nullopt;
    }
    if (!has_shaped_cursor(lesson.hand)) {
        return 0.0;
    }
    const auto* const ball = std::get_if<SphereShape>(&lesson.hand.cursor);
    const double tip_m = kFingertip_m * hand_scale(lesson.camera);
    return ball != nullptr && ball->radius_m < kAlike * tip_m && tip_m < kAlike * ball->radius_m
               ? std::optional(ball->radius_m)
               : std::nullopt;
}

std::string tool_model(const LessonDescription& lesson) {
    if (lesson.hand.tool) {
        const std::string& model = lesson.hand.tool->model;
        return model.empty() ? std::string(kToolModel) : model;
    }
    if (lesson.bucket.present) {
        return lesson.bucket.model;
    }
    if (has_reel(lesson)) {
        return std::string(kReelModel);
    }
    return fingertip_m(lesson)                ? std::string(kCursorModel)
           : lesson.hand.cursor_model.empty() ? std::string(kToolModel)
                                              : lesson.hand.cursor_model;
}

// A model of size 1 is drawn as large as its shape is felt.
Vector3 tool_scale(const LessonDescription& lesson) {
    if (has_reel(lesson)) {
        return Vector3::Constant(lesson.kite->seen_scale);
    }
    if (lesson.hand.tool && is_shape_model(lesson.hand.tool->model)) {
        if (const auto* ball = std::get_if<SphereShape>(&lesson.hand.tool->shape)) {
            return Vector3::Constant(ball->radius_m);
        }
        if (const auto* box = std::get_if<BoxShape>(&lesson.hand.tool->shape)) {
            return box->half_size_m;
        }
    }
    return Vector3::Ones();
}

}  // namespace

bool has_shaped_cursor(const HandDescription& hand) noexcept {
    return !hand.tool && !std::holds_alternative<std::monostate>(hand.cursor);
}

ViewBody show_hand(const CameraDescription& camera, const Vector3& at_W) {
    ViewBody hand;
    hand.model = kHandModel;
    point_hand(camera, at_W, 0.0, hand);
    hand.marked = false;
    return hand;
}

void show_tool(const LessonDescription& lesson, const Scenery& scenery, View& view) {
    view.tool.model = tool_model(lesson);
    view.tool.scale = tool_scale(lesson);
    view.tool.pose_W = {scenery.hand.proxy_position_W, scenery.hand.proxy_orientation_W};
    view.ghost_visible = scenery.ghost;
    view.ghost_pose_W = scenery.ghost_pose_W;
    if (const auto tip_m = fingertip_m(lesson)) {
        point_hand(lesson.camera, scenery.ghost_pose_W.position, *tip_m, view.tool);
        view.ghost_pose_W = view.tool.pose_W;
        point_hand(lesson.camera, scenery.hand.proxy_position_W, *tip_m, view.tool);
    }
}

}  // namespace fulcrum::runtime
