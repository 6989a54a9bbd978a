// A kite on a line that the hand holds, and the wind that it flies in.
#include "haptics/math/length.h"
#include "runtime/effect/kite/kite_fields.h"
#include "runtime/lua/api/binding_table.h"
#include "runtime/lua/api/lesson_context.h"
#include "runtime/lua/api/needs.h"
#include "runtime/lua/api/take_fields.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

namespace fulcrum::runtime {
namespace {

constexpr double kBridleOfHeight = 1.25;  // where none is given: as NASA's own kite has them
constexpr double kKnotOfHeight = 0.85;
constexpr double kBoxWidth_m = 0.4;

std::string metres_text(double metres) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", metres);
    return text;
}

// A kite and a bridle without a triangle, told as a teacher would look for it.
void check_bridle(lua_State* lua, const KiteSettings& design) {
    const double slack_m = design.bridle_m - design.height_m;
    if (slack_m < 0.01 * design.height_m) {
        raise_in_lesson(
            lua, "a bridle of " + metres_text(design.bridle_m) + " m is too short for a kite of " +
                     metres_text(design.height_m) +
                     " m: it goes from the foot over the knot to the top; make it longer than " +
                     metres_text(1.01 * design.height_m) + " m");
    }
    const double least_m = 0.501 * slack_m;
    if (design.knot_m < least_m || design.knot_m > design.bridle_m - least_m) {
        raise_in_lesson(lua, "a knot at " + metres_text(design.knot_m) +
                                 " m makes no triangle on this bridle; put it between " +
                                 metres_text(least_m) + " and " +
                                 metres_text(design.bridle_m - least_m) + " m from the foot");
    }
}

void check_design(lua_State* lua, const KiteSettings& design) {
    check_bridle(lua, design);
    if (auto fits = validate(design); !fits) {
        raise_in_lesson(lua, fits.error().message + "; " + fits.error().what_to_do);
    }
}

// What is given changes the kite; what is not stays, but for a bridle that was made for another height.
void take_design(const Arguments& arguments, KiteDescription& kite) {
    KiteSettings& design = kite.flight.kite;
    if (arguments["height"].given) {
        design.bridle_m = kBridleOfHeight * arguments["height"].number;
        design.knot_m = kKnotOfHeight * arguments["height"].number;
    }
    if (arguments["shape"].given) {
        design.width_m = arguments["shape"].text == "box" ? kBoxWidth_m : KiteSettings{}.width_m;
    }
    if (arguments["cloth"].given) {
        kite.cloth = arguments["cloth"].text;
        design.cloth_kg_per_m2 = find_kite_cloth(kite.cloth).value().weight;
    }
    if (arguments["spar"].given) {
        kite.spar = arguments["spar"].text;
        design.spar_kg_per_m = find_kite_spar(kite.spar).value().weight;
    }
    take_fields(fields::kKiteDesign, arguments, design);
}

int add_kite(lua_State* lua, LessonContext& context, const Arguments& arguments) {
    if (context.description.kite) {
        raise_in_lesson(lua,
                        "a lesson has one kite; this is the second world:kite { … }; change the "
                        "first one with kite:build { … }");
    }
    KiteDescription kite;
    take_design(arguments, kite);
    check_design(lua, kite.flight.kite);
    take_fields(fields::kKiteLine, arguments, kite);
    kite.line = place_in_lesson(lua).line;
    context.description.kite = kite;
    context.kite = kite;
    push_handle(lua, Handle::Kind::kite, 0);
    return 1;
}

int set_wind(lua_State* lua, LessonContext& context, const Arguments& arguments) {
    WindDescription& wind = context.description.wind;
    take_fields(fields::kWind, arguments, wind);
    const Vector3 towards = arguments["towards"].vector;
    const Vector3 level(towards.x(), 0.0, towards.z());
    if (compute_length(level) < 0.01) {
        raise_in_lesson(lua,
                        "the wind blows along the ground; {1, 0, 0} blows to the right, {0, 0, -1} "
                        "away from the viewer");
    }
    wind.downwind_W = compute_direction(level);
    constexpr std::pair<std::string_view, double> kGrounds[] = {
        {"water", 0.0002}, {"grass", 0.03}, {"bushes", 0.25}, {"town", 1.0}};
    for (const auto& [name, roughness_m] : kGrounds) {
        wind.roughness_m = arguments["over"].text == name ? roughness_m : wind.roughness_m;
    }
    wind.line = place_in_lesson(lua).line;
    return 0;
}

int set_wind_speed(lua_State* lua, LessonContext& context, const Arguments& arguments) {
    require_need(lua, context, Need::kite,
                 "nothing flies in this wind; declare a world:kite { … } in L:start");
    add_command(lua, WindCommand{arguments["speed"].number});
    return 0;
}

int build_kite(lua_State* lua, LessonContext& context, const Arguments& arguments) {
    KiteDescription changed = *context.kite;
    take_design(arguments, changed);
    check_design(lua, changed.flight.kite);
    context.kite = changed;
    KiteCommand command;
    command.design = changed.flight.kite;
    add_command(lua, command);
    return 0;
}

int launch_kite(lua_State* lua, LessonContext& context, const Arguments& arguments) {
    KiteCommand command;
    command.launch_elevation_rad = arguments["elevation"].given
                                       ? arguments["elevation"].number / kDegrees
                                       : context.description.kite->elevation_rad;
    add_command(lua, command);
    return 0;
}

int turn_reel(lua_State* lua, LessonContext& /*context*/, const Arguments& arguments) {
    KiteCommand command;
    command.line_m = arguments["length"].number;
    add_command(lua, command);
    return 0;
}

int cut_line(lua_State* lua, LessonContext& /*context*/, const Arguments& /*arguments*/) {
    KiteCommand command;
    command.cut = true;
    add_command(lua, command);
    return 0;
}

int show_forces(lua_State* lua, LessonContext& /*context*/, const Arguments& arguments) {
    KiteCommand command;
    command.shows_forces = arguments["shown"].flag;
    add_command(lua, command);
    return 0;
}

// ---- what a kite tells ------------------------------------------------------------------------------------------

KiteState kite_state_of(const LessonContext& context) {
    return context.frame.kite.value_or(KiteState{});
}

template <double KiteSettings::*kNumber>
int get_of_design(lua_State* lua, LessonContext& context, std::int32_t /*index*/) {
    lua_pushnumber(lua, context.kite->flight.kite.*kNumber);
    return 1;
}
template <Vector3 KiteState::*kForce>
int get_newtons(lua_State* lua, LessonContext& context, std::int32_t /*index*/) {
    lua_pushnumber(lua, compute_length(Vector3(kite_state_of(context).*kForce)));
    return 1;
}
int get_lift(lua_State* lua, LessonContext& context, std::int32_t /*index*/) {
    const Vector3& lift_W = kite_state_of(context).lift_W;
    lua_pushnumber(lua, std::copysign(compute_length(lift_W), lift_W.y()));
    return 1;
}
template <int kAxis>
int get_kite_axis(lua_State* lua, LessonContext& context, std::int32_t /*index*/) {
    lua_pushnumber(lua, kite_state_of(context).centre_W[kAxis]);
    return 1;
}

int get_shape(lua_State* lua, LessonContext& context, std::int32_t /*index*/) {
    return push_text(lua, std::string(to_string(context.kite->flight.kite.shape)));
}
int get_cloth(lua_State* lua, LessonContext& context, std::int32_t /*index*/) {
    return push_text(lua, context.kite->cloth);
}
int get_spar(lua_State* lua, LessonContext& context, std::int32_t /*index*/) {
    return push_text(lua, context.kite->spar);
}
int get_altitude(lua_State* lua, LessonContext& context, std::int32_t /*index*/) {
    lua_pushnumber(lua, context.frame.kite
                            ? context.frame.kite->centre_W.y() - context.description.ground_height_m
                            : 0.0);
    return 1;
}
int get_kite_position(lua_State* lua, LessonContext& context, std::int32_t /*index*/) {
    push_vector(lua, kite_state_of(context).centre_W);
    return 1;
}
int get_angle(lua_State* lua, LessonContext& context, std::int32_t /*index*/) {
    lua_pushnumber(lua, kite_state_of(context).angle_of_attack_rad * kDegrees);
    return 1;
}
int get_line(lua_State* lua, LessonContext& context, std::int32_t /*index*/) {
    lua_pushnumber(
        lua, context.frame.kite ? context.frame.kite->line_m : context.kite->flight.line.length_m);
    return 1;
}
int get_snapped(lua_State* lua, LessonContext& context, std::int32_t /*index*/) {
    lua_pushboolean(lua, kite_state_of(context).is_snapped ? 1 : 0);
    return 1;
}

void add_kite_properties(ApiTable& table) {
    const auto add = [&table](const char* name, const char* type, const char* unit,
                              const char* text,
                              int (*get)(lua_State*, LessonContext&, std::int32_t)) {
        table.properties.push_back({"kite", name, type, unit, text, get});
    };
    add("shape", "string", "", "as it is now, like all that follows up to tail", &get_shape);
    add("cloth", "string", "", "what it is covered with: its name", &get_cloth);
    add("spar", "string", "", "what its spars are made of: its name", &get_spar);
    add("height", "number", "metres", "of the kite itself, from foot to top",
        &get_of_design<&KiteSettings::height_m>);
    add("width", "number", "metres", "unfolded", &get_of_design<&KiteSettings::width_m>);
    add("bridle", "number", "metres", "the string from the foot over the knot to the top",
        &get_of_design<&KiteSettings::bridle_m>);
    add("knot", "number", "metres", "where on the bridle the line is tied, from the foot",
        &get_of_design<&KiteSettings::knot_m>);
    add("tail", "number", "metres", "0: it has none", &get_of_design<&KiteSettings::tail_m>);
    add("altitude", "number", "metres", "how high it is above the ground", &get_altitude);
    add("position", "Vector", "metres", "{x, y, z} of its centre of mass", &get_kite_position);
    add("x", "number", "metres", "to the right", &get_kite_axis<0>);
    add("y", "number", "metres", "up", &get_kite_axis<1>);
    add("z", "number", "metres", "towards the viewer", &get_kite_axis<2>);
    add("speed", "number", "metres per second", "how fast it goes",
        &get_newtons<&KiteState::velocity_W>);
    add("wind", "number", "metres per second", "at the kite, gusts and all",
        &get_newtons<&KiteState::wind_W>);
    add("angle", "number", "degrees", "between the wind and the kite: its angle of attack",
        &get_angle);
    add("lift", "number", "newtons",
        "the air's force across the wind; below 0 when it presses the kite down", &get_lift);
    add("drag", "number", "newtons", "the air's force along the wind",
        &get_newtons<&KiteState::drag_W>);
    add("weight", "number", "newtons", "of kite and tail", &get_newtons<&KiteState::weight_W>);
    add("tension", "number", "newtons", "of the line, at the kite",
        &get_newtons<&KiteState::tension_W>);
    add("pull", "number", "newtons", "of the line on the hand, before `felt` makes it milder",
        &get_newtons<&KiteState::hand_force_W>);
    add("line", "number", "metres", "how much line is let out, unstretched", &get_line);
    add("snapped", "boolean", "", "the line broke or was cut; kite:fly ties it again",
        &get_snapped);
}

}  // namespace

void add_kite_api(ApiTable& table) {
    using enum ParameterType;
    table.functions.push_back({"world", "kite", CallShape::record, CallTime::declaring,
                               rows_of(fields::kKiteDesign, fields::kKiteLine), "Kite",
                               "Declares a kite on a line that the hand holds. It flies from the "
                               "start. The reel is the mouse's wheel, or the hand's buttons: the "
                               "first lets line out, the second takes it in.",
                               &add_kite});
    table.functions.push_back({"world", "wind", CallShape::record, CallTime::declaring,
                               rows_of(fields::kWind), "", "Declares the wind for the kite.",
                               &set_wind});
    table.functions.push_back(
        {"world",
         "wind_speed",
         CallShape::positional,
         CallTime::acting,
         {{"speed", number, "metres per second", 0, kFastestWind_m_per_s, kRequired,
           "10 metres above the ground"}},
         "",
         "Changes how fast the wind blows, at once; its direction and gusts stay.",
         &set_wind_speed});
    table.functions.push_back(
        {"kite", "build", CallShape::record, CallTime::acting, rows_of(fields::kKiteDesign), "",
         "Makes it anew with what is given changed, and launches it on as much line as before.",
         &build_kite});
    table.functions.push_back({"kite",
                               "fly",
                               CallShape::positional,
                               CallTime::acting,
                               {{"elevation", number, "degrees", 0, 85, "nil",
                                 "how steeply the line rises at first; as declared by default"}},
                               "",
                               "Launches it again, on the whole line that is let out.",
                               &launch_kite});
    table.functions.push_back(
        {"kite",
         "reel",
         CallShape::positional,
         CallTime::acting,
         {{"length", number, "metres", kShortestReel_m, kLongestReel_m, kRequired,
           "of line, at most four times what was let out at first"}},
         "",
         "Lets line out or takes it in, at 2 metres a second.",
         &turn_reel});
    table.functions.push_back({"kite",
                               "cut",
                               CallShape::positional,
                               CallTime::acting,
                               {},
                               "",
                               "Cuts the line at the kite, until kite:fly ties it again.",
                               &cut_line});
    table.functions.push_back({"kite",
                               "show_forces",
                               CallShape::positional,
                               CallTime::acting,
                               {{"shown", flag, "", 0, 0, "true", "false hides them"}},
                               "",
                               "Shows lift, drag, weight and tension as arrows, or hides them.",
                               &show_forces});
    add_kite_properties(table);
}

}  // namespace fulcrum::runtime
