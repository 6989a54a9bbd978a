// Layout and limits of what is said of a kite: its description, how it flies, what the lesson does with it.
#pragma once

#include "runtime/lua/wire/wire_surface.h"
#include "runtime/scene/kite_description.h"

namespace fulcrum::runtime::wire {

/// What it is; whether its bridle makes a triangle is `validate`'s to say.
template <class Archive, class Design>
void kite_design(Archive& a, Design& k) {
    a.choice("a kite's shape", k.shape, KiteShape::box);
    a.number("a kite's height", k.height_m, kLeastKite_m, kMostKite_m);
    a.number("a kite's width", k.width_m, kLeastKite_m, kMostKite_m);
    a.number("a kite's fold", k.fold_rad, 0.0, 1.0);
    a.number("a kite's cloth", k.cloth_kg_per_m2, 1.0e-3, 2.0);
    a.number("a kite's spars", k.spar_kg_per_m, 1.0e-4, 1.0);
    a.number("a kite's bridle", k.bridle_m, kLeastKite_m, kMostString_m);
    a.number("a kite's knot", k.knot_m, 0.0, kMostString_m);
    a.number("a kite's tail", k.tail_m, 0.0, kMostString_m);
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
    a.number("a line's length", l.length_m, kShortestReel_m, kLongestReel_m);
    a.integer("a line's segments", l.segments, 1, kMostLineSegments);
    a.number("a line's mass", l.mass_kg_per_m, 1.0e-5, 0.1);
    a.number("a line's stretch", l.stretch_N, kLeastLineStretch_N, kMostLine_N);
    a.number("a line's damping", l.damping_s, 0.0, 1.0);
    a.number("a line's thickness", l.diameter_m, 0.0, 0.02);
    a.number("a line's drag", l.drag_coefficient, 0.0, 2.0);
    a.number("a line's strength", l.strength_N, kLeastLineStrength_N, kMostLine_N);
}

template <class Archive, class Described>
void kite(Archive& a, Described& k) {
    kite_design(a, k.flight.kite);
    kite_line(a, k.flight.line);
    a.name("a kite's cloth", k.cloth);
    a.name("a kite's spar", k.spar);
    a.number("what is felt of a kite", k.share, kLeastKiteShare, kMostKiteShare);
    a.number("how large a kite is seen", k.seen_scale, 1.0, kMostKiteScale);
    a.number("a line's elevation", k.elevation_rad, 0.0, 1.5);
    a.integer("a line", k.line, 0, kMaxLine);
}

template <class Archive, class Wind>
void wind(Archive& a, Wind& w) {
    a.number("the wind", w.speed_m_per_s, 0.0, kFastestWind_m_per_s);
    a.number("the gusts", w.gustiness, 0.0, kMostGusts);
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
