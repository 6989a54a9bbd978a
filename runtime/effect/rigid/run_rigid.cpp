// The world of rigid bodies, which all hands push and grip.
#include "haptics/dynamics/rigid_loop.h"
#include "runtime/app/running_world.h"

namespace fulcrum::runtime {
namespace {

class RunningRigid final : public RunningWorld {
  public:
    Expected<void> build(const RigidLoopPlan& plan, std::span<HapticChannels* const> hands) {
        std::vector<RigidChannels*> rigid;
        for (const HapticChannels* const hand : hands) {
            rigid.push_back(hand->rigid);
        }
        rate_hz_ = plan.rate_hz;
        return RigidLoop::create(plan, &channels(), rigid)
            .map([&](std::unique_ptr<RigidLoop>&& loop) { loop_ = std::move(loop); });
    }

    // Bodies that are not rigid stand where they were declared.
    void take(const LessonDescription& lesson, std::vector<WorldEvent>& events) override {
        RunningWorld::take(lesson, events);
        if (channels().snapshot.value().n_bodies == 0) {
            return;
        }
        seen_ = channels().snapshot.value();
        seen_.n_bodies = static_cast<std::int32_t>(lesson.bodies.size());
        for (std::size_t i = 0; i < lesson.bodies.size(); ++i) {
            const BodyDescription& body = lesson.bodies[i];
            if (!body.rigid) {
                seen_.bodies[i] = {
                    Pose::at(body.position_W), Vector3::Zero(),
                    body.visible || body.solid ? BodyWhere::placed : BodyWhere::hidden};
            }
        }
    }
    void tell(EffectFrames& frames) const override {
        frames.world = seen_.n_bodies > 0 ? &seen_ : nullptr;
    }
    EffectLoop loop() override { return {"world", rate_hz_, loop_.get()}; }

  private:
    double rate_hz_ = 0.0;
    std::unique_ptr<RigidLoop> loop_;
    WorldSnapshot seen_{};
};

}  // namespace

Expected<std::unique_ptr<RunningEffect>> run_rigid(const EffectParts& parts) {
    if (!parts.plan.rigid) {
        return nullptr;
    }
    auto made = std::make_unique<RunningRigid>();
    return made->build(*parts.plan.rigid, parts.hands).map([&] {
        return std::unique_ptr<RunningEffect>(std::move(made));
    });
}

}  // namespace fulcrum::runtime
