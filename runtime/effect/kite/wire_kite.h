// Layout and limits of what is said of a kite: its description, how it flies, what the lesson does with it.
#pragma once

#include "runtime/effect/kite/kite_fields.h"
#include "runtime/effect/surface/wire_surface.h"
#include "runtime/lua/wire/wire_fields.h"

namespace fulcrum::runtime::wire {

/// What it is; whether its bridle makes a triangle is `validate`'s to say.
template <class Archive, class Design>
void kite_design(Archive& a, Design& k) {
    fields(a, "a kite", fields::kKiteDesign, k);
    a.number("a kite's cloth", k.cloth_kg_per_m2, 1.0e-3, 2.0);
    a.number("a kite's spars", k.spar_kg_per_m, 1.0e-4, 1.0);
    a.number("a tail's mass", k.tail_kg_per_m, 0.0, 0.1);
    a.number("a tail's drag", k.tail_drag_m2_per_m, 0.0, 1.0);
    a.choice("the law of a kite's plates", k.law, PlateLaw::thin_plate);
    a.integer("a kite's strips", k.strips, 1, 64);
    if constexpr (Archive::kReads) {
        if (!validate(k)) {
            a.refuse("a kite", "is none: its knot and its bridle do not fit its height");
        }
    }
}

template <class Archive, class Line>
void kite_line(Archive& a, Line& l) {
    a.number("a line's mass", l.mass_kg_per_m, 1.0e-5, 0.1);
    a.number("a line's damping", l.damping_s, 0.0, 1.0);
    a.number("a line's thickness", l.diameter_m, 0.0, 0.02);
    a.number("a line's drag", l.drag_coefficient, 0.0, 2.0);
}

template <class Archive, class Described>
void kite(Archive& a, Described& k) {
    kite_design(a, k.flight.kite);
    kite_line(a, k.flight.line);
    fields(a, "a kite", fields::kKiteLine, k);
    a.name("a kite's cloth", k.cloth);
    a.name("a kite's spar", k.spar);
    a.integer("a line", k.line, 0, kMaxLine);
}

template <class Archive, class Wind>
void wind(Archive& a, Wind& w) {
    fields(a, "the wind", fields::kWind, w);
    a.number("the ground's roughness", w.roughness_m, 1.0e-5, 5.0);
    vector(a, "the wind's direction", w.downwind_W, 1.0);
    a.integer("a line", w.line, 0, kMaxLine);
}

template <class Archive, class State>
void kite_state(Archive& a, State& k) {
    vector(a, "the kite", k.centre_W, kMaxTold);
    vector(a, "the kite's velocity", k.velocity_W, kMaxTold);
    vector(a, "the kite's weight", k.weight_W, kMaxTold);
    vector(a, "its lift", k.lift_W, kMaxTold);
    vector(a, "its drag", k.drag_W, kMaxTold);
    vector(a, "the line's tension", k.tension_W, kMaxTold);
    vector(a, "the line's pull", k.hand_force_W, kMaxTold);
    vector(a, "the wind at the kite", k.wind_W, kMaxTold);
    a.number("the angle of attack", k.angle_of_attack_rad, 0.0, 4.0);
    a.number("the line's length", k.line_m, 0.0, kMaxTold);
    a.flag("snapped", k.is_snapped);
}

template <class Archive, class Command>
void kite_command(Archive& a, Command& c) {
    optional(a, "a design", c.design, [](auto& each, auto& v) { kite_design(each, v); });
    optional(a, "a launch", c.launch_elevation_rad,
             [](auto& each, auto& v) { each.number("a launch", v, 0.0, 1.5); });
    optional(a, "a length", c.line_m, [](auto& each, auto& v) {
        each.number("a length", v, kShortestReel_m, kLongestReel_m);
    });
    a.flag("cut", c.cut);
    optional(a, "forces", c.shows_forces, [](auto& each, auto& v) { each.flag("shown", v); });
}

}  // namespace fulcrum::runtime::wire
