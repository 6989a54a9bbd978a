// The load path of rigid_loop.h.
#include "haptics/base/range.h"
#include "haptics/dynamics/rigid_loop.h"

#include <algorithm>
#include <set>
#include <utility>

namespace fulcrum {
namespace {

bool is_of_world(std::int32_t body, const RigidLoopPlan& plan) {
    return body >= kNoBody && body < static_cast<std::int32_t>(plan.world.bodies.size());
}

bool are_scene_bodies(const RigidLoopPlan& plan) {
    std::set<std::int32_t> taken;
    return plan.scene_bodies.size() == plan.world.bodies.size() &&
           std::ranges::all_of(plan.scene_bodies, [&](std::int32_t body) {
               return body == kNoBody ||
                      (body >= 0 && body < kMaxBodies && taken.insert(body).second);
           });
}

}  // namespace

Expected<void> validate(const RigidLoopPlan& plan) {
    const Range ranges[] = {
        {"rate in hertz", plan.rate_hz, 50.0, 5000.0},
        {"number of solids", static_cast<double>(plan.solids.size()), 0.0, kMaxSolids},
    };
    if (auto checked = check_ranges("the loop of rigid bodies'", ranges); !checked) {
        return checked;
    }
    const auto is_known = [&](std::int32_t body) { return is_of_world(body, plan); };
    if (!are_scene_bodies(plan) || !is_known(plan.carrier) ||
        !std::ranges::all_of(plan.solids, is_known) ||
        !std::ranges::all_of(plan.hidden,
                             [&](std::int32_t body) { return body >= 0 && is_known(body); })) {
        return fail("the loop of rigid bodies names bodies that there are not, or twice", {},
                    "give each body of the world one of the scene, or none");
    }
    return validate(plan.world);
}

Expected<std::unique_ptr<RigidLoop>> RigidLoop::create(const RigidLoopPlan& plan,
                                                       WorldChannels* lesson,
                                                       std::span<RigidChannels* const> hands) {
    if (auto valid = validate(plan); !valid) {
        return tl::make_unexpected(valid.error());
    }
    return RigidWorld::create(plan.world).map([&](std::unique_ptr<RigidWorld> world) {
        return std::unique_ptr<RigidLoop>(new RigidLoop(plan, std::move(world), lesson, hands));
    });
}

RigidLoop::RigidLoop(const RigidLoopPlan& plan, std::unique_ptr<RigidWorld> world,
                     WorldChannels* lesson, std::span<RigidChannels* const> hands)
    : world_(std::move(world)),
      period_s_(1.0 / plan.rate_hz),
      told_(plan.world.bodies.size()),
      body_of_scene_(kMaxBodies, kNoBody),
      solids_(plan.solids),
      carrier_(plan.carrier),
      up_W_(-plan.world.settings.gravity_W.normalized()),
      lesson_(lesson),
      hands_(hands.begin(), hands.end()) {
    for (std::size_t i = 0; i < told_.size(); ++i) {
        const std::int32_t scene_body = plan.scene_bodies[i];
        told_[i].scene_body = scene_body;
        told_[i].stays = plan.world.bodies[i].role != BodyRole::moves;
        if (scene_body >= 0) {
            body_of_scene_[static_cast<std::size_t>(scene_body)] = static_cast<std::int32_t>(i);
            snapshot_.n_bodies = std::max(snapshot_.n_bodies, scene_body + 1);
        }
    }
    for (const std::int32_t body : plan.hidden) {
        told_[static_cast<std::size_t>(body)].is_present = false;
        world_->set_present(body, false);
    }
    world_->prepare(period_s_);
}

RigidLoop::~RigidLoop() = default;

}  // namespace fulcrum
