// What a lesson says of a thing in its scene.
#pragma once

#include "runtime/effect/field_list.h"
#include "runtime/effect/hinge/hinge_fields.h"
#include "runtime/effect/rigid/joint_fields.h"
#include "runtime/scene/description.h"
#include "runtime/scene/lesson_limits.h"

namespace fulcrum::runtime::fields {

using enum ParameterType;

inline constexpr double kLeastRadius_m = 0.001;
inline constexpr double kMostRadius_m = 10.0;
inline constexpr double kMostBodyMass_kg = 1e4;

inline constexpr auto kHingeRows = parameters_of(kHinge);
inline constexpr auto kJointRows = parameters_of(kJoint);

inline constexpr std::tuple kBody{
    field(&BodyDescription::name, {"name", name, "", 0, 0, kRequired,
                                   "unique; how the lesson calls it, never the learner"}),
    field(&BodyDescription::noun, {"noun", text, "", 0, 64, "nil",
                                   "English noun, as answers give it; the name by default, "
                                   "\"\" for scenery that no answer "
                                   "names; seen beside a movable body, and "
                                   "beside a solid one where it is not just its name"}),
    field(&BodyDescription::model,
          {"model", name, "", 0, 0, "nil", "model to draw, see Models; the name by default"}),
    field(&BodyDescription::radius_m,
          {"radius", number, "metres", kLeastRadius_m, kMostRadius_m, "0.05", ""}),
    field(&BodyDescription::seen_scale,
          {"scale", number, "", 0.01, 100, "1",
           "how large a thing that can't be touched is drawn, times its model"}),
    field(&BodyDescription::mass_kg,
          {"mass", number, "kilograms", 0, kMostBodyMass_kg, "1", "the true mass"}),
    field(&BodyDescription::exaggeration,
          {"exaggeration", number, "", 0, 100, "1",
           "felt weight / true weight, before all are made to fit the arm"}),
    field(&BodyDescription::movable,
          {"movable", flag, "", 0, 0, "false", "may fall, be caught and be held"}),
    field(&BodyDescription::solid, {"solid", flag, "", 0, 0, "false", "can be touched"}),
    argument(
        {"material", material, "", 0, 0, "nil",
         "what a solid body is made of, see Materials: \"wood\", or what world:material gave"}),
    field([](auto& body) -> auto& { return body.shading.on; },
          {"rounded", flag, "", 0, 0, "false",
           "a solid body's facets are felt as one, even over bends of up to its crease"}),
    field([](auto& body) -> auto& { return body.shading.crease_angle_deg; },
          {"crease", number, "degrees", 0, kMostCrease_deg, "30",
           "of a rounded body: an edge that bends more than this stays sharp"}),
    field(&BodyDescription::visible,
          {"visible", flag, "", 0, 0, "false", "is seen from the start"}),
    field(&BodyDescription::position_W, {"at", vector, "metres", -kMaxCoordinate_m,
                                         kMaxCoordinate_m, "{0, 0, 0}", "where it is at first"}),
    field(&BodyDescription::drag_area_m2, {"drag_area", number, "square metres", 0, 10, "0",
                                           "drag coefficient × cross-section, for falling in air"}),
    argument({"hinge", record, "", 0, 0, "nil",
              "an axis that a solid body turns about, pushed by the hand; while it is, arm, "
              "force and "
              "torque are drawn",
              "", kHingeRows.data(), kHingeRows.size()}),
    argument({"size", vector, "metres", 0, kMostEdge_m, "nil",
              "edges of a body with model = \"box\": width, height, depth; twice the radius by "
              "default"}),
    field(&BodyDescription::about,
          {"about", text, "", 0, 300, "",
           "what is said of a solid body when it is first touched, of a movable one when it is "
           "first caught, while no question is open"}),
    argument({"boxes", boxes, "", 0, 0, "nil",
              "what a body with model = \"box\" is made of instead of one: a list of { at = {x, y, "
              "z}, size = {x, y, z} }, from the body's place; up to 200, as of a house or a maze"}),
    argument(
        {"rigid", flag, "", 0, 0, "false",
         "a thing with a mass that lies, falls, is pushed, gripped with the button, lifted and "
         "stacked; can be touched, and is seen unless visible = false"}),
    argument({"felt_model", name, "", 0, 0, "nil",
              "model that the hand feels instead of the one that is drawn; of a box or a ball with "
              "its size or radius"}),
    argument({"felt_shape", choice, "", 0, 0, "nil",
              "what the hand feels of that model, as large as it reaches: a ball, a box, a "
              "cylinder or "
              "capsule about the axis across which it is roundest, all without facets, or its "
              "hull; by "
              "default a ball is one, and others are as they are",
              "box ball cylinder capsule hull mesh"}),
    argument({"simulated_model", name, "", 0, 0, "nil",
              "model that rigid bodies meet instead of the one that is felt, as a simple one "
              "of many "
              "triangles"}),
    argument(
        {"shape", choice, "", 0, 0, "nil",
         "what a rigid body, or a solid one among them, collides as; by default a box or a "
         "ball "
         "as its model, else the hull of its model; mesh is the model itself with its hollows, "
         "as of a ring or a bowl",
         "box ball cylinder capsule hull mesh"}),
    argument({"density", number, "kilograms per cubic metre", 1, 25000, "nil",
              "of a rigid box or ball, instead of its mass: wood 600, water 1000, iron 7900"}),
    argument({"joint", record, "", 0, 0, "nil", "what a rigid body hangs on", "", kJointRows.data(),
              kJointRows.size()})};

}  // namespace fulcrum::runtime::fields
