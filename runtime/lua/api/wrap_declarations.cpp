// What L:start(world) declares: bodies, forces, bucket, view.
#include "runtime/lua/api/binding_table.h"
#include "runtime/lua/api/hinge_place.h"
#include "runtime/lua/api/lesson_context.h"
#include "runtime/lua/api/materials.h"
#include "runtime/lua/api/rigid_bodies.h"
#include "runtime/scene/shape_models.h"

#include <algorithm>
#include <iterator>

namespace fulcrum::runtime {
namespace {

constexpr double kFar_m = kMaxCoordinate_m;

int set_gravity(lua_State* /*lua*/, LessonContext& context, const Arguments& arguments) {
    context.description.gravity_W = Vector3(0.0, -arguments["acceleration"].number, 0.0);
    return 0;
}

int set_ground(lua_State* /*lua*/, LessonContext& context, const Arguments& arguments) {
    context.description.ground_height_m = arguments["height"].number;
    return 0;
}

int set_space(lua_State* /*lua*/, LessonContext& context, const Arguments& /*arguments*/) {
    context.description.in_space = true;
    return 0;
}

int recall(lua_State* /*lua*/, LessonContext& context, const Arguments& /*arguments*/) {
    context.description.wants_past = true;
    return 0;
}

int set_camera(lua_State* /*lua*/, LessonContext& context, const Arguments& arguments) {
    CameraDescription& camera = context.description.camera;
    camera.eye_W = arguments["eye"].vector;
    camera.target_W = arguments["target"].vector;
    camera.vertical_angle_deg = arguments["angle"].number;
    return 0;
}

// What a body turns about.
constexpr Parameter kHinge[] = {
    {"axis", ParameterType::vector, "", -1, 1, kRequired,
     "along which it lies: {0, 0, 1} points at you, as of a lever, {0, 1, 0} stands upright, as "
     "of a door; when it points at you, angles grow counter-clockwise"},
    {"at", ParameterType::vector, "metres", -kFar_m, kFar_m, "nil",
     "a place that the axis passes through, at most 100 m from the body; where the body is by "
     "default"},
    {"inertia", ParameterType::number, "kilogram square metres", kLeastAxleInertia_kg_m2,
     kMostAxleInertia_kg_m2, kRequired,
     "how hard it is to turn, with all that hangs on it; a body with a mass is harder to turn on a "
     "support farther from its middle"},
    {"friction", ParameterType::number, "newton metres", 0, kMostAxleFriction_Nm, "0",
     "the torque that brakes it"},
    {"lowest", ParameterType::number, "degrees", -1e6, 1e6, "nil",
     "it turns no further; no end by default"},
    {"highest", ParameterType::number, "degrees", -1e6, 1e6, "nil",
     "it turns no further; no end by default"},
    {"load", ParameterType::number, "newtons", 0, kMostAxleLoad_N, "0",
     "a weight that hangs on it"},
    {"load_at", ParameterType::vector, "metres", -kFar_m, kFar_m, "nil",
     "where it hangs at first, at most 100 m from the body; where the body is by default"}};

AxleSettings take_hinge(lua_State* lua, const Arguments& arguments, const BodyDescription& body) {
    AxleSettings hinge;
    hinge.axis_W = arguments["axis"].vector;
    const double length = hinge.axis_W.norm();
    if (!body.solid) {
        raise_in_lesson(lua, body.name + " has a hinge but can't be touched; add solid = true");
    }
    if (body.movable) {
        raise_in_lesson(lua, body.name + " has a hinge and is movable; leave out one of them");
    }
    if (length < 0.01) {
        raise_in_lesson(lua,
                        "the axis of " + body.name + " has no direction; {0, 1, 0} stands upright");
    }
    hinge.axis_W /= length;
    if (arguments["at"].given) {
        hinge.pivot_B = place_on_hinge(lua, body, "hinge", arguments["at"].vector);
    }
    hinge.inertia_kg_m2 = arguments["inertia"].number;
    hinge.friction_Nm = arguments["friction"].number;
    if (arguments["lowest"].given) {
        hinge.lowest_rad = arguments["lowest"].number / kDegrees;
    }
    if (arguments["highest"].given) {
        hinge.highest_rad = arguments["highest"].number / kDegrees;
    }
    if (hinge.lowest_rad > hinge.highest_rad || hinge.lowest_rad > 0.0 || hinge.highest_rad < 0.0) {
        raise_in_lesson(lua,
                        "the hinge of " + body.name +
                            " begins at 0 degrees; lowest is at most 0, and highest at least 0");
    }
    hinge.load_N = arguments["load"].number;
    if (arguments["load_at"].given) {
        hinge.load_B = place_on_hinge(lua, body, "load", arguments["load_at"].vector);
    }
    return hinge;
}

int add_body(lua_State* lua, LessonContext& context, const Arguments& arguments) {
    std::vector<BodyDescription>& bodies = context.description.bodies;
    BodyDescription body;
    body.name = arguments["name"].text;
    body.noun = arguments["noun"].given ? arguments["noun"].text : body.name;
    body.model = arguments["model"].given ? arguments["model"].text : body.name;
    body.radius_m = arguments["radius"].number;
    body.mass_kg = arguments["mass"].number;
    body.exaggeration = arguments["exaggeration"].number;
    body.drag_area_m2 = arguments["drag_area"].number;
    body.solid = arguments["solid"].flag;
    body.rounded = arguments["rounded"].flag;
    body.movable = arguments["movable"].flag;
    body.visible = arguments["visible"].flag;
    body.position_W = arguments["at"].vector;
    body.line = place_in_lesson(lua).line;
    body.about = arguments["about"].text;
    take_rigid(lua, context, arguments, body);
    if (body.movable && std::ranges::any_of(bodies, [](const BodyDescription& other) {
            return other.rigid.has_value();
        })) {
        raise_in_lesson(lua, body.name +
                                 " is movable, and another body is rigid; a lesson has "
                                 "bodies of one of both kinds");
    }
    if (arguments["hinge"].given) {
        body.hinge = take_hinge(lua, arguments.record("hinge"), body);
        // Only a mass that the lesson gives is known to be that of its inertia.
        body.hinge->mass_kg = arguments["mass"].given ? body.mass_kg : 0.0;
    }
    if (!body.about.empty() && !body.solid && !body.movable) {
        raise_in_lesson(lua, body.name + " has about but can't be touched; add solid = true");
    }
    if (body.solid && as_felt(body).model == kOrbitModel) {
        raise_in_lesson(
            lua, body.name + " is an orbit, a thin line, seen and not felt; leave out solid");
    }
    if ((body.rounded || arguments["material"].given) && !body.solid) {
        raise_in_lesson(lua, body.name + (body.rounded ? " is rounded" : " has a material") +
                                 " but can't be touched; add solid = true");
    }
    if (std::ranges::count(bodies, body.name, &BodyDescription::name) > 0) {
        raise_in_lesson(
            lua, "there is already a body \"" + body.name + "\"; give this one another name");
    }
    if (bodies.size() >= static_cast<std::size_t>(kMaxBodies)) {
        raise_in_lesson(lua, "a lesson has at most " + std::to_string(kMaxBodies) + " bodies");
    }
    const auto n_solids = std::ranges::count_if(bodies, &BodyDescription::solid);
    if (body.solid && n_solids >= kMaxSolids) {
        raise_in_lesson(lua,
                        "a lesson has at most " + std::to_string(kMaxSolids) + " solid bodies");
    }
    body.material = find_or_add_material(lua, context, arguments["material"]);
    bodies.push_back(std::move(body));
    push_handle(lua, Handle::Kind::body, static_cast<std::int32_t>(bodies.size()) - 1);
    return 1;
}

int set_bucket(lua_State* lua, LessonContext& context, const Arguments& arguments) {
    BucketDescription& bucket = context.description.bucket;
    bucket.present = true;
    bucket.model = arguments["model"].text;
    bucket.opening_radius_m = arguments["radius"].number;
    bucket.depth_m = arguments["depth"].number;
    bucket.holds = static_cast<int>(arguments["holds"].number);
    bucket.line = place_in_lesson(lua).line;
    return 0;
}

/// The first of "spring1", "spring2" … that no force has.
std::string free_name(const std::vector<ForceDescription>& forces, const std::string& kind) {
    std::string name;
    for (std::size_t number = 1;; ++number) {
        name = kind + std::to_string(number);
        if (std::none_of(forces.begin(), forces.end(),
                         [&](const ForceDescription& force) { return force.name == name; })) {
            return name;
        }
    }
}

int add_force(lua_State* lua, LessonContext& context, const Argument& name, const char* kind,
              const FieldPlan& field) {
    std::vector<ForceDescription>& forces = context.description.forces;
    if (forces.size() >= static_cast<std::size_t>(kMaxFields)) {
        raise_in_lesson(lua, "a lesson has at most " + std::to_string(kMaxFields) +
                                 " springs, magnets and viscosities");
    }
    ForceDescription force{name.given ? name.text : free_name(forces, kind), field,
                           place_in_lesson(lua).line};
    if (std::ranges::count(forces, force.name, &ForceDescription::name) > 0) {
        raise_in_lesson(
            lua, "there is already a force \"" + force.name + "\"; give this one another name");
    }
    forces.push_back(std::move(force));
    context.fields.push_back(FieldCommand{true, field.anchor_W, 1.0});
    push_handle(lua, Handle::Kind::force, static_cast<std::int32_t>(forces.size()) - 1);
    return 1;
}

int add_spring(lua_State* lua, LessonContext& context, const Arguments& arguments) {
    FieldPlan field;
    field.kind = FieldKind::spring;
    field.anchor_W = arguments["at"].vector;
    field.stiffness_N_per_m = arguments["stiffness"].number;
    field.damping_Ns_per_m = arguments["damping"].number;
    return add_force(lua, context, arguments["name"], "spring", field);
}

int add_viscosity(lua_State* lua, LessonContext& context, const Arguments& arguments) {
    FieldPlan field;
    field.kind = FieldKind::viscosity;
    field.damping_Ns_per_m = arguments["damping"].number;
    return add_force(lua, context, arguments["name"], "viscosity", field);
}

int add_magnet(lua_State* lua, LessonContext& context, const Arguments& arguments) {
    FieldPlan field;
    field.kind = FieldKind::magnet;
    field.anchor_W = arguments["at"].vector;
    field.peak_force_N = arguments["force"].number;
    field.range_m = arguments["range"].number;
    return add_force(lua, context, arguments["name"], "magnet", field);
}

void add_scene_rows(ApiTable& table) {
    using enum ParameterType;
    table.functions.push_back(
        {"world",
         "gravity",
         CallShape::positional,
         CallTime::declaring,
         {{"acceleration", number, "metres per second squared", 0, kMostGravity_m_per_s2, kRequired,
           "downwards; 9.81 on Earth, 1.62 on the Moon"}},
         "",
         "Sets how strongly things fall.",
         &set_gravity});
    table.functions.push_back({"world",
                               "ground",
                               CallShape::positional,
                               CallTime::declaring,
                               {{"height", number, "metres", -kFarthestGround_m, kFarthestGround_m,
                                 kRequired, "where bodies land"}},
                               "",
                               "Sets the height of the ground.",
                               &set_ground});
    table.functions.push_back({"world",
                               "space",
                               CallShape::positional,
                               CallTime::declaring,
                               {},
                               "",
                               "Shows a dark sky with stars instead of a meadow.",
                               &set_space});
    table.functions.push_back(
        {"world",
         "recall",
         CallShape::positional,
         CallTime::declaring,
         {},
         "",
         "Asks for what this learner has answered in earlier sessions, of this lesson and others: "
         "world.past has it, a table for each question.",
         &recall});
    table.functions.push_back(
        {"world",
         "camera",
         CallShape::record,
         CallTime::declaring,
         {{"eye", vector, "metres", -kFar_m, kFar_m, "{0, 0.55, 1.5}", "where the camera is"},
          {"target", vector, "metres", -kFar_m, kFar_m, "{0, 0.35, 0}", "what it looks at"},
          {"angle", number, "degrees", kLeastView_deg, kMostView_deg, "40",
           "how much it sees, from top to bottom"}},
         "",
         "Places the camera.",
         &set_camera});
    table.functions.push_back(
        {"world",
         "body",
         CallShape::record,
         CallTime::declaring,
         {{"name", name, "", 0, 0, kRequired, "unique; how the lesson calls it, never the learner"},
          {"noun", text, "", 0, kMostNounBytes, "nil",
           "English noun, as answers give it; the name by default, \"\" for scenery that no answer "
           "names; seen beside a movable body, and "
           "beside a solid one where it is not just its name"},
          {"model", name, "", 0, 0, "nil", "model to draw, see Models; the name by default"},
          {"radius", number, "metres", kLeastRadius_m, kMostRadius_m, "0.05", ""},
          {"mass", number, "kilograms", 0, kMostBodyMass_kg, "1", "the true mass"},
          {"exaggeration", number, "", 0, kMostExaggeration, "1",
           "felt weight / true weight, before all are made to fit the arm"},
          {"movable", flag, "", 0, 0, "false", "may fall, be caught and be held"},
          {"solid", flag, "", 0, 0, "false", "can be touched"},
          {"material", material, "", 0, 0, "nil",
           "what a solid body is made of, see Materials: \"wood\", or what world:material gave"},
          {"rounded", flag, "", 0, 0, "false",
           "a solid body's facets are felt as one, even over bends of up to 30 degrees"},
          {"visible", flag, "", 0, 0, "false", "is seen from the start"},
          {"at", vector, "metres", -kFar_m, kFar_m, "{0, 0, 0}", "where it is at first"},
          {"drag_area", number, "square metres", 0, kMostDragArea_m2, "0",
           "drag coefficient × cross-section, for falling in air"},
          {"hinge", record, "", 0, 0, "nil",
           "an axis that a solid body turns about, pushed by the hand; while it is, arm, force and "
           "torque are drawn",
           "", kHinge, std::size(kHinge)},
          {"size", vector, "metres", 0, kMostEdge_m, "nil",
           "edges of a body with model = \"box\": width, height, depth; twice the radius by "
           "default"},
          {"about", text, "", 0, kMostAboutBytes, "",
           "what is said of a solid body when it is first touched, of a movable one when it is "
           "first caught, while no question is open"},
          {"boxes", boxes, "", 0, 0, "nil",
           "what a body with model = \"box\" is made of instead of one: a list of { at = {x, y, "
           "z}, size = {x, y, z} }, from the body's place; up to 200, as of a house or a maze"},
          {"rigid", flag, "", 0, 0, "false",
           "a thing with a mass that lies, falls, is pushed, gripped with the button, lifted and "
           "stacked; can be touched, and is seen unless visible = false"},
          {"felt_model", name, "", 0, 0, "nil",
           "model that the hand feels instead of the one that is drawn; of a box or a ball with "
           "its size or radius"},
          felt_shape_parameter(),
          {"simulated_model", name, "", 0, 0, "nil",
           "model that rigid bodies meet instead of the one that is felt, as a simple one of many "
           "triangles"},
          shape_parameter(),
          {"density", number, "kilograms per cubic metre", 1, 25000, "nil",
           "of a rigid box or ball, instead of its mass: wood 600, water 1000, iron 7900"},
          {"joint", record, "", 0, 0, "nil", "what a rigid body hangs on", "",
           joint_parameters().data(), joint_parameters().size()}},
         "Body",
         "Declares a thing.",
         &add_body});
    table.functions.push_back(
        {"world",
         "bucket",
         CallShape::record,
         CallTime::declaring,
         {{"model", name, "", 0, 0, "bucket", "model to draw, see Models"},
          {"radius", number, "metres", kLeastRadius_m, kMostRadius_m, "0.11", "of the opening"},
          {"depth", number, "metres", kLeastRadius_m, kMostRadius_m, "0.14", ""},
          {"holds", integer, "", 1, kMostHeld, "1",
           "bodies at once; felt weights are scaled so that so many fit the arm"}},
         "",
         "Puts a bucket on the tool; movable bodies that fall into it are caught.",
         &set_bucket});
}

}  // namespace

void add_declaration_api(ApiTable& table) {
    using enum ParameterType;
    add_scene_rows(table);
    table.functions.push_back(
        {"world",
         "spring",
         CallShape::record,
         CallTime::declaring,
         {{"name", name, "", 0, 0, "nil", "\"spring1\", \"spring2\" … by default"},
          {"at", vector, "metres", -kFar_m, kFar_m, kRequired, "where it pulls to"},
          {"stiffness", number, "newtons per metre", 0, kMostSpring_N_per_m, kRequired, ""},
          {"damping", number, "newton seconds per metre", 0, kMostFieldDamping_Ns_per_m, "0", ""}},
         "Force",
         "Declares a spring that pulls the hand. It is on from the start.",
         &add_spring});
    table.functions.push_back(
        {"world",
         "viscosity",
         CallShape::record,
         CallTime::declaring,
         {{"name", name, "", 0, 0, "nil", "\"viscosity1\", \"viscosity2\" … by default"},
          {"damping", number, "newton seconds per metre", 0, kMostFieldDamping_Ns_per_m, kRequired,
           "honey is about 20"}},
         "Force",
         "Declares a thickness of the air that brakes the hand. It is on from the start.",
         &add_viscosity});
    table.functions.push_back(
        {"world",
         "magnet",
         CallShape::record,
         CallTime::declaring,
         {{"name", name, "", 0, 0, "nil", "\"magnet1\", \"magnet2\" … by default"},
          {"at", vector, "metres", -kFar_m, kFar_m, kRequired, "where it pulls to"},
          {"force", number, "newtons", 0, kMostMagnet_N, kRequired, "the strongest pull"},
          {"range", number, "metres", kLeastMagnetRange_m, kMostMagnetRange_m, "0.1",
           "distance of the strongest pull"}},
         "Force",
         "Declares a magnet that pulls the hand. It is on from the start.",
         &add_magnet});
}

}  // namespace fulcrum::runtime
