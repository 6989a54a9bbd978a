#include "runtime/effect/surface/plan_walls.h"

#include "haptics/coupling/virtual_coupling.h"

#include <algorithm>
#include <sstream>
#include <string>

namespace fulcrum::runtime {
namespace {

WallLoop loop_of(const HapticPlan& plan) {
    return {plan.rate_hz, plan.safety.max_slew_N_per_s, plan.safety.max_force_N};
}

bool is_softer(const CouplingSettings& felt, const CouplingSettings& wanted) {
    return felt.stiffness_N_per_m < wanted.stiffness_N_per_m ||
           felt.damping_Ns_per_m < wanted.damping_Ns_per_m;
}

/// Stable in the hand of each: what is stable there once may not be when another has lowered it. `asks` is the last that did.
CouplingSettings fit_wall_to_all(const CouplingSettings& wanted, const WallHolders& holders,
                                 const WallLoop& loop, const WallHolder*& asks) {
    CouplingSettings wall = wanted;
    bool is_lowered = true;
    while (is_lowered) {
        is_lowered = false;
        for (const WallHolder& holder : holders) {
            const CouplingSettings fitted = fit_wall(wall, holder, loop);
            if (is_softer(fitted, wall)) {
                asks = &holder;
                is_lowered = true;
                wall = fitted;
            }
        }
    }
    return wall;
}

/// "a stiffness of 4130 N/m and a damping of 4.6 Ns/m"
std::string text_of(const CouplingSettings& wall) {
    std::ostringstream text;
    text << "a stiffness of " << wall.stiffness_N_per_m << " N/m and a damping of "
         << wall.damping_Ns_per_m << " Ns/m";
    return text.str();
}

/// What no rate makes stable by half is no material.
Expected<void> refuse_unstable(const MaterialDescription& material, const WallLoop& loop) {
    const CouplingSettings& wanted = material.felt.coupling;
    WallLoop fastest = loop;
    fastest.rate_hz = kMostRate_Hz;
    const CouplingSettings best = fit_wall(wanted, {}, fastest);
    if (best.stiffness_N_per_m >= kLeastKept * wanted.stiffness_N_per_m &&
        best.damping_Ns_per_m >= kLeastKept * wanted.damping_Ns_per_m) {
        return {};
    }
    return fail(material.felt.name + " would shake in a hand with " + text_of(wanted),
                at_line(material.line),
                "the nearest that " + WallHolder{}.name + " holds is " +
                    text_of(fit_wall(wanted, {}, loop)));
}

/// Makes it as soft as these devices need it; the one that asks for it is told to a teacher. True where it is less stiff.
bool soften(const std::string& what, SourceLine line, const WallHolders& holders,
            CouplingSettings& wall, Plan& plan) {
    const CouplingSettings wanted = wall;
    const WallHolder* asks = nullptr;
    wall = fit_wall_to_all(wanted, holders, loop_of(plan.haptic), asks);
    if (wanted.saturates()) {
        wall = saturate(wall, wanted.linear_range_m, wanted.saturation_force_N);
    }
    if (asks == nullptr) {
        return false;
    }
    std::ostringstream way;
    if (asks->link_s > 0.0) {
        way << " over a link of " << 1.0e3 * asks->link_s << " ms there and back";
    }
    plan.notices.push_back(at_line(line) + ": " + what + " is felt with " + text_of(wall) +
                           ", not with " + text_of(wanted) + ": with these " + asks->name +
                           way.str() + " would shake in a hand.");
    return wall.stiffness_N_per_m < wanted.stiffness_N_per_m;
}

}  // namespace

double find_largest_scale(const LessonDescription& lesson) {
    double scale = lesson.hand.scale;
    for (const HandDescription& hand : lesson.more_hands) {
        scale = std::max(scale, hand.scale);
    }
    return scale;
}

CouplingSettings make_usual_coupling(const HapticPlan& plan, const WallHolders& holders,
                                     double scale) {
    const WallHolder* asks = nullptr;
    CouplingSettings coupling = fit_wall_to_all({}, holders, loop_of(plan), asks);
    scale_coupling(coupling, scale);
    return coupling;
}

void tell_usual_coupling(const LessonDescription& lesson, const WallHolders& holders, Plan& plan) {
    const auto plain = std::ranges::find_if(lesson.bodies, [](const BodyDescription& body) {
        return body.solid && body.material == kNoMaterial;
    });
    if (plain != lesson.bodies.end() && !lesson.hand.tool) {
        CouplingSettings usual;
        if (soften("the " + plain->noun + ", of no material,", plain->line, holders, usual, plan)) {
            plan.softer.push_back(plain->noun);
        }
    }
}

Expected<void> fit_material(const MaterialDescription& described, const WallHolders& holders,
                            Material& material, Plan& plan) {
    if (auto good = refuse_unstable(described, loop_of(plan.haptic)); !good) {
        return good;
    }
    if (soften(material.name, described.line, holders, material.coupling, plan)) {
        plan.softer.push_back(material.name);
    }
    return {};
}

double fit_tool_spring(const LessonDescription& lesson, const WallHolders& holders, Plan& plan) {
    const double wanted = lesson.hand.tool->stiffness_N_per_m;
    CouplingSettings spring{.stiffness_N_per_m = wanted, .damping_Ns_per_m = 0.0};
    soften("the tool's spring", lesson.hand.line, holders, spring, plan);
    return spring.stiffness_N_per_m / wanted;
}

void add_forces(const LessonDescription& lesson, const WallHolders& holders, Plan& plan) {
    // Where the hand goes farther in the scene a spring of the scene is stiffer in the hand.
    const double scale = find_largest_scale(lesson);
    for (const ForceDescription& force : lesson.forces) {
        FieldPlan field = force.field;
        if (field.stiffness_N_per_m > 0.0) {
            CouplingSettings in_hand{.stiffness_N_per_m = field.stiffness_N_per_m * scale,
                                     .damping_Ns_per_m = field.damping_Ns_per_m * scale};
            const CouplingSettings wanted = in_hand;
            soften("the spring \"" + force.name + "\"", force.line, holders, in_hand, plan);
            if (is_softer(in_hand, wanted)) {
                field.stiffness_N_per_m = in_hand.stiffness_N_per_m / scale;
                field.damping_Ns_per_m = in_hand.damping_Ns_per_m / scale;
            }
        }
        plan.haptic.fields.push_back(field);
    }
}

}  // namespace fulcrum::runtime
