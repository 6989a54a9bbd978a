#include "runtime/lesson/why_shown.h"

#include "haptics/math/length.h"
#include "runtime/evidence/record_words.h"
#include "runtime/text/amounts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <utility>

namespace fulcrum::runtime {
namespace {

void calm_down(Wrench& shown, const Wrench& told, double share) {
    shown.force += share * (told.force - shown.force);
    shown.torque += share * (told.torque - shown.torque);
}

const char* key_of(Effect effect) {
    constexpr const char* kKeys[] = {
        "hud.why_tool",  "hud.why_tool_damping", "hud.why_contact", "hud.why_contact_damping",
        "hud.why_grip",  "hud.why_texture",      "hud.why_tap",     "hud.why_weight",
        "hud.why_field", "hud.why_line",         "hud.why_lesson",  "hud.why_brake"};
    static_assert(std::size(kKeys) == kEffectKinds);
    return kKeys[static_cast<std::size_t>(effect)];
}

std::string say_direction(const Vector3& force_W, const dialogue::Catalogue& catalogue) {
    constexpr std::array<std::pair<const char*, const char*>, 3> kWays{
        {{"hud.way_right", "hud.way_left"},
         {"hud.way_up", "hud.way_down"},
         {"hud.way_near", "hud.way_away"}}};
    std::string said;
    for (const int axis : main_axes(force_W)) {
        const auto& [more, less] = kWays[static_cast<std::size_t>(std::abs(axis) - 1)];
        const std::string way = catalogue.say(axis > 0 ? more : less);
        said = said.empty() ? way : catalogue.say("hud.way_and", {{"first", said}, {"next", way}});
    }
    return said;
}

}  // namespace

WhyShown::WhyShown(std::span<const EffectSlot> effects, std::span<const ForceDescription> forces,
                   const MostFelt& most)
    : most_(most) {
    for (const EffectSlot& slot : effects) {
        const auto field = static_cast<std::size_t>(slot.field);
        const bool is_field = slot.effect == Effect::field;
        const bool is_named = is_field && field < forces.size();
        keys_.push_back(key_of(slot.effect));
        calm_.effects.push_back({is_named   ? forces[field].name
                                 : is_field ? std::to_string(field + 1)
                                            : std::string(),
                                 {}});
    }
}

void WhyShown::look(const ForceShares& shares, const HapticState& state, double time_s) {
    const double dt_s = has_looked_ ? time_s - looked_s_ : 0.0;
    if (has_looked_ && !(dt_s > 0.0)) {
        return;
    }
    std::vector<std::string> names;
    names.reserve(calm_.effects.size());
    for (const ForcePart& part : calm_.effects) {
        names.push_back(part.name);
    }
    const auto n = static_cast<std::size_t>(std::max(shares.n, 0));
    const ForceAccount told =
        make_account(names, std::span(shares.each_W).first(std::min(n, shares.each_W.size())),
                     state.commanded_W, state.applied_W, state.gate, state.faults, most_);
    const double share = has_looked_ ? 1.0 - std::exp(-dt_s / kCalm_s) : 1.0;
    for (std::size_t i = 0; i < told.effects.size(); ++i) {
        calm_down(calm_.effects[i].wrench_W, told.effects[i].wrench_W, share);
    }
    calm_down(calm_.asked_W, told.asked_W, share);
    calm_down(calm_.limit_W, told.limit_W, share);
    calm_down(calm_.gate_W, told.gate_W, share);
    calm_down(calm_.felt_W, told.felt_W, share);
    has_looked_ = true;
    looked_s_ = time_s;
}

ViewWhy WhyShown::show(const dialogue::Catalogue& catalogue) const {
    struct Part {
        std::string name;
        Vector3 force_W;
        double newtons;
    };
    std::vector<Part> parts;
    const auto add = [&](const std::string& name, const Vector3& force_W) {
        if (const double newtons = compute_length(force_W); newtons > kShownShare_N) {
            parts.push_back({name, force_W, newtons});
        }
    };
    for (std::size_t i = 0; i < keys_.size(); ++i) {
        const ForcePart& part = calm_.effects[i];
        add(catalogue.say(keys_[i], {{"name", part.name}}), part.wrench_W.force);
    }
    add(catalogue.say("hud.why_limits"), calm_.limit_W.force);
    add(catalogue.say("hud.why_gate"), calm_.gate_W.force);
    std::ranges::stable_sort(parts, std::ranges::greater{}, &Part::newtons);
    // Of what is held back wholly nothing is felt, and it is against what was asked for.
    const Vector3& felt_W = calm_.felt_W.force;
    const Vector3& whole_W = compute_length(felt_W) > kShownShare_N ? felt_W : calm_.asked_W.force;
    ViewWhy why;
    why.visible = true;
    why.title = catalogue.say("hud.why");
    for (const Part& part : parts) {
        why.shares.push_back(
            {part.name,
             catalogue.say("hud.why_share",
                           {{"newtons", newtons_text(part.newtons)},
                            {"direction", say_direction(part.force_W, catalogue)}}),
             part.newtons / parts.front().newtons, part.force_W.dot(whole_W) < 0.0});
    }
    if (why.shares.empty()) {
        why.shares.push_back({catalogue.say("hud.why_nothing"), "", 0.0, false});
    }
    return why;
}

}  // namespace fulcrum::runtime
