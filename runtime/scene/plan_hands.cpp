#include "runtime/scene/plan_hands.h"

#include "runtime/effect/surface/plan_touch.h"
#include "runtime/effect/surface/plan_walls.h"
#include "runtime/scene/asked_by.h"

#include <algorithm>
#include <string>
#include <utility>

namespace fulcrum::runtime {
namespace {

Expected<void> refuse_beside_hands(const char* what, SourceLine line) {
    return fail(std::string(what) + ", and the lesson has two hands", at_line(line),
                "leave out one of them: two hands go with solid and rigid bodies and declared "
                "forces");
}

}  // namespace

LessonDescription as_seen_by(const LessonDescription& lesson, std::size_t hand) {
    LessonDescription seen = lesson;
    if (hand > 0) {
        seen.hand = lesson.more_hands[hand - 1];
        seen.hand.rate_hz = lesson.hand.rate_hz;
    }
    seen.more_hands.clear();
    return seen;
}

std::string name_of_loop(std::size_t hand) {
    return hand == 0 ? "haptic" : "hand " + std::to_string(hand + 1);
}

Expected<void> check_more_hands(const LessonDescription& lesson) {
    if (lesson.more_hands.empty()) {
        return {};
    }
    const SourceLine line = lesson.more_hands.front().line;
    if (lesson.bucket.present) {
        return refuse_beside_hands("a bucket hangs on one hand", lesson.bucket.line);
    }
    if (lesson.kite) {
        return refuse_beside_hands("a kite's line is held by one hand", lesson.kite->line);
    }
    if (lesson.hand.lesson_force) {
        return refuse_beside_hands("the lesson's own force is for one hand",
                                   lesson.hand.force_line);
    }
    if (lesson.hand.tool || std::ranges::any_of(lesson.more_hands, [](const auto& hand) {
            return hand.tool.has_value();
        })) {
        return refuse_beside_hands("a tool needs the time of one hand", line);
    }
    for (const BodyDescription& body : lesson.bodies) {
        if (body.movable) {
            return refuse_beside_hands(("the " + body.noun + " is movable").c_str(), body.line);
        }
        if (body.hinge) {
            return refuse_beside_hands(("the " + body.noun + " is on a hinge").c_str(), body.line);
        }
    }
    return {};
}

Expected<void> add_more_hands(const LessonDescription& lesson, const SolidLoader& load_solid,
                              const std::vector<Material>& materials, const PlanOptions& options,
                              Plan& plan) {
    const std::size_t n_hands = std::min(options.n_hands, 1 + lesson.more_hands.size());
    for (std::size_t i = 1; i < n_hands; ++i) {
        const LessonDescription seen = as_seen_by(lesson, i);
        HapticPlan hand = plan.haptic;
        hand.workspace.pose_WD.position = seen.hand.centre_W;
        hand.workspace.scale = seen.hand.scale;
        hand.velocity_method = seen.hand.velocity;
        hand.coupling = make_usual_coupling(hand, options.holders, seen.hand.scale);
        // The same bodies, as stiff in this hand as in the other one; they are heard of the first.
        hand.solids.clear();
        if (auto solids = add_solids(seen, load_solid, materials, false, hand); !solids) {
            return solids;
        }
        if (auto proxy = choose_proxy(seen, load_solid, hand); !proxy) {
            return proxy;
        }
        plan.more_hands.push_back(std::move(hand));
    }
    return {};
}

}  // namespace fulcrum::runtime
