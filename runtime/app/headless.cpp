#include "runtime/app/headless.h"

#include "haptics/base/clock.h"
#include "runtime/app/installation.h"
#include "runtime/app/interrupt.h"
#include "runtime/app/live_loops.h"
#include "runtime/app/run_told.h"
#include "runtime/app/stop_signal.h"
#include "runtime/lua/process/turn_taking.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <thread>
#include <vector>

namespace fulcrum::runtime {
namespace {

constexpr double kLeastMinutes = 1.0;

// The virtual clock: time is a count of haptic ticks, so that nothing drifts and nothing depends on the machine.
class VirtualClock {
  public:
    VirtualClock(LessonRun& run, const HeadlessSettings& settings)
        : run_(run),
          stages_(settings.clock),
          desk_(settings.desk),
          spoiler_(settings.spoiler),
          deadlines_(settings.deadlines),
          felt_(settings.felt),
          tape_(settings.tape),
          again_after_s_(settings.again_after_s),
          rate_hz_(run.plan().haptic.rate_hz),
          frame_rate_hz_(run.plan().haptic.lesson_rate_hz) {
        for (const EffectLoop& loop : run_.effects().loops()) {
            rounds_a_step_.push_back(std::max(std::lround(rate_hz_ / loop.rate_hz), 1L));
        }
        if (deadlines_ != nullptr) {
            DeadlinePeriods periods{1.0 / rate_hz_, 1.0 / frame_rate_hz_, {}};
            for (const long rounds : rounds_a_step_) {
                periods.effects_s.push_back(static_cast<double>(rounds) / rate_hz_);
            }
            deadlines_->begin(std::move(periods));
        }
    }

    [[nodiscard]] double now_s() const { return static_cast<double>(tick_) / rate_hz_ + jumped_s_; }
    [[nodiscard]] bool frame_is_due() const {
        return now_s() * frame_rate_hz_ >= static_cast<double>(frame_) - 1e-9 &&
               (spoiler_ == nullptr || spoiler_->lesson_runs(now_s()));
    }
    // Frames that were not played in their time are left out.
    void count_frame() {
        frame_ = std::max(frame_ + 1, static_cast<long>(now_s() * frame_rate_hz_));
    }

    void tick() {
        const double before_s = jumped_s_;
        const bool effects_run = spoil();
        step_hands();
        find_contact();
        for (std::size_t i = 0; effects_run && i < rounds_a_step_.size(); ++i) {
            if (is_due(i)) {
                step_effect(run_.effects().loops()[i]);
            }
        }
        if (tape_ != nullptr) {
            tape_->keep_round(loops_of(run_.hands()));
        }
        if (deadlines_ != nullptr) {
            watch_deadlines(jumped_s_ - before_s, effects_run);
        }
        if (const SpoiledCounts* const arm = run_.hand().spoiled_counts();
            felt_ != nullptr && arm != nullptr) {
            felt_->hands_stepped(run_.haptic_loop().state(), arm->force_N,
                                 arm->may_feel && (spoiler_ == nullptr || spoiler_->may_feel()),
                                 run_.hand().sees_thing());
            felt_->world_stepped(run_.effects().world_effort());
        }
        ++tick_;
    }

    Expected<FrameReport> exchange_frame() {
        if (deadlines_ != nullptr) {
            deadlines_->passed_frame(now_s(), quiet_around_s());
        }
        FrameInput input;
        input.time_s = now_s();
        if (is_played_again()) {
            input.keys.emplace_back("space");
        }
        if (desk_ != nullptr) {
            auto done = desk_->step(now_s(), 1.0 / frame_rate_hz_);
            if (!done) {
                return tl::unexpected(done.error());
            }
            input = std::move(*done);
        }
        if (stages_ != nullptr) {
            stages_->begin();
        }
        auto report = run_.exchange_frame(input);
        if (desk_ != nullptr && report) {
            desk_->look_again();
        }
        if (stages_ != nullptr) {
            stages_->passed_lesson();
        }
        return report;
    }

  private:
    // What breaks in this tick; whether the world has its round.
    bool spoil() {
        if (spoiler_ == nullptr) {
            return true;
        }
        const SpoiledCounts* const arm = run_.hand().spoiled_counts();
        jumped_s_ += spoiler_->step(now_s(), arm != nullptr ? arm->force_N : 0.0);
        if (spoiler_->kills_lesson(now_s()) && run_.process().pid() > 0) {
            (void)::kill(run_.process().pid(), SIGKILL);
        }
        return spoiler_->world_runs(now_s());
    }
    // Who has seen the end wants it again.
    bool is_played_again() {
        const bool is_over = again_after_s_ > 0.0 && run_.session().result().finished;
        ended_s_ = !is_over ? -1.0 : ended_s_ < 0.0 ? now_s() : ended_s_;
        if (!is_over || now_s() - ended_s_ < again_after_s_) {
            return false;
        }
        ended_s_ = -1.0;
        return true;
    }
    [[nodiscard]] double quiet_around_s() const {
        return spoiler_ != nullptr ? spoiler_->quiet_s(now_s()) : now_s();
    }
    void watch_deadlines(double jumped_s, bool effects_run) {
        const SpoiledCounts* const arm = run_.hand().spoiled_counts();
        const double around_s = quiet_around_s();
        deadlines_->hands_stepped(now_s(), jumped_s, run_.haptic_loop().state(),
                                  arm != nullptr ? std::min(arm->quiet_s, around_s) : around_s);
        for (std::size_t i = 0; effects_run && i < rounds_a_step_.size(); ++i) {
            if (is_due(i)) {
                deadlines_->passed_effect(i, now_s(), around_s);
            }
        }
    }
    // Of a plan for a live run, where a thread would do it: by turns, a round a step.
    void find_contact() {
        if (BesideTask* const beside = run_.haptic_loop().beside()) {
            (void)beside->run_once();
        }
    }
    [[nodiscard]] bool is_due(std::size_t effect) const {
        return tick_ % rounds_a_step_[effect] == 0;
    }
    void step_hands() {
        if (stages_ == nullptr) {
            return run_.rounds().task().step(now_s());
        }
        stages_->begin();
        run_.rounds().step(now_s(), *stages_);
        stages_->compare(run_.haptic_loop().state(), run_.hand().true_velocity_W());
    }
    void step_effect(const EffectLoop& loop) {
        if (stages_ == nullptr) {
            return loop.task->step(now_s());
        }
        stages_->begin();
        loop.task->step(now_s());
        stages_->passed_effect(loop.name, run_.effects().world_effort());
    }

    LessonRun& run_;
    StageClock* stages_;
    QuietDesk* desk_;
    RunSpoiler* spoiler_;
    DeadlineWatch* deadlines_;
    FeltWatch* felt_;
    RunTape* tape_;
    double again_after_s_;
    double ended_s_ = -1.0;
    double jumped_s_ = 0.0;
    double rate_hz_;
    double frame_rate_hz_;
    // By effect; what is faster than the hands has its round in each of theirs.
    std::vector<long> rounds_a_step_;
    long tick_ = 0;
    long frame_ = 0;
};

// The force fades before anything is said, and the record shows it to its end.
void fade_out(LessonRun& run, VirtualClock& clock, const std::string& sentence) {
    run.fail_softly(sentence);
    for (const double until_s = clock.now_s() + run.fade_shown_s(); clock.now_s() < until_s;) {
        clock.tick();
    }
}

// What a frame gave to show: what was said, the lesson's lines, and a picture on the way.
void show(const HeadlessSettings& settings, const FrameReport& report, double now_s) {
    if (settings.talk != nullptr) {
        settings.talk->insert(settings.talk->end(), report.said.begin(), report.said.end());
    }
    if (settings.shows_talk) {
        print_lines(report.said);
    }
    if (settings.shows_prints) {
        print_lines(report.printed);
    }
    if (settings.after_frame) {
        settings.after_frame(now_s);
    }
}

bool asks_in_vain(const SessionHud& hud, double now_s, double patience_s) {
    return hud.question_open && now_s - hud.question_asked_at_s > patience_s;
}

// What both ways of playing decide after a frame; true when the run is over.
bool conclude_frame(LessonRun& run, const HeadlessSettings& settings, const FrameReport& report,
                    double now_s, double& end_s, HeadlessOutcome& outcome) {
    show(settings, report, now_s);
    const LessonSession& session = run.session();
    if (session.result().finished && !outcome.finished) {
        outcome.finished = true;
        end_s = std::min(end_s, now_s + settings.afterglow_s);
    }
    outcome.nobody_answered = asks_in_vain(session.hud(), now_s, settings.nobody_answers_s);
    return outcome.nobody_answered;
}

void sleep_s(double seconds) {
    if (seconds > 0.0) {
        std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
    }
}

}  // namespace

std::string trouble_of(const LessonRun& run, const HeadlessOutcome& outcome, bool takes_say) {
    constexpr const char* kSayFile = "give --say a file with one answer a line";
    if (outcome.nobody_answered && run.pupil().say_line() > 0) {
        const std::size_t n = run.description().tests.front().say.size();
        return to_sentence({"the lesson asked, and say of L:test has no answer left (" +
                                std::to_string(n) + " in all)",
                            "lesson.lua:" + std::to_string(run.pupil().say_line()),
                            std::string("add answers to it") +
                                (takes_say ? std::string(", or ") + kSayFile : std::string())});
    }
    if (outcome.nobody_answered && run.pupil().n_given_lines() > 0 &&
        run.pupil().simulated()->left().empty()) {
        return "The lesson asked, and all " + std::to_string(run.pupil().n_given_lines()) +
               " lines of the file are said; write more of them into it.";
    }
    if (outcome.nobody_answered) {
        return std::string("The lesson asked and nobody answered; ") + kSayFile + '.';
    }
    if (outcome.never_ended) {
        return "The lesson had not finished after " +
               std::to_string(std::lround(outcome.simulated_s / 60.0)) +
               " minutes of play; it may wait for something that never happens, or give --seconds.";
    }
    return {};
}

std::string unsaid_of(const LessonRun& run, const HeadlessOutcome& outcome) {
    if (run.pupil().n_given_lines() == 0 || run.pupil().simulated()->left().empty()) {
        return {};
    }
    const auto& left = run.pupil().simulated()->left();
    const std::string n = std::to_string(left.size());
    return (left.size() == 1 ? "One line of the file was not said, \""
                             : n + " lines of the file were not said, from \"") +
           left.front() + (left.size() == 1 ? "\": " : "\" on: ") +
           (outcome.finished          ? "the lesson was over before."
            : outcome.nobody_answered ? "the lesson waited for something else."
                                      : "the run ended before.");
}

Expected<HeadlessOutcome> run_headless(LessonRun& run, const HeadlessSettings& settings) {
    HeadlessOutcome outcome;
    VirtualClock clock(run, settings);
    TurnTaking turns(run.process().pid());
    const double began_s = monotonic_now_s();
    const double longest_s =
        60.0 * std::max(run.description().minutes, kLeastMinutes) * settings.most_lengths;
    double end_s = settings.end_s.value_or(longest_s);
    if (settings.shows_prints) {
        print_lines(run.process().prints_while_loading());
    }
    if (settings.tape != nullptr) {
        run.listen_to_lesson(
            [tape = settings.tape](const SessionOutput& output) { tape->keep_frame(output); });
    }

    while (clock.now_s() < end_s && !interrupted()) {
        if (clock.frame_is_due()) {
            const auto report = clock.exchange_frame();
            if (!report) {
                fade_out(run, clock, to_sentence(report.error()));
                return tl::unexpected(report.error());
            }
            clock.count_frame();
            turns.turn();
            if (conclude_frame(run, settings, *report, clock.now_s(), end_s, outcome)) {
                break;
            }
        }
        clock.tick();
    }
    run.listen_to_lesson({});
    outcome.interrupted = interrupted();
    outcome.never_ended = !outcome.finished && !settings.end_s && clock.now_s() >= longest_s;
    run.rounds().task().silence(clock.now_s());
    outcome.simulated_s = clock.now_s();
    outcome.wall_s = monotonic_now_s() - began_s;
    return outcome;
}

Expected<HeadlessOutcome> run_in_real_time(LessonRun& run, const HeadlessSettings& settings) {
    HeadlessOutcome outcome;
    const double longest_s =
        60.0 * std::max(run.description().minutes, kLeastMinutes) * settings.most_lengths;
    double end_s = settings.end_s.value_or(longest_s);
    if (settings.shows_prints) {
        print_lines(run.process().prints_while_loading());
    }
    set_stop_target(&run.channels().emergency_stop);
    LiveLoops loops;
    const double began_s = monotonic_now_s();
    if (auto started = loops.start(run, began_s); !started) {
        return tl::unexpected(started.error());
    }
    // The force fades before the loops end, however it ends.
    const auto fade = [&] {
        run.end_softly();
        sleep_s(run.fade_shown_s());
        loops.stop();
        set_stop_target(nullptr);
    };
    double now_s = 0.0;
    for (long frame = 0; now_s < end_s && !interrupted(); ++frame) {
        sleep_s(static_cast<double>(frame) / run.plan().haptic.lesson_rate_hz - now_s);
        now_s = monotonic_now_s() - began_s;
        FrameInput input;
        input.time_s = now_s;
        const auto report = run.exchange_frame(input);
        if (const std::string notice = take_device_notice(run.hands()); !notice.empty()) {
            say(notice);
        }
        if (!report) {
            run.fail_softly(to_sentence(report.error()));
            fade();
            return tl::unexpected(report.error());
        }
        if (conclude_frame(run, settings, *report, now_s, end_s, outcome)) {
            break;
        }
    }
    fade();
    outcome.interrupted = interrupted();
    outcome.never_ended = !outcome.finished && !settings.end_s && now_s >= longest_s;
    outcome.simulated_s = now_s;
    outcome.pace = loops.describe_pace();
    outcome.wall_s = monotonic_now_s() - began_s;
    return outcome;
}

}  // namespace fulcrum::runtime
