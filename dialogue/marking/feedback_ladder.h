// The ladder of feedback on form: what a learner is answered whose meaning is right and whose form is not, by how often
// the same error has been made. The n-th sighting gets the n-th step, and whoever stands on the last one stays there.
//
//   recast    the right sentence is said back
//   prompt    the learner may say it once more, with a gap where the error was
//   rule      the right sentence, and its rule in one line
//   replay    the right sentence, and the arm lets the hand feel again what it is about
//
// Thread: pure.  Cost: none; read at load.
// Source: Lyster and Ranta 1997, "Corrective feedback and learner uptake", Studies in Second Language Acquisition 19(1):
//   recasts are heard most and taken up least, prompts are taken up, rules are for those whom neither helps.
#pragma once

#include "dialogue/result.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::dialogue {

enum class FeedbackStep : std::uint8_t { recast, prompt, rule, replay };

/// Steps in order, 1 to kLongestLadder; a step may stand there several times.
using FeedbackLadder = std::vector<FeedbackStep>;

inline constexpr std::size_t kLongestLadder = 8;

/// Recast, prompt, rule.
[[nodiscard]] FeedbackLadder default_ladder();

/// "recast", "prompt", "rule", "replay".
[[nodiscard]] std::string_view name_of(FeedbackStep step) noexcept;

/// The steps of these names. An error, without a place, for none, too many or a word that is no step.
[[nodiscard]] Expected<FeedbackLadder> read_ladder(const std::vector<std::string>& names);

/// The same from one text, "recast,prompt,rule", and back.
[[nodiscard]] Expected<FeedbackLadder> read_ladder_text(std::string_view names);
[[nodiscard]] std::string ladder_text(const FeedbackLadder& ladder);

/// The step for the `sighting`-th time of the same error, 1 the first. An empty ladder is the default one.
[[nodiscard]] FeedbackStep step_at(const FeedbackLadder& ladder, int sighting);

}  // namespace fulcrum::dialogue
