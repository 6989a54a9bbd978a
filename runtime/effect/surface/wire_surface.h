// Layout and limits of what a description says of surfaces and of what touches them.
#pragma once

#include "runtime/effect/body/body_fields.h"
#include "runtime/effect/hand/hand_fields.h"
#include "runtime/effect/surface/material_fields.h"
#include "runtime/lua/wire/wire_archive.h"
#include "runtime/lua/wire/wire_fields.h"
#include "runtime/scene/description.h"
#include "runtime/scene/shape_models.h"

#include <optional>

namespace fulcrum::runtime::wire {

inline constexpr std::int64_t kMaxLine = 10'000'000;

template <class Archive, class Source>
void texture_source(Archive& a, Source& s) {
    using Kind = std::remove_cvref_t<Source>;
    if constexpr (std::is_same_v<Kind, ImageTexture>) {
        a.number("a picture's width", s.tile_u_m, fields::kLeastRelief_m, fields::kWidestPicture_m);
        a.number("a picture's height", s.tile_v_m, fields::kLeastRelief_m,
                 fields::kWidestPicture_m);
    } else if constexpr (std::is_same_v<Kind, SineTexture>) {
        a.number("the grooves' distance", s.wavelength_m, fields::kLeastRelief_m,
                 fields::kWidestRelief_m);
        a.number("the grooves' direction", s.direction_rad, -100.0, 100.0);
    } else if constexpr (std::is_same_v<Kind, NoiseTexture>) {
        a.number("the bumps' least width", s.shortest_m, fields::kLeastRelief_m,
                 fields::kWidestRelief_m);
        a.number("the bumps' most width", s.longest_m, fields::kLeastRelief_m,
                 fields::kWidestRelief_m);
        a.integer("the bumps' seed", s.seed, 0, UINT32_MAX);
    }
}

template <class Archive, class Felt>
void felt(Archive& a, Felt& m) {
    fields(a, "a material", fields::kMaterial, m);
    fields(a, "a saturation", fields::kSaturation, m.coupling);
    a.number("a material's saturation", m.coupling.saturation_range_m, 0.0, 1e3);
    a.one_of("a texture", m.texture.source,
             [](auto& archive, auto& alternative) { texture_source(archive, alternative); });
    fields(a, "a texture", fields::kTexture, m.texture);
    fields(a, "a tap", fields::kTap, m.transient);
    a.number("a tap's decay", m.transient.decay_per_s, 0.0, 1e4);
    a.number("a tap's largest force", m.transient.max_force_N, 0.0, 10.0);
    a.number("a tap's energy", m.transient.energy_share, 0.0, 1.0);
}

template <class Archive, class Described>
void material(Archive& a, Described& m) {
    felt(a, m.felt);
    a.name("a material's look", m.look);
    a.text("a material's picture", m.image, kMaxNameBytes);
    if constexpr (Archive::kReads) {
        if (!m.image.empty() && !is_picture_name(m.image)) {
            a.refuse("a material's picture", "is not the name of a picture beside the lesson");
        }
    }
    a.integer("a line", m.line, 0, kMaxLine);
}

/// Whether something is there, and then what it is; `each` writes or reads a value of its type.
template <class Archive, class Optional, class Each>
void optional(Archive& a, const char* what, Optional& value, const Each& each) {
    bool given = value.has_value();
    a.flag(what, given);
    auto plain = value.value_or(typename std::remove_cvref_t<Optional>::value_type{});
    if (given) {
        each(a, plain);
    }
    if constexpr (Archive::kReads) {
        value = given ? std::optional(plain) : std::nullopt;
    }
}

template <class Archive, class Hinge>
void hinge(Archive& a, Hinge& h) {
    fields(a, "a hinge", fields::kHinge, h);
    vector(a, "a hinge's place", h.pivot_B, kFarthestOnAxle_m);
    a.number("a hinge's mass", h.mass_kg, 0.0, kMostAxleMass_kg);
    vector(a, "a hinge's centre of mass", h.centre_B, kFarthestOnAxle_m);
    vector(a, "where a load hangs", h.load_B, kFarthestOnAxle_m);
}

template <class Archive, class Joint>
void joint(Archive& a, Joint& j) {
    a.choice("a joint's kind", j.kind, JointKind::distance);
    a.name("what a joint holds on to", j.to);
    vector(a, "a joint's place", j.at_W, kMaxCoordinate_m);
    vector(a, "a rod's end", j.other_at_W, kMaxCoordinate_m);
    fields(a, "a joint", fields::kJoint, j);
    a.number("a joint's lowest", j.lowest, -kAnyTravel, 0.0);
    a.number("a joint's highest", j.highest, 0.0, kAnyTravel);
    a.number("a joint's speed", j.speed, -fields::kMostJointTravel, fields::kMostJointTravel);
}

template <class Archive, class Rigid>
void rigid(Archive& a, Rigid& r) {
    optional(a, "a joint", r.joint, [](auto& each, auto& j) { joint(each, j); });
}

/// The boxes that a body is made of.
template <class Archive, class Boxes>
void boxes(Archive& a, Boxes& all) {
    a.list("a body's boxes", all, kMaxBoxes, [](auto& each, auto& box) {
        vector(each, "a box's place", box.at_B, kFarthestBox_m);
        for (int i = 0; i < 3; ++i) {
            each.number("a box's size", box.size_m[i], kLeastEdge_m, kMostEdge_m);
        }
    });
}

template <class Archive, class Shape>
void cursor(Archive& a, Shape& shape) {
    using Kind = std::remove_cvref_t<Shape>;
    if constexpr (std::is_same_v<Kind, BoxShape>) {
        for (int i = 0; i < 3; ++i) {
            a.number("the cursor's size", shape.half_size_m[i], 1e-6, 10.0);
        }
    } else if constexpr (!std::is_same_v<Kind, std::monostate> &&
                         !std::is_same_v<Kind, HullShape>) {
        a.number("the cursor's radius", shape.radius_m, 1e-6, 10.0);
    }
    if constexpr (std::is_same_v<Kind, CapsuleShape>) {
        a.number("the cursor's length", shape.half_length_m, 0.0, 10.0);
    } else if constexpr (std::is_same_v<Kind, CylinderShape>) {
        a.number("the cursor's height", shape.half_height_m, 1e-6, 10.0);
    }
}

template <class Archive, class Tool>
void tool(Archive& a, Tool& t) {
    a.one_of("the tool's shape", t.shape,
             [](auto& archive, auto& shape) { cursor(archive, shape); });
    fields(a, "the tool", fields::kTool, t);
    if constexpr (Archive::kReads) {
        const bool has_shape = !std::holds_alternative<std::monostate>(t.shape);
        if (std::holds_alternative<HullShape>(t.shape)) {
            a.refuse("the tool", "is a hull, which tools are not");
        }
        if (has_shape != (t.model.empty() || is_shape_model(t.model))) {
            a.refuse("the tool", "has not either a shape or a model of its own size");
        }
    }
}

/// What touches: its shape by number, as in CursorShape.
template <class Archive, class Hand>
void proxy(Archive& a, Hand& h) {
    bool chosen = h.proxy.has_value();
    a.flag("a proxy is chosen", chosen);
    auto kind = h.proxy.value_or(ProxyKind::god_object);
    a.choice("the proxy", kind, ProxyKind::friction_cone);
    if constexpr (Archive::kReads) {
        h.proxy = chosen ? std::optional(kind) : std::nullopt;
    }
    a.one_of("the cursor", h.cursor, [](auto& archive, auto& shape) { cursor(archive, shape); });
    if constexpr (Archive::kReads) {
        if (std::holds_alternative<HullShape>(h.cursor) == h.cursor_model.empty() ||
            is_shape_model(h.cursor_model)) {
            a.refuse("the cursor",
                     "has a hull without a model of its own size, or the other way round");
        }
    }
    optional(a, "a tool", h.tool, [](auto& each, auto& t) { tool(each, t); });
    a.integer("a line", h.line, 0, kMaxLine);
}

template <class Archive, class Hand>
void hand(Archive& a, Hand& h) {
    fields(a, "the hand", fields::kHand, h);
    a.flag("a lesson force", h.lesson_force);
    a.integer("a line", h.force_line, 0, kMaxLine);
    proxy(a, h);
}

}  // namespace fulcrum::runtime::wire
