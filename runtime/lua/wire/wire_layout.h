// Layout and limits of the three large messages: description, frame, reply. One function a type,
// for writer and reader.
#pragma once

#include "runtime/effect/asking/wire_questions.h"
#include "runtime/effect/catch/bucket_fields.h"
#include "runtime/effect/field/field_fields.h"
#include "runtime/effect/kite/wire_kite.h"
#include "runtime/effect/scene/scene_fields.h"
#include "runtime/effect/surface/wire_surface.h"
#include "runtime/lua/wire/wire_archive.h"
#include "runtime/lua/wire/wire_fields.h"
#include "runtime/scene/lesson_messages.h"

#include <algorithm>
#include <set>

namespace fulcrum::runtime::wire {

// ---- description
// -----------------------------------------------------------------------------------------------

template <class Archive, class Body>
void body(Archive& a, Body& b) {
    fields(a, "a body", fields::kBody, b);
    a.integer("a line", b.line, 0, kMaxLine);
    a.integer("a body's material", b.material, kNoMaterial, kMaxMaterials - 1);
    optional(a, "a hinge", b.hinge, [](auto& each, auto& h) { hinge(each, h); });
    optional(a, "a rigid body", b.rigid, [](auto& each, auto& r) { rigid(each, r); });
    for (int i = 0; i < 3; ++i) {
        a.number("a body's size", b.size_m[i], 0.0, kMostEdge_m);
    }
    boxes(a, b.boxes);
    a.name("what is felt of a body", b.felt_model);
    a.name("what is simulated of a body", b.simulated_model);
    a.choice("what a body is felt as", b.felt_as, BodyShape::mesh);
    a.choice("what a body collides as", b.collides_as, BodyShape::mesh);
}

template <class Archive, class Force>
void force(Archive& a, Force& f) {
    a.name("a force's name", f.name);
    a.choice("a force's kind", f.field.kind,
             static_cast<FieldKind>(std::tuple_size_v<decltype(fields::kForces)> - 1));
    fields::for_each_force([&](const auto& force) {
        if (force.kind == f.field.kind) {
            fields(a, std::string("a ") + force.name, force.list, f.field);
        }
    });
    a.integer("a line", f.line, 0, kMaxLine);
}

template <class Archive, class Description>
void description(Archive& a, Description& d) {
    fields(a, "the lesson", fields::kLesson, d);
    optional(a, "a limit of force", d.force_limit_N, [](auto& each, auto& limit) {
        each.number("a limit of force", limit, kLeastForceLimit_N, kMostForceLimit_N);
    });
    ladder(a, d.feedback);
    fields(a, "the scene", fields::kGravity, d);
    fields(a, "the ground", fields::kGround, d);
    fields(a, "the contacts", fields::kContacts, d.contacts);
    a.integer("a line", d.contacts.line, 0, kMaxLine);
    a.list("materials", d.materials, kMaxMaterials, [](auto& each, auto& m) { material(each, m); });
    a.list("bodies", d.bodies, static_cast<std::size_t>(kMaxBodies),
           [](auto& each, auto& b) { body(each, b); });
    a.list("forces", d.forces, static_cast<std::size_t>(kMaxFields),
           [](auto& each, auto& f) { force(each, f); });
    a.flag("a bucket", d.bucket.present);
    fields(a, "the bucket", fields::kBucket, d.bucket);
    a.integer("a line", d.bucket.line, 0, kMaxLine);
    a.flag("space", d.in_space);
    fields(a, "the camera", fields::kCamera, d.camera);
    hand(a, d.hand);
    a.list("more hands", d.more_hands, kMostHands - 1, [](auto& each, auto& h) { hand(each, h); });
    optional(a, "a kite", d.kite, [](auto& each, auto& k) { kite(each, k); });
    wind(a, d.wind);
    a.list("questions", d.questions, kMaxQuestions, [](auto& each, auto& q) { question(each, q); });
    a.list("what is known", d.knowledge, kMaxQuestions,
           [](auto& each, auto& k) { knowledge(each, k); });
    a.flag("the past", d.wants_past);
    a.flag("a room", d.is_room);
    a.list("tests", d.tests, kMaxListItems, [](auto& each, auto& t) { test(each, t); });
}

/// Is a name missing or there twice?
template <class Things, class NameOf>
[[nodiscard]] bool has_twin(const Things& things, const NameOf& name_of) {
    std::set<std::string_view> names;
    return std::ranges::any_of(things, [&](const auto& thing) {
        return name_of(thing).empty() || !names.insert(name_of(thing)).second;
    });
}

/// What no single field shows: names that are missing or used twice, too many solids. Null when all
/// is well.
[[nodiscard]] inline const char* find_contradiction(const LessonDescription& d) {
    const auto n_materials = static_cast<std::int32_t>(d.materials.size());
    const auto is_solid = [](const auto& b) { return b.solid; };
    if (has_twin(d.bodies, [](const auto& b) -> const std::string& { return b.name; })) {
        return "has two bodies of one name";
    }
    if (std::ranges::any_of(d.bodies, [&](const auto& b) { return b.material >= n_materials; })) {
        return "has a body of a material that it never made";
    }
    if (has_twin(d.materials, [](const auto& m) -> const std::string& { return m.felt.name; })) {
        return "has two materials of one name";
    }
    if (has_twin(d.forces, [](const auto& f) -> const std::string& { return f.name; })) {
        return "has two forces of one name";
    }
    if (has_twin(d.knowledge, [](const auto& k) -> const std::string& { return k.id; })) {
        return "knows two things of one name";
    }
    if (has_twin(d.questions, [](const auto& q) -> const std::string& { return q.id; })) {
        return "has two questions of one name";
    }
    if (std::ranges::count_if(d.bodies, is_solid) > kMaxSolids) {
        return "has too many solid bodies";
    }
    if (std::ranges::any_of(d.bodies, [](const auto& b) { return b.hinge && !b.solid; })) {
        return "has a hinge on a body that is not solid";
    }
    if (std::ranges::any_of(d.bodies, [](const auto& b) {
            return b.rigid && (!b.solid || b.movable || b.hinge || !(b.mass_kg > 0.0));
        })) {
        return "has a rigid body that is not solid, moves otherwise as well, or has no mass";
    }
    return d.id.empty() ? "has no id" : nullptr;
}

// ---- frame: program -> lesson
// ----------------------------------------------------------------------------------

template <class Archive, class Event>
void event(Archive& a, Event& e) {
    using Kind = std::remove_cvref_t<Event>;
    if constexpr (std::is_same_v<Kind, BodyEvent>) {
        a.choice("an event's kind", e.kind, BodyEvent::Kind::released);
        a.integer("an event's body", e.body, 0, kMaxBodies - 1);
        a.number("an event's speed", e.speed_m_per_s, -1e6, 1e6);
    } else if constexpr (std::is_same_v<Kind, KeyEvent>) {
        a.text("a key", e.key, kMaxNameBytes);
    } else if constexpr (std::is_same_v<Kind, JudgeEvent>) {
        a.name("a question", e.question);
        slots(a, e.slots);
    } else if constexpr (std::is_same_v<Kind, AnsweredEvent>) {
        a.name("a question", e.question);
        a.text("an answer", e.said, kMaxTextBytes);
        slots(a, e.slots);
        a.flag("understood", e.understood);
        a.flag("right", e.right);
        a.flag("form right", e.form_right);
        a.flag("over", e.over);
        a.integer("the attempt", e.attempt, 0, 1'000'000);
        a.flag("turned round", e.turned_round);
        a.flag("to be felt again", e.replay);
        a.flag("form known", e.form_known);
    } else if constexpr (std::is_same_v<Kind, AskedEvent>) {
        a.name("what is asked for", e.knowledge);
        slots(a, e.slots);
    } else {
        static_assert(std::is_same_v<Kind, ReadyEvent>);
        a.list("felt weights", e.felt_weight_N, static_cast<std::size_t>(kMaxBodies),
               [](auto& each, auto& weight) { each.number("a felt weight", weight, 0.0, 1e6); });
        a.number("the felt scale", e.felt_scale, 0.0, 1e6);
        a.list("materials", e.materials, kMaxMaterials, [](auto& each, auto& grades) {
            each.number("hardness", grades.hardness, 0.0, 1.0);
            each.number("roughness", grades.roughness, 0.0, 1.0);
            each.number("slipperiness", grades.slipperiness, 0.0, 1.0);
            each.number("stiffness", grades.stiffness_N_per_m, 0.0, 1e6);
        });
        a.number("today", e.day, -1e6, 1e6);
        a.list("past answers", e.past, kMaxPastAnswers,
               [](auto& each, auto& past) { past_answers(each, past); });
        a.list("lessons", e.lessons, kMaxKnownLessons, [](auto& each, auto& lesson) {
            each.text("a lesson's name", lesson.name, kMaxTextBytes);
            each.text("a lesson's title", lesson.title, kMostTitleBytes);
            each.text("a lesson's level", lesson.level, kMostTitleBytes);
            each.text("a lesson's icon", lesson.icon, kMaxTextBytes);
            each.integer("a lesson's stars", lesson.stars, -1, kMostStars);
        });
    }
}

template <class Archive, class Frame>
void frame(Archive& a, Frame& f) {
    a.number("the time", f.time_s, 0.0, kMaxTold);
    a.number("the time step", f.dt_s, 0.0, kMaxTold);
    pose(a, "the tool", f.tool_pose_W, kMaxTold);
    vector(a, "the tool's velocity", f.tool_twist_W.linear, kMaxTold);
    vector(a, "the tool's turning", f.tool_twist_W.angular, kMaxTold);
    vector(a, "the applied force", f.applied_W.force, kMaxTold);
    vector(a, "the applied torque", f.applied_W.torque, kMaxTold);
    a.integer("the buttons", f.buttons, 0, UINT32_MAX);
    a.list("more hands", f.more_hands, kMostHands - 1, [](auto& each, auto& h) {
        pose(each, "a tool", h.tool_pose_W, kMaxTold);
        vector(each, "a tool's velocity", h.tool_twist_W.linear, kMaxTold);
        vector(each, "a tool's turning", h.tool_twist_W.angular, kMaxTold);
        vector(each, "an applied force", h.applied_W.force, kMaxTold);
        vector(each, "an applied torque", h.applied_W.torque, kMaxTold);
        each.integer("the buttons", h.buttons, 0, UINT32_MAX);
    });
    a.list("bodies", f.bodies, static_cast<std::size_t>(kMaxBodies), [](auto& each, auto& b) {
        pose(each, "a body", b.pose_W, kMaxTold);
        vector(each, "a body's velocity", b.velocity_W, kMaxTold);
        each.choice("where a body is", b.where, BodyWhere::landed);
    });
    a.list("hinges", f.hinges, static_cast<std::size_t>(kMaxSolids), [](auto& each, auto& h) {
        each.number("an angle", h.angle_rad, -kMaxTold, kMaxTold);
        each.number("a spin", h.spin_rad_per_s, -kMaxTold, kMaxTold);
        each.number("a torque", h.torque_Nm, -kMaxTold, kMaxTold);
        each.number("a lever arm", h.arm_m, 0.0, kMaxTold);
        each.number("a load's torque", h.load_torque_Nm, -kMaxTold, kMaxTold);
        each.number("an inertia", h.inertia_kg_m2, 0.0, kMaxTold);
    });
    optional(a, "a kite", f.kite, [](auto& each, auto& k) { kite_state(each, k); });
    a.list("events", f.events, kMaxEvents, [](auto& each, auto& e) {
        each.one_of("an event", e,
                    [](auto& archive, auto& alternative) { event(archive, alternative); });
    });
    a.flag("only verdicts", f.only_asks);
}

// ---- reply: lesson -> program
// ----------------------------------------------------------------------------------

/// What a reply's indices and names may be.
struct ReplyBounds {
    std::int32_t n_bodies = 0;
    std::int32_t n_forces = 0;
    const LessonDescription* description = nullptr;
};

/// The name of a declared question.
template <class Archive, class Text>
void known_question(Archive& a, Text& id, const ReplyBounds& bounds) {
    a.name("a question", id);
    if constexpr (Archive::kReads) {
        const auto& known = bounds.description->questions;
        if (std::none_of(known.begin(), known.end(), [&](const auto& q) { return q.id == id; })) {
            a.refuse("a question", "was never declared");
        }
    }
}

/// Only where there is one.
template <class Archive>
void known_kite(Archive& a, const ReplyBounds& bounds) {
    if constexpr (Archive::kReads) {
        if (!bounds.description->kite) {
            a.refuse("a kite", "was never declared");
        }
    }
}

template <class Archive, class Move>
void move_command(Archive& a, Move& m, const ReplyBounds& bounds) {
    a.choice("a move", m.kind, WorldCommand::Kind::release);
    const bool about_all = m.kind == WorldCommand::Kind::release;
    a.integer("a moved body", m.body, about_all ? kNoBody : 0, bounds.n_bodies - 1);
    vector(a, "a position", m.position_W, kMaxCoordinate_m);
    vector(a, "a velocity", m.velocity_W, kMaxSpeed_m_per_s);
}

template <class Archive, class Turn>
void turn_command(Archive& a, Turn& t, const ReplyBounds& bounds) {
    a.integer("a turned body", t.body, 0, bounds.n_bodies - 1);
    optional(a, "an angle", t.angle_rad, [](auto& each, auto& v) {
        each.number("an angle", v, -kMostTurn_deg, kMostTurn_deg);
    });
    optional(a, "a spin", t.spin_rad_per_s,
             [](auto& each, auto& v) { each.number("a spin", v, -100.0, 100.0); });
    optional(a, "a pivot", t.pivot_W,
             [](auto& each, auto& v) { vector(each, "a pivot", v, kMaxCoordinate_m); });
    optional(a, "a load", t.load_N,
             [](auto& each, auto& v) { each.number("a load", v, 0.0, kMostAxleLoad_N); });
    if constexpr (Archive::kReads) {
        const auto body = static_cast<std::size_t>(t.body);
        const auto& bodies = bounds.description->bodies;
        if (body < bodies.size() && !bodies[body].hinge) {
            a.refuse("a turned body", "has no hinge");
        }
    }
}

template <class Archive, class Force>
void linearised(Archive& a, Force& f) {
    a.number("a force's time", f.stamp_s, -1.0, kMaxTold);
    vector(a, "the lesson's force", f.force_W, kMaxLessonForce_N);
    vector(a, "the lesson's torque", f.torque_W, kMaxLessonTorque_Nm);
    vector(a, "where a force was computed", f.at_position_W, kMaxTold);
    vector(a, "the velocity a force was computed at", f.at_velocity_W, kMaxTold);
    for (int i = 0; i < 9; ++i) {
        a.number("a force's stiffness", f.stiffness_N_per_m(i / 3, i % 3),
                 -kMaxLessonStiffness_N_per_m, kMaxLessonStiffness_N_per_m);
        a.number("a force's damping", f.damping_Ns_per_m(i / 3, i % 3), -kMaxLessonDamping_Ns_per_m,
                 kMaxLessonDamping_Ns_per_m);
        a.number("a torque's stiffness", f.torque_stiffness_Nm_per_m(i / 3, i % 3),
                 -kMaxLessonTorqueStiffness_Nm_per_m, kMaxLessonTorqueStiffness_Nm_per_m);
    }
}

template <class Archive, class Command>
void command(Archive& a, Command& c, const ReplyBounds& bounds) {
    using Kind = std::remove_cvref_t<Command>;
    if constexpr (std::is_same_v<Kind, MoveCommand>) {
        move_command(a, c.move, bounds);
    } else if constexpr (std::is_same_v<Kind, FieldChangeCommand>) {
        a.integer("a force", c.force, 0, bounds.n_forces - 1);
        a.flag("on", c.field.on);
        vector(a, "a force's place", c.field.anchor_W, kMaxCoordinate_m);
        a.number("a force's strength", c.field.strength, 0.0, 1.0);
    } else if constexpr (std::is_same_v<Kind, LessonForceCommand>) {
        linearised(a, c.force);
    } else if constexpr (std::is_same_v<Kind, CaptionCommand> ||
                         std::is_same_v<Kind, PrintCommand>) {
        a.text("a text", c.text, kMaxTextBytes);
    } else if constexpr (std::is_same_v<Kind, AskCommand>) {
        known_question(a, c.question, bounds);
    } else if constexpr (std::is_same_v<Kind, VerdictCommand>) {
        known_question(a, c.question, bounds);
        a.flag("a verdict", c.right);
    } else if constexpr (std::is_same_v<Kind, ScoreCommand>) {
        a.integer("a score", c.score, -kMostScore, kMostScore);
    } else if constexpr (std::is_same_v<Kind, LevelCommand>) {
        a.integer("a level", c.level, 0, kMostLevel);
        a.text("a level's title", c.title, kMostTitleBytes);
    } else if constexpr (std::is_same_v<Kind, SoundCommand>) {
        a.name("a sound", c.name);
    } else if constexpr (std::is_same_v<Kind, CoverCommand>) {
        a.integer("a covered body", c.body, 0, bounds.n_bodies - 1);
        a.flag("covered", c.covered);
    } else if constexpr (std::is_same_v<Kind, MarkCommand>) {
        a.integer("a marked body", c.body, 0, bounds.n_bodies - 1);
        a.number("a mark", c.felt_N, 0.0, kMostMark_N);
    } else if constexpr (std::is_same_v<Kind, LightCommand>) {
        a.integer("a lit body", c.body, 0, bounds.n_bodies - 1);
        a.choice("a light", c.light, BodyLight::lit);
    } else if constexpr (std::is_same_v<Kind, TurnCommand>) {
        turn_command(a, c, bounds);
    } else if constexpr (std::is_same_v<Kind, KiteCommand>) {
        kite_command(a, c);
        known_kite(a, bounds);
    } else if constexpr (std::is_same_v<Kind, WindCommand>) {
        a.number("the wind", c.speed_m_per_s, 0.0, kFastestWind_m_per_s);
        known_kite(a, bounds);
    } else if constexpr (std::is_same_v<Kind, ShowHandCommand>) {
        optional(a, "a shown hand", c.at_W,
                 [](auto& each, auto& v) { vector(each, "a shown hand", v, kMaxCoordinate_m); });
    } else if constexpr (std::is_same_v<Kind, EnterCommand>) {
        a.text("a lesson to enter", c.lesson, kMaxTextBytes);
    } else if constexpr (std::is_same_v<Kind, TellCommand>) {
        a.name("what is told", c.knowledge);
        a.text("what is told", c.text, kMaxTextBytes);
    } else {
        static_assert(std::is_same_v<Kind, FinishCommand>);
        a.integer("stars", c.stars, 0, kMostStars);
    }
}

template <class Archive, class Reply>
void reply(Archive& a, Reply& r, const ReplyBounds& bounds) {
    a.list("commands", r.commands, kMaxCommands, [&](auto& each, auto& c) {
        each.one_of("a command", c, [&](auto& archive, auto& alternative) {
            command(archive, alternative, bounds);
        });
    });
    a.flag("a hand target", r.has_hand_target);
    pose(a, "the hand's target", r.hand_target_W, kFarthestAim_m);
    a.integer("the hand's buttons", r.hand_buttons, 0, UINT32_MAX);
    a.name("the hand's key", r.hand_key);
    a.list("more aims", r.more_aims, kMostHands - 1, [](auto& each, auto& aim) {
        each.flag("an aim", aim.is_given);
        pose(each, "a hand's aim", aim.target_W, kFarthestAim_m);
        each.integer("a hand's buttons", aim.buttons, 0, UINT32_MAX);
    });
}

}  // namespace fulcrum::runtime::wire
