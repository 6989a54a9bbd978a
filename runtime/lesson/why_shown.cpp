#include "runtime/lesson/why_shown.h"

#include "haptics/math/length.h"
#include "runtime/evidence/record_words.h"
#include "runtime/lesson/compose_view.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace fulcrum::runtime {
namespace {

void calm_down(Wrench& shown, const Wrench& told, double share) {
    shown.force += share * (told.force - shown.force);
    shown.torque += share * (told.torque - shown.torque);
}

}  // namespace

WhyShown::WhyShown(std::vector<std::string> effects, const MostFelt& most) : most_(most) {
    for (std::string& name : effects) {
        calm_.effects.push_back({std::move(name), {}});
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
    for (const ForcePart& part : calm_.effects) {
        add(part.name, part.wrench_W.force);
    }
    add(catalogue.say("hud.why_limits"), calm_.limit_W.force);
    add(catalogue.say("hud.why_gate"), calm_.gate_W.force);
    std::ranges::stable_sort(parts, std::ranges::greater{}, &Part::newtons);
    ViewWhy why;
    why.visible = true;
    why.title = catalogue.say("hud.why");
    for (const Part& part : parts) {
        why.shares.push_back(
            {part.name, newtons_text(part.newtons) + " N " + direction_words(part.force_W),
             part.newtons / parts.front().newtons, part.force_W.dot(calm_.felt_W.force) < 0.0});
    }
    if (why.shares.empty()) {
        why.shares.push_back({catalogue.say("hud.why_nothing"), "", 0.0, false});
    }
    return why;
}

}  // namespace fulcrum::runtime
