#include "runtime/scene/plan.h"

#include <algorithm>

namespace fulcrum::runtime {

std::string_view name_of(SpeechInput speech) {
    switch (speech) {
        case SpeechInput::text:
            return "text";
        case SpeechInput::sphinx:
            return "sphinx";
        case SpeechInput::external:
            return "exec";
    }
    return "";
}

bool Plan::has(const std::string& loop, const std::string& name) const {
    return std::any_of(stages.begin(), stages.end(), [&](const PlanStage& stage) {
        return stage.loop == loop && stage.name == name;
    });
}

}  // namespace fulcrum::runtime
