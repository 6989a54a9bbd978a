#include "runtime/lesson/compose_view.h"

#include "haptics/math/length.h"
#include "runtime/effect/hand/show_tool.h"
#include "runtime/effect/kite/show_kite.h"
#include "runtime/lesson/better_form.h"
#include "runtime/lesson/tool_extent.h"
#include "runtime/scene/shape_models.h"
#include "runtime/text/amounts.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace fulcrum::runtime {
namespace {

constexpr double kShownForce_N = 0.05;     // a smaller force is below what a hand notices: no arrow
constexpr double kShortArm_m = 0.01;       // a shorter lever arm is told in millimetres
constexpr double kSquashPerNewton = 0.02;  // flattening of what lies in the bucket, felt by the eye
constexpr double kStrongestSquash = 0.25;
constexpr double kArrowBelowBucket = 1.4;  // of its depth
constexpr double kArrowRoom =
    0.03;  // beside a tool, for half its head: parts of the camera's distance
constexpr double kSeenAskew = 0.1;  // sine of an angle: an arrow seen end on has no side

// Flatter and wider, with the same volume.
Vector3 squash(double amount) {
    const double wide = 1.0 / std::sqrt(1.0 - amount);
    return {wide, 1.0 - amount, wide};
}

// A ball and a box are made of size 1 and drawn as large as they are felt; other models have their own size.
Vector3 model_scale(const BodyDescription& body) {
    return is_shape_model(body.model) ? Vector3(0.5 * box_size_m(body))
                                      : Vector3::Constant(body.seen_scale);
}

const BodyState* state_of(const Scenery& scenery, std::size_t body) {
    return scenery.world != nullptr && body < static_cast<std::size_t>(scenery.world->n_bodies)
               ? &scenery.world->bodies[body]
               : nullptr;
}

bool is_covered(const SessionHud& hud, std::size_t body) {
    return body < hud.covered.size() && hud.covered[body];
}

// What lies under a cloth gives nothing away but where it is and how large.
void lay_cloth_over(const BodyDescription& body, ViewBody& shown) {
    shown.model = kClothModel;
    shown.scale = Vector3::Constant(body.radius_m);
    shown.look.clear();
    shown.label.clear();
}

BodyWhere where_of(const BodyDescription& body, const BodyState* state) {
    if (state != nullptr) {
        return state->where;
    }
    return body.visible ? BodyWhere::placed : BodyWhere::hidden;
}

// Bodies on hinges are turned by the haptic loop; its axles are in the order of the bodies that have one.
Pose turned_pose(const LessonDescription& lesson, const BodyDescription& body,
                 const AxleFrame& axles, const Pose& otherwise_W) {
    const auto axle = std::count_if(lesson.bodies.data(), &body, [](const BodyDescription& other) {
        return other.hinge.has_value();
    });
    return axle < axles.n_axles ? axles.axles[static_cast<std::size_t>(axle)].pose_W : otherwise_W;
}

// What a lesson speaks of: things that move, and solid ones that it gives a noun. A shelf or a lever has none.
bool is_named(const BodyDescription& body) {
    return body.movable || (body.solid && body.noun != body.name);
}

ViewBody show_body(const LessonDescription& lesson, const BodyDescription& body,
                   const BodyState* state, const Scenery& scenery) {
    const BodyWhere where = where_of(body, state);
    ViewBody shown;
    shown.model = body.model;
    shown.pose_W = state != nullptr ? state->pose_W : Pose::at(body.position_W);
    shown.scale = model_scale(body);
    if (where == BodyWhere::held && !scenery.renders_force && !scenery.calm) {
        const double force_N = scenery.hand.applied_W.force.norm();
        shown.scale = shown.scale.cwiseProduct(
            squash(std::min(kSquashPerNewton * force_N, kStrongestSquash)));
    }
    if (scenery.axles != nullptr && body.hinge && where == BodyWhere::placed) {
        shown.pose_W = turned_pose(lesson, body, *scenery.axles, shown.pose_W);
    }
    if (where == BodyWhere::held || where == BodyWhere::placed) {
        shown.label = is_named(body) ? body.noun : "";
    }
    if (body.material != kNoMaterial) {
        shown.look = lesson.materials[static_cast<std::size_t>(body.material)].look;
    }
    return shown;
}

// Each box of a body by itself; its name stands at the first.
void add_boxes(const BodyDescription& body, ViewBody& shown, View& view) {
    shown.marked = false;
    for (const PlacedBox& box : body.boxes) {
        ViewBody& part = view.bodies.emplace_back(shown);
        part.pose_W.position = shown.pose_W.position + shown.pose_W.orientation * box.at_B;
        part.scale = 0.5 * box.size_m;
        shown.label.clear();
    }
}

std::string force_text(const dialogue::Catalogue& catalogue, const std::string& whose,
                       double force_N) {
    return whose + ": " + catalogue.say("hud.force", {{"newtons", newtons_text(force_N)}});
}

// What was felt of a thing that stands there ends on what it stands on, right of it as the camera sees it, with its name.
void add_mark(const LessonDescription& lesson, const BodyDescription& body, double felt_N,
              const dialogue::Catalogue& catalogue, ViewBody& shown, View& view) {
    constexpr double kBeside = 0.025;  // of the camera's distance: more than half an arrow's head
    const Vector3 away = lesson.camera.target_W - lesson.camera.eye_W;
    const Vector3 right_W = compute_direction(Vector3(away.cross(Vector3::UnitY())));
    const double beside_m = body.radius_m + kBeside * compute_length(away);
    view.marks.push_back(
        {true, shown.pose_W.position + beside_m * right_W - body.radius_m * Vector3::UnitY(),
         Vector3(0.0, -felt_N, 0.0), force_text(catalogue, body.noun, felt_N), ForceLook::load});
    shown.label.clear();
}

void add_bodies(const LessonDescription& lesson, const SessionHud& hud, const Scenery& scenery,
                const dialogue::Catalogue& catalogue, View& view) {
    for (std::size_t i = 0; i < lesson.bodies.size(); ++i) {
        const BodyDescription& body = lesson.bodies[i];
        const BodyState* state = state_of(scenery, i);
        if (where_of(body, state) == BodyWhere::hidden) {
            continue;
        }
        ViewBody shown = show_body(lesson, body, state, scenery);
        if (i < hud.marked_N.size() && hud.marked_N[i] > 0.0 &&
            where_of(body, state) == BodyWhere::placed) {
            add_mark(lesson, body, hud.marked_N[i], catalogue, shown, view);
        }
        shown.light = i < hud.lights.size() ? hud.lights[i] : BodyLight::off;
        if (is_covered(hud, i)) {
            lay_cloth_over(body, shown);
        }
        if (body.boxes.empty() || is_covered(hud, i)) {
            view.bodies.push_back(std::move(shown));
        } else {
            add_boxes(body, shown, view);
        }
    }
}

// What lies in the bucket is named in both its weights: the one it has and the one that is felt.
std::string weight_text(const LessonDescription& lesson, const Plan& plan, const Scenery& scenery,
                        const dialogue::Catalogue& catalogue, double force_N) {
    double true_N = 0.0;
    double felt_N = 0.0;
    for (std::size_t i = 0; i < lesson.bodies.size(); ++i) {
        const BodyState* state = state_of(scenery, i);
        if (state != nullptr && state->where == BodyWhere::held) {
            true_N += lesson.bodies[i].mass_kg * lesson.gravity_W.norm();
            felt_N += plan.felt_weight_N[i];
        }
    }
    if (felt_N > 0.0) {
        return catalogue.say("hud.weight",
                             {{"felt", newtons_text(felt_N)}, {"true", newtons_text(true_N)}});
    }
    return catalogue.say("hud.force", {{"newtons", newtons_text(force_N)}});
}

// Beside a tool as it is seen, or from its surface on where that is nearer.
Vector3 find_tail_beside_tool_W(const ToolPlan& tool, const CameraDescription& camera,
                                const Pose& tool_W, const Vector3& force_W) {
    const Vector3 along = compute_direction(force_W);
    const double along_m = compute_tool_extent_m(tool, tool_W.orientation, along);
    const Vector3 from_surface = along_m * along;
    const Vector3 across = along.cross(compute_direction(Vector3(camera.eye_W - tool_W.position)));
    if (compute_length(across) < kSeenAskew) {
        return tool_W.position + from_surface;
    }
    const Vector3 aside = compute_direction(across);
    const double aside_m = compute_tool_extent_m(tool, tool_W.orientation, aside) +
                           kArrowRoom * compute_length(Vector3(camera.eye_W - camera.target_W));
    return tool_W.position + (aside_m < along_m ? Vector3(aside_m * aside) : from_surface);
}

// The arrow hangs below the bucket, so that it hides nothing of what lies in it; nor does it hide a tool.
Vector3 find_arrow_tail_W(const LessonDescription& lesson, const Plan& plan, const Pose& tool_W,
                          const Vector3& force_W) {
    if (plan.haptic.tool != nullptr) {
        return find_tail_beside_tool_W(*plan.haptic.tool, lesson.camera, tool_W, force_W);
    }
    const double below_m = lesson.bucket.present ? kArrowBelowBucket * lesson.bucket.depth_m : 0.0;
    return tool_W.position - Vector3(0.0, below_m, 0.0);
}

// The bar from the axis to where a force acts, at right angles to the axis.
ViewTorque show_torque(const AxleSettings& hinge, const Vector3& pivot_W, const Vector3& at_W,
                       const Vector3& force_W, double torque_Nm,
                       const dialogue::Catalogue& catalogue) {
    ViewTorque shown;
    shown.axis_W = pivot_W + hinge.axis_W.dot(at_W - pivot_W) * hinge.axis_W;
    const double force_N = force_W.norm();
    const double arm_m = force_N > 0.0 ? std::abs(torque_Nm) / force_N : 0.0;
    // What stands there must come out for who multiplies it: the product is that of the numbers shown.
    const std::string newtons = newtons_text(force_N);
    const std::string metres = number_text(arm_m, arm_m < kShortArm_m ? 3 : 2);
    const double product_Nm = std::stod(newtons) * std::stod(metres);
    shown.force = {true, at_W, force_W,
                   catalogue.say("hud.torque", {{"newtons", newtons},
                                                {"metres", metres},
                                                {"torque", number_text(product_Nm, 2)}})};
    return shown;
}

// What turns the bodies on hinges: the hand's push, and what hangs on a touched one.
void add_torques(const LessonDescription& lesson, const Scenery& scenery,
                 const dialogue::Catalogue& catalogue, View& view) {
    if (scenery.axles == nullptr) {
        return;
    }
    std::size_t axle = 0;
    for (const BodyDescription& body : lesson.bodies) {
        if (!body.hinge || axle >= scenery.axles->axles.size()) {
            continue;
        }
        const AxleReport& report = scenery.axles->axles[axle++];
        if (!report.touched || report.force_W.norm() <= kShownForce_N) {
            continue;
        }
        view.torques.push_back(show_torque(*body.hinge, report.pivot_W, report.at_W, report.force_W,
                                           report.torque_Nm, catalogue));
        if (report.load_N > 0.0) {
            view.torques.push_back(show_torque(*body.hinge, report.pivot_W, report.load_W,
                                               Vector3(0.0, -report.load_N, 0.0),
                                               report.load_torque_Nm, catalogue));
            view.torques.back().force.look = ForceLook::load;
        }
    }
}

// Each in a colour of its own, and with its number for whoever cannot tell colours apart: before its newtons, or beside it where it feels
// nothing. Forces are drawn to one scale.
void add_more_hands(const LessonDescription& lesson, const Scenery& scenery,
                    const dialogue::Catalogue& catalogue, View& view) {
    if (scenery.more_hands.empty()) {
        return;
    }
    if (view.force.visible) {
        view.force.text = force_text(catalogue, "1", view.force.force_W.norm());
    } else {
        view.tool.label = "1";
    }
    for (std::size_t i = 0; i < scenery.more_hands.size() && i < lesson.more_hands.size(); ++i) {
        const HandScenery& shown = scenery.more_hands[i];
        const std::string number = std::to_string(i + 2);
        ViewHand& hand = view.more_hands.emplace_back();
        const std::string& model = lesson.more_hands[i].cursor_model;
        hand.tool.model = model.empty() ? std::string(kSecondToolModel) : model;
        hand.tool.pose_W = {shown.hand.proxy_position_W, shown.hand.proxy_orientation_W};
        hand.ghost_visible = shown.ghost;
        hand.ghost_pose_W = shown.ghost_pose_W;
        const Vector3 force_W = shown.hand.applied_W.force;
        if (force_W.norm() > kShownForce_N) {
            view.forces.push_back({true, shown.hand.proxy_position_W, force_W,
                                   force_text(catalogue, number, force_W.norm()), ForceLook::lift});
        } else {
            hand.tool.label = number;
        }
    }
}

}  // namespace

View compose_view(const LessonDescription& lesson, const Plan& plan, const SessionHud& hud,
                  const Scenery& scenery, const dialogue::Catalogue& catalogue) {
    View view;
    view.time_s = scenery.time_s;
    view.camera = lesson.camera;
    view.ground_height_m = lesson.ground_height_m;
    view.in_space = lesson.in_space;
    add_bodies(lesson, hud, scenery, catalogue, view);

    show_tool(lesson, scenery, view);

    const Vector3 force_W = scenery.hand.applied_W.force;
    const double force_N = force_W.norm();
    if (force_N > kShownForce_N) {
        view.force = {true, find_arrow_tail_W(lesson, plan, view.tool.pose_W, force_W), force_W,
                      weight_text(lesson, plan, scenery, catalogue, force_N)};
    }

    add_more_hands(lesson, scenery, catalogue, view);

    // Where a torque is shown its arrow is the hand's push; the push back is the same, the other way round.
    add_torques(lesson, scenery, catalogue, view);
    view.force.visible = view.force.visible && view.torques.empty();
    add_kite(lesson, plan, hud, scenery, catalogue, view);
    if (hud.shown_hand_W) {
        view.bodies.push_back(
            show_hand(lesson.camera, scenery.still_hand_W.value_or(*hud.shown_hand_W)));
    }

    for (const SessionHud::Burst& burst : hud.bursts) {
        const double age_s = scenery.time_s - burst.at_s;
        if (!scenery.calm && age_s >= 0.0 && age_s < kBurstLasts_s) {
            view.bursts.push_back({burst.at_W, age_s});
        }
    }
    view.mood = hud.mood;

    view.title = lesson.title;
    view.caption = hud.caption;
    view.feedback = show_feedback(hud, catalogue);
    view.input_visible = hud.question_open;
    for (const BodyLight light : hud.lights) {
        if (light != BodyLight::off) {
            view.lights.push_back(light == BodyLight::lit);
        }
    }
    view.score = hud.score;
    view.level = hud.level;
    view.level_title = hud.level_title;
    view.stars = hud.stars;
    return view;
}

}  // namespace fulcrum::runtime
