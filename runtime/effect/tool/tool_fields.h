// What a lesson says of the tool that a hand may hold instead of a cursor.
#pragma once

#include "runtime/effect/field_list.h"
#include "runtime/scene/description.h"

namespace fulcrum::runtime::fields {

using enum ParameterType;

inline constexpr std::tuple kTool{
    argument({"shape", choice, "", 0, 0, "cylinder", "what it is like; it stands upright",
              "ball box capsule cylinder"}),
    field(
        &ToolDescription::model,
        {"model", name, "", 0, 48, "nil",
         "a model instead, in its own size, held at its origin; sphere, box and the planets are as "
         "large "
         "as the radius says"}),
    argument({"radius", number, "metres", 0.001, 1, "0.02",
              "of a ball, a capsule or a cylinder; a box is twice so wide and deep; other models "
              "have none"}),
    argument({"length", number, "metres", 0.002, 2, "0.1",
              "from end to end, a capsule's round ends included; a ball and a model have none"}),
    field(&ToolDescription::mass_kg,
          {"mass", number, "kilograms", 0.005, 1, "0.02",
           "as the hand feels it near a body; in free air nothing is felt; not with massless"}),
    field(&ToolDescription::stiffness_N_per_m, {"stiffness", number, "newtons per metre", 50, 2000,
                                                "500", "of the spring between hand and tool"}),
    field(
        &ToolDescription::turn_stiffness_Nm_per_rad,
        {"turn_stiffness", number, "newton metres per radian", 0.001, 10, "nil",
         "of the spring that turns it as the hand turns; by default as stiff at its far end as the "
         "other "
         "spring; what is felt of it is at most 0.3 newton metres, and less where the program is "
         "told "
         "to "
         "be gentler"}),
    field(&ToolDescription::voxel_m, {"voxel", number, "metres", 0.0001, 1, "nil",
                                      "side of the cubes that bodies are made of for it; smaller "
                                      "follows their shape more closely "
                                      "and takes more memory: at most 480 along a body and 64 "
                                      "million in all; fine enough for each "
                                      "body by default, and for all together"}),
    field(
        &ToolDescription::points,
        {"points", integer, "", 100, 200000, "nil",
         "on its surface; more follow it more closely and take more time; by default 2000, and for "
         "voxel_sampling one a voxel of the tool, as far as a step has time for them: with fewer "
         "it "
         "pushes sideways beside edges"}),
    field(&ToolDescription::method,
          {"method", choice, "", 0, 0, "field_sampling",
           "how it is kept outside bodies, by the name of the method: points on it by the distance "
           "to "
           "their surface, or by cubes that they are made of; or by planes that a few clusters of "
           "contact lie on, which hold even where contact is found late (implicit_penalty); or all "
           "of "
           "its triangles, which never get into theirs, however thin they are, and which alone "
           "feel the "
           "friction and the texture of their materials (god_object: mass, points and voxel say "
           "nothing "
           "then)",
           "field_sampling voxel_sampling implicit_penalty god_object"}),
    field(&ToolDescription::massless, {"massless", flag, "", 0, 0, "false",
                                       "it has no mass of its own: nothing smooths what it meets"}),
    field(
        &ToolDescription::integrator,
        {"integrator", choice, "", 0, 0, "backward_euler",
         "how it is moved on; all but backward_euler want a heavy tool and a soft spring; not with "
         "massless",
         "explicit_euler semi_implicit_euler verlet runge_kutta_4 backward_euler"}),
    field([](auto& tool) -> auto& { return tool.shading.on; },
          {"rounded", flag, "", 0, 0, "false",
           "its facets are felt as one even surface, as far as its creases; for god_object"}),
    field([](auto& tool) -> auto& { return tool.shading.crease_angle_deg; },
          {"crease", number, "degrees", 0, kMostCrease_deg, "30",
           "of a rounded tool: an edge that bends more than this stays sharp"}),
    field(
        &ToolDescription::contact,
        {"contact", choice, "", 0, 0, "fields",
         "of implicit_penalty: how it is found where the tool is near a body: points on it by the "
         "distance to the surface, or its triangles and theirs by levels of detail, as finely as "
         "can "
         "be felt, which take some seconds to make the first time (levels: voxel and points say "
         "nothing then)",
         "fields levels"}),
    field(&ToolDescription::detail,
          {"detail", number, "of the tool's size", 0, kMostDetail, "0.025",
           "of contact = \"levels\": what may be felt as one; 0 is as fine as the meshes, and so "
           "is the "
           "default beside a budget; nothing gets through, however coarse it is"}),
    field(&ToolDescription::budget_us,
          {"budget", number, "microseconds", 20, 500, "nil",
           "of contact = \"levels\": how long finding contacts may take in each step of a live "
           "run, as "
           "finely as there is time, and no finer than the detail; half a step by default"}),
    field(&ToolDescription::contact_model,
          {"contact_model", choice, "", 0, 0, "planes",
           "of implicit_penalty: how what was found pushes until it is found anew: each cluster "
           "as a plane that never pulls, or by the force and its slopes there, which go on as "
           "straight as they began",
           "planes linearised"})};

}  // namespace fulcrum::runtime::fields
