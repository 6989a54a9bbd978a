#include "dialogue/conversation/course.h"

#include "dialogue/conversation/conversation.h"
#include "tests/support/english_words.h"
#include "tests/unit/dialogue/questions.h"
#include "tests/unit/dialogue/rig.h"
#include "tests/unit/dialogue/talk.h"

#include <rapidcheck.h>

using namespace fulcrum::dialogue;

namespace {

constexpr std::array kStates{"idle",    "asked",       "heard", "replaying",
                             "invited", "heard_again", "left",  "done"};
constexpr std::array kEvents{"ask",    "resume", "hear",     "unclear", "wrong", "give_up",
                             "invite", "right",  "withdraw", "time",    "close"};
constexpr std::array kActions{"", " listen", " resume", " mark", " tell", " conclude"};

std::string told(const CourseStep& came) {
    return !came.is_taken ? "-"
                          : kStates.at(static_cast<std::size_t>(came.next)) +
                                std::string(kActions.at(static_cast<std::size_t>(came.action)));
}

bool is_over(CourseState state) {
    return state == CourseState::idle || state == CourseState::left || state == CourseState::done;
}

}  // namespace

TEST_CASE("course: each state goes with each event where the question's course says") {
    const std::map<std::string, std::vector<std::string>> rows{
        {"ask",
         {"asked listen", "asked listen", "asked listen", "asked listen", "asked conclude",
          "asked conclude", "asked listen", "asked listen"}},
        {"resume",
         {"asked listen", "asked listen", "asked listen", "asked resume", "asked listen",
          "asked listen", "asked listen", "asked listen"}},
        {"hear", {"-", "heard mark", "-", "-", "heard_again mark", "-", "-", "-"}},
        {"unclear", {"-", "-", "asked listen", "-", "-", "invited listen", "-", "-"}},
        {"wrong", {"-", "-", "replaying tell", "-", "-", "done tell", "-", "-"}},
        {"give_up", {"-", "-", "left tell", "-", "-", "done tell", "-", "-"}},
        {"invite", {"-", "-", "invited listen", "-", "-", "done tell", "-", "-"}},
        {"right", {"-", "-", "done tell", "-", "-", "done tell", "-", "-"}},
        {"withdraw", {"-", "-", "asked", "-", "-", "invited", "-", "-"}},
        {"time", {"-", "-", "-", "-", "done tell", "-", "-", "-"}},
        {"close", {"idle", "idle", "idle", "idle", "idle", "idle", "idle", "idle"}}};
    REQUIRE(rows.size() == kCourseEvents);
    for (std::size_t event = 0; event < kCourseEvents; ++event) {
        for (std::size_t state = 0; state < kCourseStates; ++state) {
            CAPTURE(kEvents[event], kStates[state]);
            const CourseStep came =
                step(static_cast<CourseState>(state), static_cast<CourseEvent>(event));
            CHECK(told(came) == rows.at(kEvents[event]).at(state));
            if (!came.is_taken) {
                CHECK(came.next == static_cast<CourseState>(state));
            }
        }
    }
}

TEST_CASE("course: wherever chance leads, what is over asks nothing, and what was right stays it") {
    CHECK(rc::check([](const std::vector<unsigned>& events) {
        CourseState state = CourseState::idle;
        bool was_right = false;
        for (const unsigned any : events) {
            const auto event = static_cast<CourseEvent>(any % kCourseEvents);
            const bool asks = event == CourseEvent::ask || event == CourseEvent::resume;
            const CourseStep came = step(state, event);
            was_right = !asks && (was_right || came.next == CourseState::invited);
            RC_ASSERT(!is_over(state) || asks || is_over(came.next));
            RC_ASSERT(!was_right ||
                      (came.next != CourseState::left && came.next != CourseState::replaying &&
                       came.next != CourseState::asked));
            // Nobody is left without a way to go on: who is not waited for is judged, and a verdict can be withdrawn.
            RC_ASSERT(!is_judging(came.next) ||
                      listens(step(came.next, CourseEvent::withdraw).next));
            state = came.next;
        }
    }));
}

TEST_CASE("course: whatever is answered, a question ends, and never for its form alone") {
    static const Catalogue words = english_words();
    static const ConversationSettings settings;
    // Each wrong meaning and each that fits nothing but the last is asked again; one that is right may be said once more.
    const int most = settings.tries + settings.unheard_tries;
    CHECK(rc::check([&](const std::vector<std::pair<unsigned, bool>>& chosen) {
        const std::vector<std::string_view> said = {"an apple is the most heavy", "what?",
                                                    "an apple is the heaviest", "the apple", ""};
        Talk talk(words, settings);
        talk.ask(heaviest());
        int answers = 0;
        bool was_right = false;
        for (const auto& [choice, right] : chosen) {
            if (talk.state() == CourseState::replaying) {
                RC_ASSERT(!was_right);
                talk.ask_again();
            }
            if (!listens(talk.state())) {
                break;
            }
            const Mark mark = talk.hear(said[choice % said.size()]);
            was_right = was_right || (mark.understood && right);
            const Said feedback = talk.respond(mark, right);
            RC_ASSERT(feedback.came.next == talk.state());
            RC_ASSERT(++answers <= most);
            RC_ASSERT(!was_right || is_invited(talk.state()) || talk.state() == CourseState::done);
        }
        RC_ASSERT(chosen.size() < static_cast<std::size_t>(most) || is_over(talk.state()));
        // Nothing that is said to what is over opens it.
        if (is_over(talk.state())) {
            const CourseState over = talk.state();
            RC_ASSERT(talk.respond(talk.hear("an apple is the heaviest"), true).text.empty());
            RC_ASSERT(talk.state() == over);
        }
    }));
}
