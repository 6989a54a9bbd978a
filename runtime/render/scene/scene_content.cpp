#include "runtime/render/scene/scene_content.h"

#include "runtime/render/scene/light.h"
#include "runtime/render/scene/looks.h"
#include "runtime/scene/shape_models.h"

#include <algorithm>
#include <cmath>

namespace fulcrum::runtime {

namespace {

constexpr double kGhostApart = 0.02;  // of the camera's distance: the ghost is fully seen
constexpr double kWidestMarked =
    0.15;  // half width, of the camera's distance: a floor, a shelf or a plank has none
constexpr double kBelowFloor = 0.25;  // of its radius: deeper things have no mark

std::optional<SceneItem> item_of(const ViewBody& body, const Camera& camera,
                                 const FindMesh& find_mesh) {
    const auto placement = place(body.pose_W, body.scale);
    if (!placement) {
        return std::nullopt;
    }
    SceneItem item;
    item.mesh = &find_mesh(body.model);
    item.placement = *placement;
    item.look = look_number(body.look);
    item.bounds = bounds_of(*placement, item.mesh->lowest, item.mesh->highest);
    item.light = body.light;
    const Vector3 from_target = item.bounds.centre_W - camera.target_W();
    const double aside_m = Vector3(from_target.x(), 0.0, from_target.z()).norm();
    const double reach_m = kLightReach * camera.distance_m();
    item.near = aside_m < reach_m && item.bounds.radius_m < reach_m;
    item.casts_shadow = item.near && body.marked;
    const double depth_m = camera.forward_W().dot(item.bounds.centre_W - camera.eye_W());
    item.level =
        depth_m > 0.0 ? gl::level_for(2.0 * item.bounds.radius_m * camera.dots_per_m(depth_m)) : 0;
    return item;
}

/// Marks lie where the lamp reaches; beyond, nothing falls that a hand could catch.
void add_mark(SceneContent& content, const SceneItem& item, const Camera& camera, double floor_m,
              bool is_hand) {
    const double height_m = item.bounds.lowest_m - floor_m;
    const bool is_thing = item.bounds.half_width_m < kWidestMarked * camera.distance_m();
    if (item.near && is_thing && height_m > -kBelowFloor * item.bounds.radius_m) {
        content.marks.push_back(
            {item.bounds.centre_W, item.bounds.half_width_m, std::max(height_m, 0.0), is_hand});
    }
}

/// Whether a thing's lowest point is within the hand, as an apple's in a bucket: then it lands nowhere.
bool lies_in(const SceneItem& item, const SceneItem& hand) {
    const Vector3 apart = item.bounds.centre_W - hand.bounds.centre_W;
    const double top_m = 2.0 * hand.bounds.centre_W.y() - hand.bounds.lowest_m;
    return std::hypot(apart.x(), apart.z()) < hand.bounds.half_width_m &&
           item.bounds.lowest_m >= hand.bounds.lowest_m && item.bounds.lowest_m < top_m;
}

/// Half of an item's extent across the picture.
double half_width_seen_m(const Camera& camera, const SceneItem& item) {
    const Matrix3f turn = item.placement.world_from_model.topLeftCorner<3, 3>();
    const Vector3f half = 0.5F * (item.mesh->highest - item.mesh->lowest);
    const Vector3f across = turn.transpose() * camera.right_W().cast<float>();
    // A box would be right with a sum; most things are round, as an ellipsoid is.
    return static_cast<double>(across.cwiseProduct(half).norm());
}

void add_label(SceneContent& content, const Camera& camera, const ViewBody& body,
               const SceneItem& item) {
    if (body.label.empty()) {
        return;
    }
    if (const auto seen = camera.project(item.bounds.centre_W)) {
        SceneLabel label;
        label.middle_px = {static_cast<float>(seen->position_px.x()),
                           static_cast<float>(seen->position_px.y())};
        label.radius_px =
            static_cast<float>(half_width_seen_m(camera, item) * camera.px_per_m(seen->depth_m));
        label.text = body.label;
        content.labels.push_back(std::move(label));
    }
}

void add_orbit(SceneContent& content, const ViewBody& body) {
    if (is_finite(body.pose_W) && std::isfinite(body.scale.x()) && body.scale.x() > 0.0) {
        content.orbits.push_back({body.pose_W.position,
                                  body.scale.x() * (body.pose_W.orientation * Vector3::UnitX()),
                                  body.scale.x() * (body.pose_W.orientation * Vector3::UnitZ())});
    }
}

void add_force_label(SceneContent& content, const Camera& camera, const ViewForce& force,
                     const Arrow& arrow) {
    const auto middle = camera.project(0.5 * (arrow.tail_W + arrow.tip_W));
    const auto tail = camera.project(arrow.tail_W);
    const auto tip = camera.project(arrow.tip_W);
    if (force.text.empty() || !middle || !tail || !tip) {
        return;
    }
    SceneLabel label;
    label.is_force = true;
    label.text = force.text;
    label.look = force.look;
    label.middle_px = {static_cast<float>(middle->position_px.x()),
                       static_cast<float>(middle->position_px.y())};
    label.radius_px = static_cast<float>(1.3 * arrow.radius_m * camera.px_per_m(middle->depth_m));
    // An arrow along the line of sight has no direction in the picture.
    const Vector2 way = tip->position_px - tail->position_px;
    if (way.norm() > 1.0) {
        const Vector2 unit = way.normalized();
        label.direction = {static_cast<float>(unit.x()), static_cast<float>(unit.y())};
        // The words stand beside the arrow, also when it lies across.
        label.radius_px = std::max(
            label.radius_px, static_cast<float>(0.5 * std::abs(way.x())) + 0.5F * label.radius_px);
    }
    const auto head_px = static_cast<float>(arrow.radius_m * camera.px_per_m(middle->depth_m));
    const Vector2f low =
        tail->position_px.cwiseMin(tip->position_px).cast<float>() - Vector2f::Constant(head_px);
    const Vector2f high =
        tail->position_px.cwiseMax(tip->position_px).cast<float>() + Vector2f::Constant(head_px);
    label.covers = {low.x(), low.y(), high.x() - low.x(), high.y() - low.y()};
    content.labels.push_back(std::move(label));
}

// The arrow of the force, and the bar from the axis to it.
void add_torque(SceneContent& content, const Camera& camera, const ViewTorque& torque,
                double scale) {
    const auto arrow = arrow_for(torque.force, camera, {.scale = scale});
    if (!arrow || content.arrows.size() >= kMostForces) {
        return;
    }
    content.arrows.push_back(*arrow);
    const std::size_t n_labels = content.labels.size();
    add_force_label(content, camera, torque.force, *arrow);
    const auto arm = arm_for(torque, camera);
    if (!arm) {
        return;
    }
    content.arms.push_back(*arm);
    const auto from = camera.project(torque.axis_W);
    const auto to = camera.project(torque.force.at_W);
    if (content.labels.size() > n_labels && from && to) {
        SceneLabel& label = content.labels.back();
        label.arm_from = {static_cast<float>(from->position_px.x()),
                          static_cast<float>(from->position_px.y())};
        label.arm_to = {static_cast<float>(to->position_px.x()),
                        static_cast<float>(to->position_px.y())};
    }
}

// A force that is remembered: slim, and it ends where the others begin.
void add_remembered(SceneContent& content, const Camera& camera, ViewForce mark) {
    constexpr ArrowStyle kSlimMark{.girth = 0.6};
    if (const auto arrow = arrow_for(mark, camera, kSlimMark)) {
        mark.at_W -= arrow->tip_W - arrow->tail_W;
    }
    if (const auto arrow = arrow_for(mark, camera, kSlimMark)) {
        content.arrows.push_back(*arrow);
        add_force_label(content, camera, mark, *arrow);
    }
}

/// Where the hand itself is; seen through the tool it would only shimmer, so it appears as they part.
std::optional<SceneContent::Ghost> ghost_of(const ViewBody& tool, bool tool_visible,
                                            const Pose& pose_W, const Camera& camera,
                                            const FindMesh& find_mesh) {
    ViewBody shown = tool;
    shown.pose_W = pose_W;
    const auto item = item_of(shown, camera, find_mesh);
    if (!item) {
        return std::nullopt;
    }
    SceneContent::Ghost ghost{*item};
    ghost.item.level = std::min(ghost.item.level + 1, gl::kLevelPixels.size());
    if (tool_visible && is_finite(tool.pose_W)) {
        const double apart_m = (pose_W.position - tool.pose_W.position).norm();
        ghost.strength =
            static_cast<float>(std::clamp(apart_m / (kGhostApart * camera.distance_m()), 0.0, 1.0));
    }
    return ghost;
}

void add_more_hands(SceneContent& content, const View& view, const Camera& camera, double floor_m,
                    const FindMesh& find_mesh) {
    for (const ViewHand& hand : view.more_hands) {
        if (auto item = item_of(hand.tool, camera, find_mesh)) {
            item->is_hand = true;
            content.items.push_back(*item);
            add_mark(content, *item, camera, floor_m, true);
            add_label(content, camera, hand.tool, *item);
        }
        if (hand.ghost_visible) {
            if (const auto ghost =
                    ghost_of(hand.tool, true, hand.ghost_pose_W, camera, find_mesh)) {
                content.more_ghosts.push_back(*ghost);
            }
        }
    }
}

void add_body(SceneContent& content, const ViewBody& body, const SceneItem* hand,
              const Camera& camera, double floor_m, const FindMesh& find_mesh) {
    if (body.model == kOrbitModel) {
        add_orbit(content, body);
    } else if (auto item = item_of(body, camera, find_mesh)) {
        item->sunk_m = std::max(floor_m - item->bounds.lowest_m, 0.0);
        item->is_held = hand != nullptr && lies_in(*item, *hand);
        content.items.push_back(*item);
        if (body.marked && !item->is_held) {
            add_mark(content, *item, camera, floor_m, false);
        }
        add_label(content, camera, body, *item);
    }
}

}  // namespace

SceneContent content_of(const View& view, const Camera& camera, const FindMesh& find_mesh) {
    SceneContent content;
    const double floor_m = std::isfinite(view.ground_height_m) ? view.ground_height_m : 0.0;
    auto hand = view.tool_visible ? item_of(view.tool, camera, find_mesh) : std::nullopt;
    for (std::size_t i = 0; i < std::min(view.bodies.size(), kMostBodies); ++i) {
        add_body(content, view.bodies[i], hand ? &*hand : nullptr, camera, floor_m, find_mesh);
    }
    if (hand) {
        hand->is_hand = true;
        content.items.push_back(*hand);
        add_mark(content, *hand, camera, floor_m, true);
        add_label(content, camera, view.tool, *hand);
    }
    if (view.ghost_visible) {
        if (const auto ghost =
                ghost_of(view.tool, view.tool_visible, view.ghost_pose_W, camera, find_mesh)) {
            content.ghost = ghost->item;
            content.ghost_strength = ghost->strength;
        }
    }
    add_more_hands(content, view, camera, floor_m, find_mesh);
    if (view.in_space) {
        content.marks.clear();  // nothing lands there
    }
    // The hand's own beside them, so that equal forces are equally long.
    const ArrowStyle style = view.forces.empty() ? ArrowStyle{} : style_of_balance(view.forces);
    content.arrow = arrow_for(view.force, camera, style);
    if (content.arrow) {
        add_force_label(content, camera, view.force, *content.arrow);
    }
    for (std::size_t i = 0; i < std::min(view.forces.size(), kMostForces); ++i) {
        if (const auto arrow = arrow_for(view.forces[i], camera, style)) {
            content.arrows.push_back(*arrow);
            add_force_label(content, camera, view.forces[i], *arrow);
        }
    }
    for (std::size_t i = 0; i < std::min(view.marks.size(), kMostForces); ++i) {
        add_remembered(content, camera, view.marks[i]);
    }
    const double scale = common_scale(view.torques);
    for (const ViewTorque& torque : view.torques) {
        add_torque(content, camera, torque, scale);
    }
    return content;
}

Box hand_seen(const View& view, const Camera& camera, const FindMesh& find_mesh) {
    const auto hand = view.tool_visible ? item_of(view.tool, camera, find_mesh) : std::nullopt;
    const auto seen = hand ? camera.project(hand->bounds.centre_W) : std::nullopt;
    if (!seen) {
        return {};
    }
    const Box middle{static_cast<float>(seen->position_px.x()),
                     static_cast<float>(seen->position_px.y()), 0.0F, 0.0F};
    return middle.grown(static_cast<float>(hand->bounds.radius_m * camera.px_per_m(seen->depth_m)));
}

}  // namespace fulcrum::runtime
