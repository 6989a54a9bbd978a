// Plays a lesson under a virtual clock: the same stages as live, in one thread, as fast as they go. The same input gives
// the same bytes.
//
//   for each tick of the haptic rate:  hand -> haptic loop;  when due: world loop;  when due: lesson frame
#pragma once

#include "runtime/app/deadline_watch.h"
#include "runtime/app/felt_watch.h"
#include "runtime/app/lesson_run.h"
#include "runtime/app/run_spoiler.h"
#include "runtime/app/run_tape.h"
#include "runtime/app/simulated_desk.h"
#include "runtime/app/stage_clock.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace fulcrum::runtime {

struct HeadlessSettings {
    std::optional<double> end_s;     ///< end then, finished or not
    double afterglow_s = 1.0;        ///< goes on so long after the lesson has finished
    double nobody_answers_s = 30.0;  ///< a question open for longer than this ends the run
    /// Without `end_s`, a lesson that has not finished after so many times the minutes that it names is ended.
    double most_lengths = 3.0;
    /// Called after each frame with the run's time; for pictures on the way. May be empty.
    std::function<void(double)> after_frame;
    /// Who plays at a desk; null where the simulated hand is an arm.
    QuietDesk* desk = nullptr;
    /// What breaks around the run; null for a plain one, which is the same to the byte.
    RunSpoiler* spoiler = nullptr;
    /// Watches that nobody is late under the virtual clock; null for a plain run, which is the same to the byte.
    DeadlineWatch* deadlines = nullptr;
    /// Likewise for how long a force is felt.
    FeltWatch* felt = nullptr;
    /// A key is pressed so long after the lesson has finished, to play it again; 0 for none.
    double again_after_s = 0.0;
    /// Times every stage; null for a plain run, which is the same to the byte.
    StageClock* clock = nullptr;
    /// Keeps what the loops are told; null for a plain run, which is the same to the byte.
    RunTape* tape = nullptr;
    bool shows_prints = true;  ///< what the lesson prints goes to standard output
    bool shows_talk = false;   ///< so does what is shown, asked, answered, see transcript.h
    std::vector<std::string>* talk = nullptr;  ///< where the same is kept; null: nowhere
};

struct HeadlessOutcome {
    bool finished = false;         ///< the lesson came to its end
    bool nobody_answered = false;  ///< it waited in vain for an answer
    bool never_ended = false;      ///< it went on for much longer than it says
    bool interrupted = false;      ///< somebody broke it off
    double simulated_s = 0.0;
    double wall_s = 0.0;
    std::string pace;  ///< in real time: how well the haptic loop kept it, a sentence
};

/// Why the run did not come to the lesson's end, one sentence; empty when it did or was told when to stop. `takes_say`: the command
/// has an option --say.
[[nodiscard]] std::string trouble_of(const LessonRun& run, const HeadlessOutcome& outcome,
                                     bool takes_say);

/// What somebody gave to be said and the lesson did not come to, one sentence; empty when all was said.
[[nodiscard]] std::string unsaid_of(const LessonRun& run, const HeadlessOutcome& outcome);

/// Plays to the end. An error is the lesson's failure: by then the force has faded and the record tells so.
[[nodiscard]] Expected<HeadlessOutcome> run_headless(LessonRun& run,
                                                     const HeadlessSettings& settings);

/// The same with a real hand: the loops on their threads, the lesson's frames when they are due. `clock` is not used.
[[nodiscard]] Expected<HeadlessOutcome> run_in_real_time(LessonRun& run,
                                                         const HeadlessSettings& settings);

}  // namespace fulcrum::runtime
