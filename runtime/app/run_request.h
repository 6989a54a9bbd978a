// What is to be played, how and by whom.
#pragma once

#include "haptics/record/record.h"
#include "runtime/app/hand_choice.h"
#include "runtime/app/options.h"
#include "runtime/app/places.h"
#include "runtime/app/played_by.h"
#include "runtime/lesson/hand_fit.h"
#include "runtime/lesson/simulated_pupil.h"
#include "runtime/scene/lesson_messages.h"
#include "runtime/scene/plan.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace fulcrum::runtime {

/// The first hand's choice is the request's own.
struct RunRequest : HandChoice {
    std::filesystem::path folder;  ///< of the lesson
    PlanOptions plan{};
    PlayedBy by = PlayedBy::arm;                     ///< at a desk the hand is a mouse
    std::vector<HandChoice> more_hands;              ///< those beside it that were asked for
    HandsThere hands_there = HandsThere::simulated;  ///< for the hands that nobody chose for
    std::vector<std::string> say;  ///< answers of a simulated pupil; empty: somebody types
    std::optional<LearnerRates> learner_rates;  ///< a simulated learner answers instead
    double thinking_s = kThinking_s;            ///< how long before each answer
    /// Where the lesson has no test of its own, or its test answers nothing, this one answers.
    std::optional<LearnerRates> learner_without_test;
    bool own_test = false;  ///< use the hand and the answers of the lesson's first L:test
    FirstUseTrial first_use = FirstUseTrial::once;
    HandFit fit{};                   ///< how the hand's device is set, as far as somebody says it
    std::vector<HandFit> more_fits;  ///< those beside it; as many as somebody says something of
    double yield = 1.0;              ///< of a pointer (make_yielding)
    std::string record_file;         ///< empty: nothing is recorded
    std::vector<KnownLesson> lessons{};  ///< for a room; empty: all that are here, when it begins
    std::string learner;                 ///< nickname; empty: a guest
    std::string guest = "guest";         ///< what a guest is kept as
    /// What whoever plays is kept as.
    [[nodiscard]] const std::string& player() const { return learner.empty() ? guest : learner; }
    std::uint64_t seed = 1;  ///< of the lesson's math.random
    bool seed_is_given = false;
    std::shared_ptr<const Record> replayed;  ///< replay: the record, once it is read
    std::optional<dialogue::FeedbackLadder>
        feedback{};  ///< instead of what the lesson says; empty: as it says; none: what is kept
    /// The learner's own, or that of the run that is repeated; empty: as the lesson says.
    dialogue::FeedbackLadder kept_feedback{};
};

/// Whether any of its hands keeps its own time.
[[nodiscard]] bool keeps_time(const RunRequest& request) noexcept;
/// Settles the hands for this lesson, as settle_hands does; the plan counts them.
[[nodiscard]] Expected<std::vector<std::string>> settle_hands(const LessonDescription& lesson,
                                                              RunRequest& request);

/// A record's fact: how far the hand went in the scene, times the lesson's own scale.
inline constexpr const char* kScaleFact = "option.scale";
/// A record's fact: the ladder of feedback, or that it was the lesson's.
inline constexpr const char* kFeedbackFact = "option.feedback";
/// A record's fact: who talked back to the learner, where that was another than the shipped partner.
inline constexpr const char* kPartnerFact = "option.dialogue";
/// A record's facts: the device for which walls were made stable.
inline constexpr const char* kHolderFact = "option.walls for";
inline constexpr const char* kHolderMassFact = "option.walls kg";
inline constexpr const char* kHolderDampingFact = "option.walls Ns/m";
inline constexpr const char* kHolderForceFact = "option.walls N";
inline constexpr const char* kHolderLinkFact = "option.walls link s";
/// What stands before such a fact of a hand's device, counted from 0; of the first one nothing does.
[[nodiscard]] std::string holder_prefix(std::size_t hand);
/// Reads the record that is to be repeated, and takes over what belongs to its run and was not asked for otherwise: seed, day, the hand's scale,
/// the ladder of feedback, what another partner said to the learner, and for which device walls were made stable.
/// Other requests stay as they are.
[[nodiscard]] Expected<RunRequest> with_record(RunRequest request);

/// A settled request as if this hand, counted from 0, were the first, and that one another: with what was said of how its arm stands.
[[nodiscard]] RunRequest of_hand(const RunRequest& request, std::size_t hand);
/// Whether the record of such a request tells what was typed, said and pressed, so that nobody else need answer.
[[nodiscard]] bool repeats_input(const RunRequest& request) noexcept;
/// Lets the lesson's simulated hand play by this.
void play_by(PlayedBy by, RunRequest& request);

/// Of a simulated learner who errs in so many parts of the answers: half in form, a third in meaning, else unclear.
[[nodiscard]] LearnerRates rates_of(double errors);

/// What the command line asks for: the lesson, whose hand and whose answers. Refuses what is not there, in one sentence.
[[nodiscard]] Expected<RunRequest> make_request(const Places& places, const Options& options,
                                                bool in_window);

}  // namespace fulcrum::runtime
