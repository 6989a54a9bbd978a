// One turn of a conversation: what was said, how it was understood and judged, and how the question stands then. Whoever answers the learner
// (dialogue/partner/partner.h) has this and no more, and nothing flows back from there.
//
//   words --hear--> Mark --respond, with the verdict--> Turn --> the partner's words;  the record, the store, the lesson
//
// Thread: values.
#pragma once

#include "dialogue/checking/checked_text.h"
#include "dialogue/conversation/course.h"
#include "dialogue/marking/mark.h"
#include "dialogue/marking/question.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::dialogue {

/// What kind of answer the learner gets.
enum class FeedbackKind : std::uint8_t {
    praise,          ///< meaning and form are right
    recast,          ///< meaning right; the right sentence is said back
    prompt,          ///< meaning right; the learner may say it once more
    rule,            ///< meaning right; the right sentence and its rule
    replay,          ///< meaning right; the right sentence, and what it is about is felt again
    wrong_meaning,   ///< asked again, with what the question itself says then
    not_understood,  ///< no sentence fits; asked again
    heard_badly,     ///< the recogniser isn't sure; asked again
    moved_on         ///< left for now
};

/// What was made of an invitation to say it once more; none, too, where the form of what was said then was not heard.
enum class Uptake : std::uint8_t { none, repaired, not_repaired };

/// For files and databases: "praise", "wrong_meaning"; "repaired", and nothing where there was no invitation.
[[nodiscard]] constexpr std::string_view name_of(FeedbackKind kind) noexcept {
    constexpr std::string_view kNames[] = {"praise",         "recast",      "prompt",
                                           "rule",           "replay",      "wrong_meaning",
                                           "not_understood", "heard_badly", "moved_on"};
    return kNames[static_cast<std::size_t>(kind)];
}
[[nodiscard]] constexpr std::string_view name_of(Uptake uptake) noexcept {
    constexpr std::string_view kNames[] = {"", "repaired", "not_repaired"};
    return kNames[static_cast<std::size_t>(uptake)];
}

/// What is done about an answer; the words for it are the partner's.
struct Feedback {
    FeedbackKind kind = FeedbackKind::praise;
    CourseStep came{};        ///< how the question stands after it; not taken: it was out of turn
    bool ask_again = false;   ///< the question stays open
    bool may_repeat = false;  ///< one more `hear` is welcome; the question is done even without it
    bool replay = false;  ///< let the hand feel the contrast again: a wrong meaning, or that step
    Uptake uptake = Uptake::none;
    int attempt = 0;  ///< the number of this answer to the question, from 1
    std::vector<FreeError>
        free_errors{};  ///< of form, in words that fit no answer; good English for them is shown
};

struct Turn {
    const Question* asked = nullptr;  ///< until the next one is asked; null: the learner asked
    std::string_view level;  ///< of the learner's English: "A1"; as long as the conversation
    Mark mark{};
    bool right =
        false;  ///< the meaning, by the simulation's verdict; neither where it was no answer yet
    Feedback feedback{};

    // What may be told of it.
    int rung = 0;              ///< of help (help.h), where it was not understood; 1: none yet
    bool leaves_open = false;  ///< it is true, and no answer yet
    bool has_more = false;  ///< behind a right answer something isn't good English, or wasn't read
    std::string
        joined{};  ///< the answer and what is behind it, both right, in one sentence; empty where that isn't proven
    CheckedText checked{};           ///< of what fits no answer, its places in all that was said
    std::optional<Mark> accepted{};  ///< the answer whose repetition this ends
    std::string told{};  ///< to be said instead: what the lesson knows of what was asked
};

/// The first error whose right words can be told without their sentence; null where there is none.
[[nodiscard]] const FreeError* find_alone(const std::vector<FreeError>& errors);

}  // namespace fulcrum::dialogue
