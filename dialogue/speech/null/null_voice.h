// A voice that says nothing: for tests and silent runs.
#pragma once

#include "dialogue/speech/voice.h"

namespace fulcrum::dialogue {

/// Never speaks.
class NullVoice final : public Voice {
  public:
    void say(std::string_view) override {}
    void step(double) override {}
    void stop() override {}
    [[nodiscard]] bool speaking() const override { return false; }
    [[nodiscard]] std::string_view name() const override { return "null"; }
};

}  // namespace fulcrum::dialogue
