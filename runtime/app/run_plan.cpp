#include "runtime/app/run_plan.h"

#include "haptics/dynamics/rigid_loop_plan.h"
#include "haptics/dynamics/world.h"
#include "runtime/app/installation.h"
#include "runtime/app/interrupt.h"
#include "runtime/app/lesson_parts.h"
#include "runtime/files/shape_cache.h"
#include "runtime/scene/compile_plan.h"
#include "runtime/text/progress_line.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace fulcrum::runtime {
namespace {

std::string size_of(const Vector3& reach_m) {
    constexpr double kWholeInCm = 200.0;
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%.0f by %.0f by %.0f cm", kWholeInCm * reach_m.x(),
                  kWholeInCm * reach_m.y(), kWholeInCm * reach_m.z());
    return text.data();
}

// With the user's cache of shapes and a line that says how far it has come; nothing of either where the lesson needs none.
Expected<Plan> compile_shown(const LessonDescription& lesson, PlanOptions options,
                             const SolidLoader& load_solid, const PictureLoader& load_picture) {
    if (!lesson.hand.tool) {
        return compile_plan(lesson, options, load_solid, load_picture);
    }
    const auto folder = default_shape_cache_folder();
    ShapeCache shapes({.folder = folder.value_or(std::filesystem::path{})});
    Expected<Plan> plan = [&] {
        ProgressLine line("Making " + lesson.id + " ready:");
        options.shapes = &shapes;
        options.progress = [&line](double share, std::string_view what) {
            line.say(share, what);
            return !interrupted();
        };
        return compile_plan(lesson, options, load_solid, load_picture);
    }();
    say_all(shapes.told());
    return plan;
}

Expected<void> validate_world(const Plan& plan) {
    return plan.world   ? validate(*plan.world)
           : plan.rigid ? validate(*plan.rigid)
                        : Expected<void>{};
}

// For which walls are made stable: open devices, and those that were where they are repeated, open yet or not.
WallHolders find_holders(const RunHands& hands, const WallHolders& repeated) {
    const bool repeats_all = hands.front()->device->kind() == HandKind::replay;
    WallHolders holders = repeats_all ? repeated : WallHolders{};
    for (std::size_t hand = 0; hand < hands.size(); ++hand) {
        const HandDevice& device = *hands[hand]->device;
        if (device.kind() != HandKind::replay) {
            holders.resize(std::max(holders.size(), hand + 1));
            holders[hand] = device.wall_holder().value_or(WallHolder{});
        }
    }
    return holders;
}

}  // namespace

double find_force_limit_N(const RunRequest& request, const RunHands& hands) {
    double least_N = HandDevice::force_limit_N(request);
    // An arm at the other end of a link tells it when it is open.
    for (const auto& hand : hands) {
        if (hand->device->kind() == HandKind::link) {
            least_N = std::min(least_N, hand->device->device().traits().max_force_N);
        }
    }
    for (const HandChoice& choice : request.more_hands) {
        RunRequest own = request;
        static_cast<HandChoice&>(own) = choice;
        least_N = std::min(least_N, HandDevice::force_limit_N(own));
    }
    return least_N;
}

Expected<void> RunPlan::compile(const RunOrder& order, const LessonDescription& lesson) {
    scene_ = lesson;
    scene_.hand.scale *= order.request.fit.scale.value_or(1.0);
    return compile_for(order, {}, scene_).map([&](Plan&& plan) { plan_ = std::move(plan); });
}

Expected<Plan> RunPlan::compile_for(const RunOrder& order, const RunHands& hands,
                                    const LessonDescription& scene) const {
    PlanOptions options = order.request.plan;
    options.device_force_limit_N = find_force_limit_N(order.request, hands);
    if (!hands.empty()) {
        options.holders = find_holders(hands, order.request.plan.holders);
    }
    const std::filesystem::path& folder = order.request.folder;
    return compile_shown(scene, std::move(options), make_solid_loader(order.places, folder),
                         make_picture_loader(folder, scene.hand.scale))
        .and_then([](Plan&& plan) {
            return validate(plan.haptic).and_then([&] { return validate_world(plan); }).map([&] {
                return std::move(plan);
            });
        });
}

// Weights that were fitted to more than the newest device can give are fitted again, so that what is heavier is felt heavier; and walls, to what
// that holds, and to the way to an arm on a link.
Expected<void> RunPlan::fit_to_force(const RunOrder& order, const RunHands& hands) {
    const bool has_holder = hands.back()->device->wall_holder().has_value();
    if (find_force_limit_N(order.request, hands) >= plan_.haptic.safety.max_force_N &&
        !has_holder) {
        return {};
    }
    return compile_for(order, hands, scene_).map([&](Plan&& plan) { plan_ = std::move(plan); });
}

// The lesson as it is when this hand goes `factor` times as far; its plan must suit the hand's device where that is open.
Expected<Plan> RunPlan::compile_scaled(const RunOrder& order, const RunHands& hands,
                                       std::size_t hand, double factor,
                                       LessonDescription& scene) const {
    (hand == 0 ? scene.hand : scene.more_hands[hand - 1]).scale *= factor;
    return compile_for(order, hands, scene).and_then([&](Plan&& compiled) {
        const HapticPlan& plan = compiled.of_hand(hand);
        const bool is_open = hand < hands.size();
        return (is_open ? validate(plan, hands[hand]->device->device().traits()) : validate(plan))
            .map([&] { return std::move(compiled); });
    });
}

Expected<void> RunPlan::scale_as_said(const RunOrder& order, const RunHands& hands,
                                      std::size_t hand, const HandFit& fit) {
    if (fit.scale.value_or(1.0) == 1.0) {
        return {};
    }
    LessonDescription scene = scene_;
    return compile_scaled(order, hands, hand, *fit.scale, scene).map([&](Plan&& plan) {
        plan_ = std::move(plan);
        scene_ = std::move(scene);
    });
}

void RunPlan::fit_to_reach(const RunOrder& order, const RunHands& hands, std::size_t hand,
                           double factor) {
    const std::string reached = std::string(hand == 0 ? "The arm" : "The second arm") +
                                " reaches " +
                                size_of(hands[hand]->device->device().traits().reach_m);
    LessonDescription scene = scene_;
    auto plan = compile_scaled(order, hands, hand, factor, scene);
    if (!plan) {
        notices_.push_back(
            reached + ", and a part of the scene lies outside that: " + to_sentence(plan.error()));
        return;
    }
    std::array<char, 32> times{};
    std::snprintf(times.data(), times.size(), "%.1f", factor);
    plan_ = std::move(*plan);
    scene_ = std::move(scene);
    notices_.push_back(reached + ", so it moves " + times.data() +
                       " times as far in the scene as the lesson says; --scale says otherwise.");
}

Expected<Plan> RunPlan::compile_changed(
    const RunOrder& order, const RunHands& hands,
    const std::function<void(LessonDescription&)>& change) const {
    LessonDescription scene = scene_;
    change(scene);
    return compile_for(order, hands, scene);
}

}  // namespace fulcrum::runtime
