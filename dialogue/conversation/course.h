// The course of a question: one table of what may happen in each state, what comes of it, and what is done then.
//
//   event      idle, left, done   asked           heard           replaying       invited           heard again
//   ask        asked     listen   asked   listen  asked   listen  asked   listen  asked   conclude  asked     conclude
//   resume     asked     listen   asked   listen  asked   listen  asked   resume  asked   listen    asked     listen
//   hear       -                  heard   mark    -               -               again   mark      -
//   unclear    -                  -               asked   listen  -               -                 invited   listen
//   wrong      -                  -               replaying tell  -               -                 done      tell
//   give_up    -                  -               left    tell    -               -                 done      tell
//   invite     -                  -               invited listen  -               -                 done      tell
//   right      -                  -               done    tell    -               -                 done      tell
//   withdraw   -                  -               asked           -               -                 invited
//   time       -                  -               -               -               done    tell      -
//   close      idle               idle            idle            idle            idle              idle
//
// idle, left, replaying and done are those in which a learner may ask (runtime/lesson/knowledge.h); in the others that is put off and counts for
// nothing, unless the question is answered by asking: then what is asked is heard, and right.
// "-": it is late or out of turn, and nothing comes of it. Only the two states that wait for a verdict shut the learner's mouth.
// What was right stays it: from invited and heard_again no way leads to replaying or left, so nobody is held for form alone.
//
// Thread: any; values.  Cost: none.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>

namespace fulcrum::dialogue {

/// Where a question stands, and who is waited for.
enum class CourseState : std::uint8_t {
    idle,         ///< nobody: nothing was asked, or the lesson asks nothing any more
    asked,        ///< the learner
    heard,        ///< the verdict on the meaning
    replaying,    ///< the lesson: what the question is about is felt again
    invited,      ///< the learner, for a while: the meaning was right, and may be said once more
    heard_again,  ///< the verdict on that
    left,         ///< nobody: left for now, after many tries
    done          ///< nobody: the meaning was right
};
inline constexpr std::size_t kCourseStates = 8;

/// What happens to a question.
enum class CourseEvent : std::uint8_t {
    ask,       ///< the lesson asks; what was asked before is over
    resume,    ///< the lesson asks the same question as before
    hear,      ///< the learner speaks
    unclear,   ///< of the verdicts: nothing that can be marked; it is to be said again
    wrong,     ///< another meaning
    give_up,   ///< likewise, too often
    invite,    ///< the meaning is right, and the form may be said once more
    right,     ///< the meaning is right
    withdraw,  ///< the verdict has not come, and never will
    time,      ///< the learner was waited for long enough
    close      ///< nothing is asked any more
};
inline constexpr std::size_t kCourseEvents = 11;

/// What is to be done, behind the step into its state.
enum class CourseAction : std::uint8_t {
    none,
    listen,    ///< the learner is waited for anew
    resume,    ///< likewise, and what was counted goes on
    mark,      ///< what was said is marked, and its meaning judged
    tell,      ///< the lesson is told what came of the question
    conclude,  ///< likewise of the question before; then the learner is waited for
};

struct CourseStep {
    CourseState next = CourseState::idle;
    CourseAction action = CourseAction::none;
    bool is_taken = false;  ///< false: it was out of turn
};

namespace detail {

using CourseTable = std::array<std::array<CourseStep, kCourseEvents>, kCourseStates>;

consteval CourseTable make_course_table() {
    using S = CourseState;
    using E = CourseEvent;
    using A = CourseAction;
    CourseTable table{};
    const auto go = [&](S from, E event, S to, A action) {
        table[static_cast<std::size_t>(from)][static_cast<std::size_t>(event)] = {to, action, true};
    };
    for (std::size_t i = 0; i < kCourseStates; ++i) {
        const auto from = static_cast<S>(i);
        table[i].fill({from, A::none, false});
        const bool was_right = from == S::invited || from == S::heard_again;
        go(from, E::ask, S::asked, was_right ? A::conclude : A::listen);
        go(from, E::resume, S::asked, from == S::replaying ? A::resume : A::listen);
        go(from, E::close, S::idle, A::none);
    }
    go(S::asked, E::hear, S::heard, A::mark);
    go(S::heard, E::unclear, S::asked, A::listen);
    go(S::heard, E::wrong, S::replaying, A::tell);
    go(S::heard, E::give_up, S::left, A::tell);
    go(S::heard, E::invite, S::invited, A::listen);
    go(S::heard, E::right, S::done, A::tell);
    go(S::heard, E::withdraw, S::asked, A::none);
    go(S::invited, E::hear, S::heard_again, A::mark);
    go(S::invited, E::time, S::done, A::tell);
    go(S::heard_again, E::unclear, S::invited, A::listen);
    for (const E verdict : {E::wrong, E::give_up, E::invite, E::right}) {
        go(S::heard_again, verdict, S::done, A::tell);
    }
    go(S::heard_again, E::withdraw, S::invited, A::none);
    return table;
}

inline constexpr CourseTable kCourse = make_course_table();

}  // namespace detail

/// What comes of an event in a state.
[[nodiscard]] constexpr CourseStep step(CourseState from, CourseEvent event) noexcept {
    return detail::kCourse[static_cast<std::size_t>(from)][static_cast<std::size_t>(event)];
}

/// The learner may speak.
[[nodiscard]] constexpr bool listens(CourseState state) noexcept {
    return state == CourseState::asked || state == CourseState::invited;
}
/// A verdict is waited for.
[[nodiscard]] constexpr bool is_judging(CourseState state) noexcept {
    return state == CourseState::heard || state == CourseState::heard_again;
}
/// The answer was right already, and may be said once more.
[[nodiscard]] constexpr bool is_invited(CourseState state) noexcept {
    return state == CourseState::invited || state == CourseState::heard_again;
}

}  // namespace fulcrum::dialogue
