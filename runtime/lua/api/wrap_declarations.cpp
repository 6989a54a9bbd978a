// What L:start(world) declares: bodies, forces, bucket, view.
#include "runtime/effect/body/body_fields.h"
#include "runtime/effect/catch/bucket_fields.h"
#include "runtime/effect/field/field_fields.h"
#include "runtime/effect/hinge/declare_hinge.h"
#include "runtime/effect/hinge/hinge_fields.h"
#include "runtime/effect/rigid/declare_rigid.h"
#include "runtime/effect/scene/scene_fields.h"
#include "runtime/effect/surface/declare_material.h"
#include "runtime/lua/api/binding_table.h"
#include "runtime/lua/api/lesson_context.h"
#include "runtime/lua/api/take_fields.h"
#include "runtime/scene/shape_models.h"

#include <algorithm>
#include <iterator>

namespace fulcrum::runtime {
namespace {

int set_gravity(lua_State* /*lua*/, LessonContext& context, const Arguments& arguments) {
    take_fields(fields::kGravity, arguments, context.description);
    return 0;
}

int set_ground(lua_State* /*lua*/, LessonContext& context, const Arguments& arguments) {
    take_fields(fields::kGround, arguments, context.description);
    return 0;
}

int set_contacts(lua_State* lua, LessonContext& context, const Arguments& arguments) {
    RigidSolveDescription contacts;
    take_fields(fields::kContacts, arguments, contacts);
    if (contacts.method == ContactMethod::dantzig) {
        if (arguments["friction"].given && contacts.friction == FrictionShape::cone) {
            raise_in_lesson(lua,
                            "dantzig has friction = \"pyramid\" alone; leave friction out, or take "
                            "another method");
        }
        contacts.friction = FrictionShape::pyramid;
    }
    contacts.line = place_in_lesson(lua).line;
    context.description.contacts = contacts;
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
    take_fields(fields::kCamera, arguments, context.description.camera);
    return 0;
}

AxleSettings take_hinge(lua_State* lua, const Arguments& arguments, const BodyDescription& body) {
    AxleSettings hinge;
    take_fields(fields::kHinge, arguments, hinge);
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
    if (hinge.lowest_rad > hinge.highest_rad || hinge.lowest_rad > 0.0 || hinge.highest_rad < 0.0) {
        raise_in_lesson(lua,
                        "the hinge of " + body.name +
                            " begins at 0 degrees; lowest is at most 0, and highest at least 0");
    }
    if (arguments["load_at"].given) {
        hinge.load_B = place_on_hinge(lua, body, "load", arguments["load_at"].vector);
    }
    return hinge;
}

// What is said of how it is touched is for what can be.
void check_touch(lua_State* lua, const Arguments& arguments, const BodyDescription& body) {
    if (!body.about.empty() && !body.solid && !body.movable) {
        raise_in_lesson(lua, body.name + " has about but can't be touched; add solid = true");
    }
    if (body.solid && as_felt(body).model == kOrbitModel) {
        raise_in_lesson(
            lua, body.name + " is an orbit, a thin line, seen and not felt; leave out solid");
    }
    if (arguments["crease"].given && !body.shading.on) {
        raise_in_lesson(lua, body.name + " has a crease but is not rounded; add rounded = true");
    }
    if ((body.shading.on || arguments["material"].given) && !body.solid) {
        raise_in_lesson(lua, body.name + (body.shading.on ? " is rounded" : " has a material") +
                                 " but can't be touched; add solid = true");
    }
}

int add_body(lua_State* lua, LessonContext& context, const Arguments& arguments) {
    std::vector<BodyDescription>& bodies = context.description.bodies;
    BodyDescription body;
    take_fields(fields::kBody, arguments, body);
    body.noun = arguments["noun"].given ? body.noun : body.name;
    body.model = arguments["model"].given ? body.model : body.name;
    body.line = place_in_lesson(lua).line;
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
    check_touch(lua, arguments, body);
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
    take_fields(fields::kBucket, arguments, bucket);
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

template <std::size_t kIndex>
int add_force(lua_State* lua, LessonContext& context, const Arguments& arguments) {
    constexpr const auto& kForce = std::get<kIndex>(fields::kForces);
    std::vector<ForceDescription>& forces = context.description.forces;
    if (forces.size() >= static_cast<std::size_t>(kMaxFields)) {
        raise_in_lesson(lua, "a lesson declares at most " + std::to_string(kMaxFields) +
                                 " forces; leave out one");
    }
    const Argument& name = arguments["name"];
    ForceDescription force{
        name.given ? name.text : free_name(forces, kForce.name), {}, place_in_lesson(lua).line};
    force.field.kind = kForce.kind;
    take_fields(kForce.list, arguments, force.field);
    if (std::ranges::count(forces, force.name, &ForceDescription::name) > 0) {
        raise_in_lesson(
            lua, "there is already a force \"" + force.name + "\"; give this one another name");
    }
    context.fields.push_back(FieldCommand{true, force.field.anchor_W, 1.0});
    forces.push_back(std::move(force));
    push_handle(lua, Handle::Kind::force, static_cast<std::int32_t>(forces.size()) - 1);
    return 1;
}

template <std::size_t... kIndex>
void add_force_rows(ApiTable& table, std::index_sequence<kIndex...> /*all*/) {
    const auto add = [&table](const auto& force, BoundFunction call) {
        table.functions.push_back({"world", force.name, CallShape::record, CallTime::declaring,
                                   rows_of(force.list), "Force", force.text, call});
    };
    (add(std::get<kIndex>(fields::kForces), &add_force<kIndex>), ...);
}

void add_scene_rows(ApiTable& table) {
    using enum ParameterType;
    table.functions.push_back({"world", "gravity", CallShape::positional, CallTime::declaring,
                               rows_of(fields::kGravity), "", "Sets how strongly things fall.",
                               &set_gravity});
    table.functions.push_back({"world", "ground", CallShape::positional, CallTime::declaring,
                               rows_of(fields::kGround), "", "Sets the height of the ground.",
                               &set_ground});
    table.functions.push_back({"world", "contacts", CallShape::record, CallTime::declaring,
                               rows_of(fields::kContacts), "",
                               "Chooses how contacts between rigid bodies are solved. Of each "
                               "`explain` says what it costs.",
                               &set_contacts});
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
    table.functions.push_back({"world", "camera", CallShape::record, CallTime::declaring,
                               rows_of(fields::kCamera), "", "Places the camera.", &set_camera});
    table.functions.push_back({"world", "body", CallShape::record, CallTime::declaring,
                               rows_of(fields::kBody), "Body", "Declares a thing.", &add_body});
    table.functions.push_back(
        {"world", "bucket", CallShape::record, CallTime::declaring, rows_of(fields::kBucket), "",
         "Puts a bucket on the tool; movable bodies that fall into it are caught. Among rigid "
         "bodies it "
         "is one itself, which the hand holds: they fall in, lie in it, weigh, slide and fall out "
         "again; a light one of 50 grams, which holds what has room.",
         &set_bucket});
}

}  // namespace

void add_declaration_api(ApiTable& table) {
    add_scene_rows(table);
    add_force_rows(table, std::make_index_sequence<std::tuple_size_v<decltype(fields::kForces)>>{});
}

}  // namespace fulcrum::runtime
