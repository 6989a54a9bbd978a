#include "runtime/scene/compile_plan.h"

#include "haptics/field/field.h"
#include "runtime/effect/kite/plan_kite.h"
#include "runtime/effect/rigid/plan_rigid.h"
#include "runtime/effect/surface/plan_touch.h"
#include "runtime/effect/surface/plan_walls.h"
#include "runtime/effect/tool/plan_tool.h"
#include "runtime/scene/asked_by.h"
#include "runtime/scene/plan_hands.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numeric>
#include <set>

namespace fulcrum::runtime {
namespace {

constexpr std::size_t kFreeEnglish_bytes = 16'000'000;  // fulcrum bench english measures it

Expected<void> check_counts(const LessonDescription& lesson) {
    if (lesson.bodies.size() > static_cast<std::size_t>(kMaxBodies)) {
        return fail("the lesson has " + std::to_string(lesson.bodies.size()) + " bodies",
                    at_line(lesson.bodies[kMaxBodies].line),
                    "use at most " + std::to_string(kMaxBodies));
    }
    if (lesson.forces.size() > static_cast<std::size_t>(kMaxFields)) {
        return fail("the lesson has " + std::to_string(lesson.forces.size()) + " forces",
                    at_line(lesson.forces[kMaxFields].line),
                    "use at most " + std::to_string(kMaxFields));
    }
    std::set<std::string> names;
    for (const BodyDescription& body : lesson.bodies) {
        if (!names.insert(body.name).second) {
            return fail("two bodies are called \"" + body.name + "\"", at_line(body.line),
                        "give each a name of its own");
        }
    }
    return {};
}

// The simulated physics is the answer key, so a hand must never feel two things the other way
// round.
Expected<void> check_felt_order(const std::vector<BodyDescription>& bodies) {
    for (const BodyDescription& a : bodies) {
        for (const BodyDescription& b : bodies) {
            const bool felt_heavier = a.mass_kg * a.exaggeration >= b.mass_kg * b.exaggeration;
            if (a.movable && b.movable && a.mass_kg < b.mass_kg && felt_heavier) {
                return fail("the " + a.noun + " is lighter than the " + b.noun +
                                " but would not feel lighter",
                            at_line(a.line), "change one of their exaggerations");
            }
        }
    }
    return {};
}

// Each field is in its range; together, and seen through the workspace's scale, they must be too: what is stiffer than an arm
// and its loop can hold shakes instead of pulling. The slopes of a lesson's own force get what these leave.
Expected<void> check_felt_fields(const LessonDescription& lesson) {
    const double scale = find_largest_scale(lesson);
    double stiffness_N_per_m = 0.0;
    double damping_Ns_per_m = 0.0;
    for (const ForceDescription& force : lesson.forces) {
        const FieldGains gains = compute_largest_gains(force.field);
        stiffness_N_per_m += gains.stiffness_N_per_m * scale;
        damping_Ns_per_m += gains.damping_Ns_per_m * scale;
        // NaN (a magnet without a range) is too much as well.
        if (!(stiffness_N_per_m <= kMaxFeltStiffness_N_per_m) ||
            !(damping_Ns_per_m <= kMaxFeltDamping_Ns_per_m)) {
            return fail("the forces up to \"" + force.name +
                            "\" are together too stiff for a hand at scale " +
                            std::to_string(scale),
                        at_line(force.line),
                        "keep the sum of stiffness times scale under 2000 N/m, of damping times "
                        "scale under 50 Ns/m");
        }
    }
    return {};
}

Plan begin_plan(const LessonDescription& lesson, const PlanOptions& options) {
    Plan begun;
    HapticPlan& plan = begun.haptic;
    plan.rate_hz = lesson.hand.rate_hz;
    plan.velocity_method = lesson.hand.velocity;
    plan.workspace.pose_WD.position = lesson.hand.centre_W;
    plan.workspace.scale = lesson.hand.scale;
    apply(options.site, plan.safety);
    plan.coupling = make_usual_coupling(plan, options.holders, lesson.hand.scale);
    plan.lesson_force = lesson.hand.lesson_force;
    plan.expects_lesson = true;
    add_forces(lesson, options.holders, begun);
    tell_usual_coupling(lesson, options.holders, begun);
    return begun;
}

WorldPlan world_plan(const LessonDescription& lesson, const FeltWeights& felt) {
    WorldPlan plan;
    plan.gravity_W = lesson.gravity_W;
    plan.ground_height_m = lesson.ground_height_m;
    const double gravity = lesson.gravity_W.norm();
    for (std::size_t i = 0; i < lesson.bodies.size(); ++i) {
        const BodyDescription& body = lesson.bodies[i];
        const double felt_mass_kg = gravity > 0.0 ? felt.newtons[i] / gravity : 0.0;
        // What only stands there may have no mass.
        const double mass_kg =
            body.movable ? body.mass_kg : std::max(body.mass_kg, kLeastFalling_kg);
        plan.bodies.push_back({mass_kg, felt_mass_kg, body.radius_m, body.drag_area_m2});
    }
    plan.catcher.present = lesson.bucket.present;
    plan.catcher.opening_radius_m = lesson.bucket.opening_radius_m;
    plan.catcher.depth_m = lesson.bucket.depth_m;
    plan.catcher.capacity = lesson.bucket.holds;
    return plan;
}

const BodyDescription* first_movable(const LessonDescription& lesson) {
    const auto found = std::ranges::find_if(lesson.bodies, &BodyDescription::movable);
    return found == lesson.bodies.end() ? nullptr : &*found;
}

std::string text_of_structure(const ProxySettings& proxy) {
    return proxy.structure == SegmentStructureKind::bounding_tree
               ? ""
               : ", found by " + std::string(name_of(proxy.structure));
}

void list_other_loops(const LessonDescription& lesson, Plan& plan) {
    const auto add = [&plan](std::string loop, std::string name, double rate_hz,
                             std::string because, SourceLine line) {
        plan.stages.push_back(
            {std::move(loop), std::move(name), rate_hz, 0, std::move(because), line});
    };
    if (plan.world) {
        const BodyDescription* movable = first_movable(lesson);
        add("world", "falling bodies", plan.world->rate_hz, "bodies may fall", movable->line);
        if (lesson.bucket.present) {
            add("world", "bucket", plan.world->rate_hz, "the tool catches", lesson.bucket.line);
        }
    }
    if (plan.haptic.tool && has_thread(*lesson.hand.tool)) {
        plan.stages.push_back(make_contact_stage(lesson, plan));
    }
    if (plan.kite) {
        add("kite", "flight", plan.kite->rate_hz, "a kite flies on the hand's line",
            lesson.kite->line);
        plan.stages.back().memory_bytes = count_kite_bytes(plan.kite->flight);
    }
    if (plan.rigid) {
        const ContactMethod method = plan.rigid->world.settings.solver.method;
        add("world", "rigid bodies", plan.rigid->rate_hz,
            "bodies lie, fall and are pushed; solved by " + std::string(to_string(method)),
            lesson.contacts.line > 0 ? lesson.contacts.line : first_rigid_line(lesson));
        if (plan.rigid->carrier >= 0) {
            add("world", "bucket", plan.rigid->rate_hz, "the hand holds it; hard, massive",
                lesson.bucket.line);
        }
    }
    add("lesson", "lua", plan.haptic.lesson_rate_hz, "every lesson is a Lua file", 0);
    if (plan.dialogue) {
        add("lesson", "dialogue", 0.0,
            "it asks questions, answered as " + std::string(name_of(plan.speech)),
            line_of_dialogue(lesson));
    }
    if (plan.partner.kind != PartnerKind::shipped) {
        add("lesson", "partner", 0.0, why_of(plan.partner.kind), line_of_dialogue(lesson));
    }
    if (plan.free_english) {
        add("lesson", "free English", 0.0, "it checks what fits no answer",
            lesson.questions.front().line);
        plan.stages.back().memory_bytes = kFreeEnglish_bytes;
    }
    if (plan.recogniser) {
        add("speech", "recogniser", 0.0, "answers are spoken", line_of_dialogue(lesson));
    }
    if (plan.microphone) {
        add("speech", "microphone", 100.0, "somebody is there to speak", line_of_dialogue(lesson));
    }
    if (plan.picture) {
        add("picture", "scene", 60.0, "there is somebody to see it (--picture)", 0);
    }
    if (plan.sound) {
        add("sound", "mixer", 100.0, "there is somebody to hear it", 0);
    }
    if (plan.touch_sound) {
        add("sound", "touch", 48000.0, "what is stroked and tapped is heard",
            first_material_line(lesson));
    }
    if (plan.record) {
        add("record", "writer", plan.haptic.rate_hz, "--record was given", 0);
    }
}

template <class Add>
void list_surface_stages(const LessonDescription& lesson, const HapticPlan& haptic,
                         const Add& add) {
    const auto find = [&](auto has) -> const SolidPlan* {
        const auto found = std::ranges::find_if(haptic.solids, has);
        return found == haptic.solids.end() ? nullptr : &*found;
    };
    const SolidPlan* rough =
        find([](const SolidPlan& solid) { return solid.surface.texture.any(); });
    const SolidPlan* ringing =
        find([](const SolidPlan& solid) { return solid.surface.transient.any(); });
    if (rough != nullptr) {
        add(HapticStage::texture, "a surface has a texture",
            lesson.bodies[static_cast<std::size_t>(rough->body)].line);
    }
    if (ringing != nullptr) {
        add(HapticStage::transient, "a surface answers a tap",
            lesson.bodies[static_cast<std::size_t>(ringing->body)].line);
    }
}

template <class Add>
void list_moving_stages(const LessonDescription& lesson, const HapticPlan& haptic, const Add& add) {
    if (!haptic.axles.empty()) {
        const SolidPlan& solid = haptic.solids[haptic.axles.front().solid];
        add(HapticStage::turning, "a body turns on a hinge",
            lesson.bodies[static_cast<std::size_t>(solid.body)].line);
    }
    if (!haptic.rigid.empty()) {
        add(HapticStage::pushing,
            "the hand pushes rigid bodies, and one that it grips is hard and massive",
            first_rigid_line(lesson));
    }
}

// Of one hand, as if the lesson had no other.
void list_haptic_stages(const LessonDescription& lesson, const HapticPlan& haptic,
                        const std::string& loop, Plan& plan) {
    const auto add = [&](HapticStage stage, std::string because, SourceLine line) {
        plan.stages.push_back({loop, name_of(stage), haptic.rate_hz, 0, std::move(because), line});
    };
    // Of a hand beside the first the lesson has asked in that line.
    const SourceLine line_of_hand = loop == name_of_loop(0) ? 0 : lesson.hand.line;
    add(HapticStage::take_inputs, "the lesson and the world speak to it", 0);
    add(HapticStage::read, "a hand holds the device", line_of_hand);
    const bool is_usual_velocity = haptic.velocity_method == VelocityMethod::adaptive_window;
    add(HapticStage::estimate,
        "dampers and the lesson need a velocity, by " +
            std::string(name_of(haptic.velocity_method)),
        is_usual_velocity ? 0 : lesson.hand.line);
    if (haptic.tool) {
        add(HapticStage::tool,
            "a " + name_of(*lesson.hand.tool) + " meets bodies; " +
                find_quadrant(lesson.hand.tool->method, haptic.tool->settings.mass),
            lesson.hand.line);
        list_moving_stages(lesson, haptic, add);
    } else if (!haptic.solids.empty()) {
        const auto body = static_cast<std::size_t>(haptic.solids.front().body);
        add(HapticStage::proxy,
            "a body can be touched, by a " + std::string(name_of(haptic.proxy.kind)) +
                text_of_structure(haptic.proxy) + "; hard, massless",
            lesson.hand.proxy ? lesson.hand.line : lesson.bodies[body].line);
        add(HapticStage::coupling, "a body can be touched", lesson.bodies[body].line);
        list_moving_stages(lesson, haptic, add);
        list_surface_stages(lesson, haptic, add);
    }
    if (haptic.carries_weight) {
        const SourceLine line =
            lesson.bucket.present ? lesson.bucket.line : first_movable(lesson)->line;
        add(HapticStage::weight, "a body can be carried", line);
    }
    for (const ForceDescription& force : lesson.forces) {
        add(stage_of(force.field.kind), "the lesson declares \"" + force.name + "\"", force.line);
    }
    if (haptic.line) {
        add(HapticStage::line, "the hand holds a kite's line", lesson.kite->line);
    }
    if (haptic.lesson_force) {
        add(HapticStage::lesson, "the lesson computes a force", lesson.hand.force_line);
    }
    if (has_forces(haptic)) {
        add(HapticStage::passivity, "no force may feed a buzz", 0);
    }
    add(HapticStage::limits, "a child's hand is near", 0);
    add(HapticStage::write, "the device renders it", 0);
    add(HapticStage::publish, "the other loops read it", 0);
    if (plan.record && loop == name_of_loop(0)) {
        add(HapticStage::record, "--record was given", 0);
    }
}

}  // namespace

FeltWeights fit_felt_weights(const std::vector<BodyDescription>& bodies, double gravity_m_per_s2,
                             int holds, double force_limit_N) {
    FeltWeights felt;
    for (const BodyDescription& body : bodies) {
        felt.newtons.push_back(body.movable ? body.mass_kg * gravity_m_per_s2 * body.exaggeration
                                            : 0.0);
    }
    // The heaviest load: as many of the heaviest bodies as the bucket holds.
    std::vector<double> heaviest_first = felt.newtons;
    std::sort(heaviest_first.begin(), heaviest_first.end(), std::greater<>());
    const auto n = std::min(static_cast<std::size_t>(std::max(holds, 0)), heaviest_first.size());
    const auto end = heaviest_first.begin() + static_cast<std::ptrdiff_t>(n);
    const double load_N = std::accumulate(heaviest_first.begin(), end, 0.0);
    // One factor for all keeps order and ratios.
    const double allowed_N = kWeightShareOfLimit * force_limit_N;
    if (load_N > allowed_N) {
        felt.scale = allowed_N / load_N;
        for (double& newtons : felt.newtons) {
            newtons *= felt.scale;
        }
    }
    return felt;
}

namespace {

// What the person at the keyboard chose.
void take_options(const LessonDescription& lesson, const PlanOptions& options, Plan& plan) {
    plan.picture = options.picture;
    plan.sound = options.sound;
    plan.record = options.record;
    plan.live = options.live;
    plan.day = options.day;
    plan.holders = options.holders;
    plan.dialogue = !lesson.questions.empty() || !lesson.knowledge.empty();
    plan.free_english = !lesson.questions.empty() && lesson.free_english;
    plan.speech = options.speech;
    plan.partner = plan.dialogue ? options.partner : PartnerOrder{};
    plan.recogniser = plan.dialogue && options.speech != SpeechInput::text;
    if (plan.recogniser) {
        plan.hearing = options.hearing;
        plan.waits_for_hearing = !options.live;
        plan.microphone = options.live && options.hearing.recordings.empty();
    }
}

}  // namespace

Expected<Plan> compile_plan(const LessonDescription& lesson, const PlanOptions& asked,
                            const SolidLoader& load_solid, const PictureLoader& load_picture) {
    PlanOptions options = asked;
    options.site = lower(asked.site, lesson.force_limit_N);
    const auto good = check_counts(lesson)
                          .and_then([&] { return check_felt_fields(lesson); })
                          .and_then([&] { return check_more_hands(lesson); })
                          .and_then([&] { return check_felt_order(lesson.bodies); });
    if (!good) {
        return tl::unexpected(good.error());
    }

    Plan plan = begin_plan(lesson, options);
    const auto materials = make_materials(lesson, options.holders, load_picture, plan);
    if (!materials) {
        return tl::unexpected(materials.error());
    }
    std::ranges::transform(*materials, std::back_inserter(plan.material_facts), describe);
    if (auto solids = add_solids(lesson, load_solid, *materials, options.sound, plan.haptic);
        !solids) {
        return tl::unexpected(solids.error());
    }
    if (auto proxy = choose_proxy(lesson, load_solid, plan.haptic); !proxy) {
        return tl::unexpected(proxy.error());
    }
    if (auto tool = add_tool(lesson, load_solid, options, plan); !tool) {
        return tl::unexpected(tool.error());
    }
    if (auto kite = add_kite(lesson, options, plan); !kite) {
        return tl::unexpected(kite.error());
    }
    plan.touch_sound = std::ranges::any_of(
        plan.haptic.solids, [](const SolidPlan& solid) { return solid.surface.audible; });

    // Weights fit under the limit; a world exists only when something may move in it.
    const int holds = lesson.bucket.present ? lesson.bucket.holds : 1;
    const FeltWeights felt =
        fit_felt_weights(lesson.bodies, lesson.gravity_W.norm(), holds,
                         std::min(options.site.force_N, options.device_force_limit_N));
    plan.felt_weight_N = felt.newtons;
    plan.felt_scale = felt.scale;
    if (auto rigid = add_rigid_bodies(lesson, load_solid, options, plan); !rigid) {
        return tl::unexpected(rigid.error());
    }
    if (auto hands = add_more_hands(lesson, load_solid, *materials, options, plan); !hands) {
        return tl::unexpected(hands.error());
    }
    if (first_movable(lesson) != nullptr) {
        plan.world = world_plan(lesson, felt);
        plan.haptic.expects_world = true;
        plan.haptic.carries_weight = true;
    }
    take_options(lesson, options, plan);
    list_haptic_stages(lesson, plan.haptic, name_of_loop(0), plan);
    for (std::size_t i = 1; i <= plan.more_hands.size(); ++i) {
        list_haptic_stages(as_seen_by(lesson, i), plan.more_hands[i - 1], name_of_loop(i), plan);
    }
    list_other_loops(lesson, plan);
    return plan;
}

}  // namespace fulcrum::runtime
