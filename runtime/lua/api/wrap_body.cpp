// A body: what a lesson asks of it and reads from it.
#include "haptics/math/length.h"
#include "runtime/lua/api/binding_table.h"
#include "runtime/lua/api/lesson_context.h"
#include "runtime/lua/api/needs.h"
#include "runtime/lua/wire/wire_limits.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace fulcrum::runtime {
namespace {

using Kind = WorldCommand::Kind;

const BodyDescription& description_of(const LessonContext& context, std::int32_t index) {
    return context.description.bodies[static_cast<std::size_t>(index)];
}

/// How the body stands now; as declared before the first frame.
BodyState state_of(const LessonContext& context, std::int32_t index) {
    const auto i = static_cast<std::size_t>(index);
    if (i < context.frame.bodies.size()) {
        return context.frame.bodies[i];
    }
    BodyState state;
    state.pose_W.position = description_of(context, index).position_W;
    state.where = description_of(context, index).visible ? BodyWhere::placed : BodyWhere::hidden;
    return state;
}

void move_body(lua_State* lua, LessonContext& context, Kind kind, const Argument* at,
               const Vector3& velocity) {
    WorldCommand move;
    move.kind = kind;
    move.body = to_handle(lua, 1)->index;
    // Where it is now may be farther than a lesson may say.
    move.position_W = at != nullptr && at->given
                          ? at->vector
                          : Vector3(state_of(context, move.body)
                                        .pose_W.position.cwiseMax(-kMaxCoordinate_m)
                                        .cwiseMin(kMaxCoordinate_m));
    move.velocity_W = velocity;
    const BodyDescription& body = description_of(context, move.body);
    if (body.rigid && kind == Kind::hold) {
        raise_in_lesson(lua, body.name +
                                 " is rigid and can't be laid into the tool; the learner "
                                 "grips it with the button");
    }
    if (!body.movable && !body.rigid && (kind == Kind::drop || kind == Kind::hold)) {
        raise_in_lesson(lua, body.name + " can't fall or be held; declare it with movable = true");
    }
    if (body.rigid) {
        add_command(lua, MoveCommand{move});
        return;
    }
    const std::string why = " stays as it is, for no body of this lesson is movable; ";
    require_need(
        lua, context, Need::movable,
        body.name + why +
            (body.hinge ? "declare any other body with movable = true, or move its hinge, " +
                              body.name + ":turn { at = … }"
                        : "declare it with movable = true"));
    add_command(lua, MoveCommand{move});
}

int drop(lua_State* lua, LessonContext& context, const Arguments& arguments) {
    move_body(lua, context, Kind::drop, &arguments["at"], arguments["velocity"].vector);
    return 0;
}
int place(lua_State* lua, LessonContext& context, const Arguments& arguments) {
    move_body(lua, context, Kind::place, &arguments["at"], Vector3::Zero());
    return 0;
}
int hide(lua_State* lua, LessonContext& context, const Arguments& /*arguments*/) {
    move_body(lua, context, Kind::hide, nullptr, Vector3::Zero());
    return 0;
}
int hold(lua_State* lua, LessonContext& context, const Arguments& /*arguments*/) {
    move_body(lua, context, Kind::hold, nullptr, Vector3::Zero());
    return 0;
}

int set_covered(lua_State* lua, LessonContext& context, bool covered) {
    const std::int32_t body = to_handle(lua, 1)->index;
    context.covered.resize(context.description.bodies.size(), false);
    context.covered[static_cast<std::size_t>(body)] = covered;
    add_command(lua, CoverCommand{body, covered});
    return 0;
}
int cover(lua_State* lua, LessonContext& context, const Arguments& /*arguments*/) {
    return set_covered(lua, context, true);
}
int uncover(lua_State* lua, LessonContext& context, const Arguments& /*arguments*/) {
    return set_covered(lua, context, false);
}

int light(lua_State* lua, LessonContext& /*context*/, const Arguments& arguments) {
    add_command(lua,
                LightCommand{to_handle(lua, 1)->index, static_cast<BodyLight>(find_choice(
                                                           kBodyLights, arguments["light"].text))});
    return 0;
}

int mark(lua_State* lua, LessonContext& /*context*/, const Arguments& arguments) {
    add_command(lua, MarkCommand{to_handle(lua, 1)->index, arguments["newtons"].number});
    return 0;
}

int get_name(lua_State* lua, LessonContext& context, std::int32_t index) {
    return push_text(lua, description_of(context, index).name);
}
int get_noun(lua_State* lua, LessonContext& context, std::int32_t index) {
    return push_text(lua, description_of(context, index).noun);
}
int get_mass(lua_State* lua, LessonContext& context, std::int32_t index) {
    lua_pushnumber(lua, description_of(context, index).mass_kg);
    return 1;
}
int get_radius(lua_State* lua, LessonContext& context, std::int32_t index) {
    lua_pushnumber(lua, description_of(context, index).radius_m);
    return 1;
}
int get_weight(lua_State* lua, LessonContext& context, std::int32_t index) {
    lua_pushnumber(lua,
                   description_of(context, index).mass_kg * context.description.gravity_W.norm());
    return 1;
}
int get_felt_weight(lua_State* lua, LessonContext& context, std::int32_t index) {
    const auto i = static_cast<std::size_t>(index);
    if (i >= context.felt_weight_N.size()) {
        raise_in_lesson(lua,
                        "body.felt_weight is known once the lesson runs, in L:update and later, "
                        "not in L:start");
    }
    lua_pushnumber(lua, context.felt_weight_N[i]);
    return 1;
}
int get_material(lua_State* lua, LessonContext& context, std::int32_t index) {
    const std::int32_t material = description_of(context, index).material;
    if (material == kNoMaterial) {
        lua_pushnil(lua);
    } else {
        push_handle(lua, Handle::Kind::material, material);
    }
    return 1;
}
int get_covered(lua_State* lua, LessonContext& context, std::int32_t index) {
    const auto i = static_cast<std::size_t>(index);
    lua_pushboolean(lua, i < context.covered.size() && context.covered[i] ? 1 : 0);
    return 1;
}
int get_position(lua_State* lua, LessonContext& context, std::int32_t index) {
    push_vector(lua, state_of(context, index).pose_W.position);
    return 1;
}
int get_where(lua_State* lua, LessonContext& context, std::int32_t index) {
    constexpr const char* kNames[] = {"hidden", "placed", "falling", "held", "landed"};
    lua_pushstring(lua, kNames[static_cast<std::size_t>(state_of(context, index).where)]);
    return 1;
}
int get_velocity(lua_State* lua, LessonContext& context, std::int32_t index) {
    push_vector(lua, state_of(context, index).velocity_W);
    return 1;
}
int get_speed(lua_State* lua, LessonContext& context, std::int32_t index) {
    lua_pushnumber(lua, compute_length(state_of(context, index).velocity_W));
    return 1;
}
// A rigid body that sleeps has landed; one that is placed is only touched.
int get_resting(lua_State* lua, LessonContext& context, std::int32_t index) {
    const BodyWhere where = state_of(context, index).where;
    const bool is_rigid = description_of(context, index).rigid.has_value();
    lua_pushboolean(lua, where == BodyWhere::landed || (!is_rigid && where == BodyWhere::placed));
    return 1;
}
int get_tilt(lua_State* lua, LessonContext& context, std::int32_t index) {
    const Vector3 up_W = state_of(context, index).pose_W.orientation * Vector3::UnitY();
    lua_pushnumber(lua, std::acos(std::clamp(up_W.y(), -1.0, 1.0)) * kDegrees);
    return 1;
}
template <int kAxis>
int get_axis(lua_State* lua, LessonContext& context, std::int32_t index) {
    lua_pushnumber(lua, state_of(context, index).pose_W.position[kAxis]);
    return 1;
}

}  // namespace

void add_body_api(ApiTable& table) {
    using enum ParameterType;
    constexpr auto kActing = CallTime::acting;
    const Parameter at = {"at",
                          vector,
                          "metres",
                          -kMaxCoordinate_m,
                          kMaxCoordinate_m,
                          "nil",
                          "where it is now by default"};
    table.functions.push_back({"body",
                               "drop",
                               CallShape::record,
                               kActing,
                               {at,
                                {"velocity", vector, "metres per second", -kMaxSpeed_m_per_s,
                                 kMaxSpeed_m_per_s, "{0, 0, 0}", "at first"}},
                               "",
                               "Lets it fall.",
                               &drop});
    table.functions.push_back(
        {"body",
         "place",
         CallShape::record,
         kActing,
         {at},
         "",
         "Puts it somewhere, where it stays; a rigid body falls from there. Some body of the "
         "lesson "
         "must be movable or it rigid. A solid body "
         "that is put where the hand's tool is pushes the tool out of itself, so put it beside.",
         &place});
    table.functions.push_back(
        {"body",
         "hide",
         CallShape::positional,
         kActing,
         {},
         "",
         "Takes it out of the scene. Some body of the lesson must be movable or it rigid.",
         &hide});
    table.functions.push_back({"body",
                               "hold",
                               CallShape::positional,
                               kActing,
                               {},
                               "",
                               "Lays it into the tool, so that its weight is felt.",
                               &hold});
    table.functions.push_back(
        {"body",
         "mark",
         CallShape::positional,
         kActing,
         {{"newtons", number, "newtons", 0, kMostMark_N, "0", "0 takes it away"}},
         "",
         "Shows beside it what was felt of it, as an arrow like the hand's, while it stands there.",
         &mark});
    table.functions.push_back(
        {"body",
         "light",
         CallShape::positional,
         kActing,
         {{"light", choice, "", 0, 0, kRequired,
           "\"offered\": it may be chosen, a line goes round it; \"lit\": it shines", kBodyLights}},
         "",
         "Lights it up. Above the scene stand as many signs as bodies are offered or lit, hidden "
         "ones too, those of lit ones filled, and how many they are.",
         &light});
    table.functions.push_back({"body",
                               "cover",
                               CallShape::positional,
                               kActing,
                               {},
                               "",
                               "Lays a cloth over it: it is not seen, and felt as before.",
                               &cover});
    table.functions.push_back({"body",
                               "uncover",
                               CallShape::positional,
                               kActing,
                               {},
                               "",
                               "Takes the cloth away.",
                               &uncover});

    table.properties.push_back({"body", "name", "string", "", "", &get_name});
    table.properties.push_back({"body", "noun", "string", "", "the English noun", &get_noun});
    table.properties.push_back({"body", "mass", "number", "kilograms", "the true mass", &get_mass});
    table.properties.push_back(
        {"body", "weight", "number", "newtons", "the true weight: mass × gravity", &get_weight});
    table.properties.push_back({"body", "felt_weight", "number", "newtons",
                                "what the hand feels of it", &get_felt_weight});
    table.properties.push_back({"body", "radius", "number", "metres", "as declared", &get_radius});
    table.properties.push_back({"body", "material", "Material|nil", "",
                                "what it is made of; nil when it has no material", &get_material});
    table.properties.push_back({"body", "covered", "boolean", "", "under a cloth", &get_covered});
    table.properties.push_back(
        {"body", "position", "Vector", "metres", "{x, y, z}", &get_position});
    table.properties.push_back({"body", "where",
                                "\"hidden\"|\"placed\"|\"falling\"|\"held\"|\"landed\"", "",
                                "\"hidden\", \"placed\", \"falling\", \"held\" in the tool, or "
                                "\"landed\" on the ground; a rigid body is \"placed\" while it "
                                "touches something and \"landed\" when it lies still",
                                &get_where});
    table.properties.push_back(
        {"body", "velocity", "Vector", "metres per second", "{x, y, z}", &get_velocity});
    table.properties.push_back({"body", "speed", "number", "metres per second", "", &get_speed});
    table.properties.push_back({"body", "resting", "boolean", "",
                                "lies still; of a rigid body: for half a second", &get_resting});
    table.properties.push_back({"body", "tilt", "number", "degrees",
                                "how far its top leans from upright, 0 to 180", &get_tilt});
    table.properties.push_back({"body", "x", "number", "metres", "to the right", &get_axis<0>});
    table.properties.push_back({"body", "y", "number", "metres", "up", &get_axis<1>});
    table.properties.push_back(
        {"body", "z", "number", "metres", "towards the viewer", &get_axis<2>});
}

}  // namespace fulcrum::runtime
