// A world that is told what a lesson wants moved, and tells where its bodies are and what happened to them.
#pragma once

#include "runtime/app/running_effect.h"
#include "runtime/app/world_post.h"

namespace fulcrum::runtime {

class RunningWorld : public RunningEffect {
  public:
    void take(const LessonDescription& /*lesson*/, std::vector<WorldEvent>& events) override {
        channels_.snapshot.take();
        for (WorldEvent event; channels_.events.pop(event);) {
            events.push_back(event);
        }
    }
    [[nodiscard]] Expected<void> order(const EffectOrders& orders) override {
        return send(orders.world);
    }
    [[nodiscard]] Expected<void> send(std::span<const WorldCommand> commands) {
        return to_world_.send(commands, channels_.commands);
    }

  protected:
    [[nodiscard]] WorldChannels& channels() { return channels_; }
    [[nodiscard]] const WorldChannels& channels() const { return channels_; }

  private:
    WorldChannels channels_;
    WorldPost to_world_;
};

}  // namespace fulcrum::runtime
