#include "dialogue/marking/feedback_ladder.h"

#include "dialogue/english/letters.h"

#include <algorithm>
#include <array>

namespace fulcrum::dialogue {
namespace {

constexpr std::array<std::string_view, 4> kSteps = {"recast", "prompt", "rule", "replay"};
constexpr const char* kAll = "steps are recast, prompt, rule and replay";

/// What to write instead of a word that is no step.
std::string instead_of(std::string_view word) {
    const auto nearest = std::ranges::min_element(
        kSteps, {}, [&](std::string_view step) { return edit_distance(step, word); });
    return edit_distance(*nearest, word) <= 2 ? concat({"did you mean \"", *nearest, "\"?"})
                                              : std::string(kAll);
}

}  // namespace

FeedbackLadder default_ladder() {
    return {FeedbackStep::recast, FeedbackStep::prompt, FeedbackStep::rule};
}

std::string_view name_of(FeedbackStep step) noexcept {
    return kSteps[static_cast<std::size_t>(step)];
}

Expected<FeedbackLadder> read_ladder(const std::vector<std::string>& names) {
    if (names.empty()) {
        return fail(concat({"a ladder of feedback has a step at least; ", kAll}));
    }
    if (names.size() > kLongestLadder) {
        return fail(concat({"a ladder of feedback has at most ", std::to_string(kLongestLadder),
                            " steps; got ", std::to_string(names.size())}));
    }
    FeedbackLadder ladder;
    for (const std::string& name : names) {
        const auto step = std::ranges::find(kSteps, std::string_view(name));
        if (step == kSteps.end()) {
            return fail(
                concat({"there is no step of feedback \"", name, "\"; ", instead_of(name)}));
        }
        ladder.push_back(static_cast<FeedbackStep>(step - kSteps.begin()));
    }
    return ladder;
}

Expected<FeedbackLadder> read_ladder_text(std::string_view names) {
    std::vector<std::string> list;
    for (std::size_t at = 0; at <= names.size();) {
        const std::size_t end = std::min(names.find(',', at), names.size());
        list.emplace_back(names.substr(at, end - at));
        at = end + 1;
    }
    return read_ladder(list);
}

std::string ladder_text(const FeedbackLadder& ladder) {
    std::string text;
    for (const FeedbackStep step : ladder) {
        text += (text.empty() ? "" : ",") + std::string(name_of(step));
    }
    return text;
}

FeedbackStep step_at(const FeedbackLadder& ladder, int sighting) {
    const FeedbackLadder steps = ladder.empty() ? default_ladder() : ladder;
    const auto rung = static_cast<std::size_t>(std::max(sighting, 1) - 1);
    return steps[std::min(rung, steps.size() - 1)];
}

}  // namespace fulcrum::dialogue
