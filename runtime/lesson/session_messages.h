// What goes in and out of a session in one frame, what is seen of it, and how it went.
#pragma once

#include "haptics/handover/messages.h"
#include "runtime/lesson/effect_messages.h"
#include "runtime/scene/lesson_messages.h"
#include "runtime/scene/view.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace fulcrum::runtime {

/// What happened since the last frame.
struct SessionInput : EffectFrames {
    double clock_s = 0.0;  ///< the loops'
    double time_s = 0.0;   ///< the lesson's own, which stands still in a pause
    double dt_s = 0.0;
    HapticState hand{};
    std::vector<HapticState> more_hands{};  ///< those beside it that are there
    double wheel = 0.0;  ///< notches since the last frame, away from the user is +
    std::vector<WorldEvent> world_events;
    std::vector<std::string> keys;
    std::optional<std::string>
        heard;  ///< the learner's words, typed or scripted: for the recogniser
};

/// What is to be done before the next frame.
struct SessionOutput : EffectOrders {
    ForceCommand force{};
    std::vector<std::string> sounds;
    bool has_hand_target = false;  ///< the simulated hand's Lua gave one
    Pose hand_target_W{};
    std::uint32_t hand_buttons = 0;
    std::string hand_key;  ///< that its other hand presses, once; none while a question is open
    std::vector<HandAim> more_aims;  ///< of simulated hands beside it
    std::vector<std::string> printed;
    std::vector<std::string> spoken;  ///< what is to be said aloud
    std::vector<std::string> said;    ///< what was shown, asked and answered, see transcript.h
    std::vector<std::string> notes;   ///< for the record, see talk.h
};

/// What a learner sees of the lesson, apart from the bodies.
struct SessionHud {
    std::string caption;   ///< the one instruction
    std::string feedback;  ///< the last answer's answer, *emphasised* where it teaches
    bool question_open = false;
    double question_asked_at_s = 0.0;
    int score = 0;
    int level = 0;
    std::string level_title;
    int stars = -1;        ///< 0 to 3 once the lesson is over
    bool knows = false;    ///< the lesson answers what is asked
    bool may_ask = false;  ///< likewise, and no question is open
    bool invited = false;  ///< the answer was right; it may be said once more, and need not be
    std::vector<bool> covered{};     ///< by body: under a cloth
    std::vector<double> marked_N{};  ///< by body: what is shown to have been felt of it; 0: nothing
    std::vector<BodyLight> lights{};  ///< by body
    KiteSeen kite{};
    std::string said{};    ///< what `feedback` answers; empty: nothing was said
    std::string better{};  ///< the same in good English, with what is other *emphasised*; or empty
    std::string told{};    ///< the same as `feedback` has it
    ViewMood mood = ViewMood::calm;  ///< with which `feedback` is said
    /// Where something was caught or answered rightly, and when, on the lesson's clock; not long ago.
    struct Burst {
        Vector3 at_W{Vector3::Zero()};
        double at_s = 0.0;
    };
    std::vector<Burst> bursts{};
    std::optional<Vector3> shown_hand_W{};  ///< where the program's own hand points
};

/// How one play went; what `fulcrum test` compares with what the lesson expects.
/// What a lesson may ask for before it begins.
struct KnownAtFirst {
    std::vector<PastAnswers> past{};     ///< of its learner, where it wants that
    std::vector<KnownLesson> lessons{};  ///< of a room
};

struct SessionResult {
    bool finished = false;
    int stars = 0;
    int score = 0;
    int level = 0;
    int attempts = 0;
    int caught = 0;
    int form_errors = 0;
    int questions = 0;                       ///< that were answered, each time it was asked
    int right_at_first = 0;                  ///< of these
    std::vector<std::string> to_practise{};  ///< what belongs where an error of form was, each once
    std::optional<std::string>
        entered{};  ///< of a room: the lesson it was left for; empty: the list of all
};

}  // namespace fulcrum::runtime
