// What a lesson says of a hand: where it works, and what it touches with.
#pragma once

#include "haptics/loop/haptic_plan.h"
#include "runtime/effect/field_list.h"
#include "runtime/effect/tool/tool_fields.h"
#include "runtime/scene/description.h"
#include "runtime/scene/lesson_limits.h"

namespace fulcrum::runtime::fields {

using enum ParameterType;

inline constexpr auto kToolRows = parameters_of(kTool);

inline constexpr std::tuple kHand{
    field(&HandDescription::centre_W,
          {"centre", vector, "metres", -kMaxCoordinate_m, kMaxCoordinate_m, "{0, 0.3, 0}",
           "where the middle of the arm's reach lies"}),
    field(&HandDescription::scale,
          {"scale", number, "", 0.01, 100, "1",
           "metres in the scene for one metre of a hand that reaches 20 cm each way; one that "
           "reaches less gets more"}),
    field(&HandDescription::rate_hz, {"rate", number, "hertz", kLeastRate_Hz, kMostRate_Hz, "1000",
                                      "how often forces are computed; what is stiff or rings "
                                      "wants more, a slow computer has time for less"}),
    field(&HandDescription::velocity,
          {"velocity", choice, "", 0, 0, "adaptive_window",
           "how the hand's speed is found from its places, by the name of the method: what damps "
           "and sounds goes by it",
           "filtered_difference adaptive_window finite_difference kalman"}),
    field(&HandDescription::structure,
          {"structure", choice, "", 0, 0, "bounding_tree",
           "of proxy = \"god_object\" with a point: how the triangle that it meets is found; "
           "where it goes is the same with both",
           "bounding_tree h_collide"}),
    argument({"proxy", choice, "", 0, 0, "nil",
              "what solid bodies are touched with, by the name of its method; what the scene "
              "needs by "
              "default: friction_cone where something has friction",
              "god_object virtual_proxy friction_cone"}),
    argument({"cursor", choice, "", 0, 0, "point",
              "the shape that touches; a ball is for virtual_proxy and friction_cone, the "
              "others for "
              "friction_cone alone, and turn as the hand does, without a torque; a hull is that of "
              "cursor_model",
              "point ball box capsule cylinder hull"}),
    field(&HandDescription::cursor_model,
          {"cursor_model", name, "", 0, 48, "nil",
           "model, in its own size, whose hull is the cursor: what is tightly wrapped round it, "
           "without its hollows"}),
    argument({"cursor_size", number, "metres", 0.0005, 1, "0.005",
              "its radius, or half its side; a capsule and a cylinder are so long to each side, "
              "a capsule without its round ends; a hull has the size of its model"}),
    argument({"tool", record, "", 0, 0, "nil",
              "what the hand holds instead of a cursor: a thing with a shape, felt with force and "
              "torque, that stays outside solid bodies, at most 16 of them, without a material; "
              "where "
              "the hand is pressed in, a pale ghost of it shows where the hand is; a hand that "
              "cannot "
              "turn holds it upright; no bucket goes with it",
              "", kToolRows.data(), kToolRows.size()}),
    field(&HandDescription::needed,
          {"needed", flag, "", 0, 0, "false",
           "of a second hand: without a device for it the lesson is not played"})};

}  // namespace fulcrum::runtime::fields
