#include "runtime/effect/rigid/declare_rigid.h"

#include "haptics/dynamics/world_plan.h"
#include "runtime/effect/body/body_fields.h"
#include "runtime/lua/api/lesson_context.h"
#include "runtime/lua/api/take_fields.h"
#include "runtime/scene/shape_models.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <string>

namespace fulcrum::runtime {
namespace {

constexpr double kLeastMass_kg = 0.001;  // a lighter one is no thing that a hand could feel

JointKind joint_kind_of(const std::string& name) {
    constexpr std::array<std::pair<std::string_view, JointKind>, 5> kKinds{
        {{"hinge", JointKind::hinge},
         {"slider", JointKind::slider},
         {"ball", JointKind::ball},
         {"fixed", JointKind::fixed},
         {"rod", JointKind::distance}}};
    return std::ranges::find(kKinds, std::string_view(name),
                             [](const auto& kind) { return kind.first; })
        ->second;
}

BodyShape shape_of(const std::string& name) {
    constexpr std::array<std::pair<std::string_view, BodyShape>, 6> kShapes{
        {{"box", BodyShape::box},
         {"ball", BodyShape::ball},
         {"cylinder", BodyShape::cylinder},
         {"capsule", BodyShape::capsule},
         {"hull", BodyShape::hull},
         {"mesh", BodyShape::mesh}}};
    return std::ranges::find(kShapes, std::string_view(name),
                             [](const auto& shape) { return shape.first; })
        ->second;
}

void check_joint(lua_State* lua, const LessonContext& context, const JointDescription& joint,
                 const Arguments& arguments, const BodyDescription& body) {
    const auto& bodies = context.description.bodies;
    const bool is_known = joint.to.empty() || std::ranges::any_of(bodies, [&](const auto& other) {
                              return other.name == joint.to && other.rigid;
                          });
    if (!is_known) {
        raise_in_lesson(lua, "the joint of " + body.name + " is to \"" + joint.to +
                                 "\", which is no rigid body that was declared before");
    }
    const bool has_axis = joint.kind == JointKind::hinge || joint.kind == JointKind::slider;
    for (const char* name : {"axis", "lowest", "highest", "speed", "force", "friction"}) {
        if (!has_axis && arguments[name].given) {
            raise_in_lesson(lua, std::string("only a hinge or a slider has ") + name +
                                     "; leave it out of the joint of " + body.name);
        }
    }
    if (has_axis && joint.axis_W.norm() < 0.01) {
        raise_in_lesson(lua,
                        "the axis of " + body.name + " has no direction; {0, 1, 0} stands upright");
    }
    if (joint.kind == JointKind::distance && (joint.at_W - joint.other_at_W).norm() < 1.0e-3) {
        raise_in_lesson(
            lua, "the rod of " + body.name + " has no length; give it at = … and end_at = …");
    }
    if (joint.kind != JointKind::distance && arguments["end_at"].given) {
        raise_in_lesson(lua, "only a rod has end_at; leave it out of the joint of " + body.name);
    }
}

JointDescription take_joint(lua_State* lua, const LessonContext& context,
                            const Arguments& arguments, const BodyDescription& body) {
    JointDescription joint;
    take_fields(fields::kJoint, arguments, joint);
    joint.kind = joint_kind_of(arguments["kind"].text);
    joint.to = arguments["to"].given ? arguments["to"].text : "";
    joint.at_W = arguments["at"].given ? arguments["at"].vector : body.position_W;
    joint.other_at_W = arguments["end_at"].given ? arguments["end_at"].vector : body.position_W;
    const double unit = joint.kind == JointKind::hinge ? 1.0 / kDegrees : 1.0;
    if (arguments["lowest"].given) {
        joint.lowest = unit * arguments["lowest"].number;
    }
    if (arguments["highest"].given) {
        joint.highest = unit * arguments["highest"].number;
    }
    joint.speed = unit * arguments["speed"].number;
    check_joint(lua, context, joint, arguments, body);
    return joint;
}

/// The volume of a shape whose size the lesson knows.
double find_volume_m3(lua_State* lua, const BodyDescription& body) {
    const std::string model = as_simulated(body).model;
    if (model == kBoxModel) {
        return box_size_m(body).prod();
    }
    if (!is_ball_model(model)) {
        const std::string near =
            nearest_word(model, {std::string(kBoxModel), std::string(kSphereModel)});
        raise_in_lesson(lua, body.name + " has a density, and no volume is known of model = \"" +
                                 model + "\", only of \"" + std::string(kBoxModel) + "\" and \"" +
                                 std::string(kSphereModel) + "\"; " +
                                 (near.empty() ? "" : "did you mean \"" + near + "\"? If not, ") +
                                 "give it a mass instead");
    }
    return 4.0 / 3.0 * std::numbers::pi * body.radius_m * body.radius_m * body.radius_m;
}

void take_size(lua_State* lua, const Argument& size, BodyDescription& body) {
    if (!size.given) {
        return;
    }
    if (body.model != kBoxModel && body.felt_model != kBoxModel &&
        body.simulated_model != kBoxModel) {
        raise_in_lesson(lua, body.name +
                                 " has a size, and only a body with model = \"box\" can; "
                                 "give it a radius");
    }
    if (size.vector.minCoeff() < 0.002) {
        raise_in_lesson(lua, "each edge of " + body.name + " is at least 0.002 m long");
    }
    body.size_m = size.vector;
    body.radius_m = 0.5 * size.vector.maxCoeff();
}

void take_boxes(lua_State* lua, const Arguments& arguments, BodyDescription& body) {
    const Argument& boxes = arguments["boxes"];
    if (!boxes.given) {
        return;
    }
    if (body.model != kBoxModel || arguments["size"].given) {
        raise_in_lesson(lua, body.name + " is made of boxes; give it model = \"box\", and no size");
    }
    if (body.movable || arguments["hinge"].given || arguments["rigid"].flag) {
        raise_in_lesson(lua, body.name +
                                 " is made of boxes and stands still; leave out movable, hinge and "
                                 "rigid");
    }
    body.boxes = boxes.boxes;
    double farthest_m = 0.0;
    for (const PlacedBox& box : body.boxes) {
        farthest_m = std::max(farthest_m, (box.at_B.cwiseAbs() + 0.5 * box.size_m).maxCoeff());
    }
    body.radius_m = std::min(farthest_m, 10.0);
}

// What is felt of it and what is simulated, beside what is seen.
void take_models(lua_State* lua, const Arguments& arguments, BodyDescription& body) {
    const bool is_touched = body.solid || arguments["rigid"].flag;
    const auto take = [&](const char* name, const char* does, std::string& model) {
        const Argument& given = arguments[name];
        if (!given.given) {
            return;
        }
        if (!is_touched) {
            raise_in_lesson(lua, body.name + " has a " + name +
                                     " but can't be touched; add solid = true or rigid = true");
        }
        if (given.text == kOrbitModel) {
            raise_in_lesson(lua, "an orbit is a thin line, which cannot be " + std::string(does) +
                                     "; give " + body.name + " another " + name);
        }
        model = given.text;
    };
    take("felt_model", "felt", body.felt_model);
    take("simulated_model", "simulated", body.simulated_model);
    if (arguments["felt_shape"].given) {
        if (!is_touched) {
            raise_in_lesson(lua, body.name +
                                     " has a felt_shape but can't be touched; add solid = true or "
                                     "rigid = true");
        }
        body.felt_as = shape_of(arguments["felt_shape"].text);
    }
    if (arguments["shape"].given) {
        if (!is_touched) {
            raise_in_lesson(lua, body.name + " has a shape and is not rigid; add rigid = true");
        }
        body.collides_as = shape_of(arguments["shape"].text);
    }
    for (const char* name : {"simulated_model", "shape"}) {
        if (arguments[name].given && arguments["hinge"].given) {
            raise_in_lesson(lua, body.name +
                                     " turns on a hinge of the hand and meets no rigid "
                                     "body; leave out " +
                                     name);
        }
    }
}

// What only a rigid body has, and a mass that no movable one could fall with.
void refuse_rigid_fields(lua_State* lua, const Arguments& arguments, const BodyDescription& body) {
    for (const char* name : {"density", "joint"}) {
        if (arguments[name].given) {
            raise_in_lesson(lua,
                            body.name + " has a " + name + " and is not rigid; add rigid = true");
        }
    }
    if (body.movable && body.mass_kg < kLeastFalling_kg) {
        raise_in_lesson(lua, body.name +
                                 " is movable and has no mass that could fall; give it a mass of "
                                 "0.000001 kg or more");
    }
}

}  // namespace

void take_rigid(lua_State* lua, const LessonContext& context, const Arguments& arguments,
                BodyDescription& body) {
    take_models(lua, arguments, body);
    take_size(lua, arguments["size"], body);
    take_boxes(lua, arguments, body);
    if (!arguments["rigid"].flag) {
        refuse_rigid_fields(lua, arguments, body);
        return;
    }
    if (body.movable || arguments["hinge"].given) {
        raise_in_lesson(lua, body.name + " is rigid and " +
                                 (body.movable ? "movable" : "on a hinge of the hand") +
                                 "; leave out one of them: a rigid body falls by itself, and has "
                                 "joint = { kind = \"hinge\", … }");
    }
    if (std::ranges::any_of(context.description.bodies,
                            [](const BodyDescription& other) { return other.movable; })) {
        raise_in_lesson(lua, body.name +
                                 " is rigid, and another body is movable; a lesson has "
                                 "bodies of one of both kinds");
    }
    body.rigid.emplace();
    body.solid = true;
    body.visible = arguments["visible"].given ? arguments["visible"].flag : true;
    if (arguments["density"].given) {
        if (arguments["mass"].given) {
            raise_in_lesson(lua, body.name + " has a mass and a density; leave out one of them");
        }
        body.mass_kg = arguments["density"].number * find_volume_m3(lua, body);
    }
    if (body.mass_kg < kLeastMass_kg || body.mass_kg > fields::kMostBodyMass_kg) {
        raise_in_lesson(lua, body.name + " is rigid and has a mass of " +
                                 std::to_string(body.mass_kg) + " kg; give it 0.001 to 10000");
    }
    if (arguments["joint"].given) {
        body.rigid->joint = take_joint(lua, context, arguments.record("joint"), body);
    }
}

}  // namespace fulcrum::runtime
