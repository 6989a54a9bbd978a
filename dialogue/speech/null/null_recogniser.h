// A recogniser that hears nothing: for lessons without questions.
#pragma once

#include "dialogue/speech/recogniser.h"

namespace fulcrum::dialogue {

/// Never returns an answer.
class NullRecogniser final : public Recogniser {
  public:
    [[nodiscard]] Expected<bool> listen(std::shared_ptr<const TemplateSet> templates) override {
        listening_ = templates != nullptr;
        return true;
    }
    [[nodiscard]] std::vector<Hypothesis> poll() override { return {}; }
    void stop() override { listening_ = false; }
    [[nodiscard]] bool listening() const override { return listening_; }
    [[nodiscard]] std::string_view name() const override { return "null"; }

  private:
    bool listening_ = false;
};

}  // namespace fulcrum::dialogue
