// Programs that talk to the learner: as they should, and not.
#include "runtime/lesson/external_partner.h"

#include "haptics/base/clock.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

constexpr const char* kTurn = "n=$(echo \"$line\" | sed 's/.*\"turn\":\\([0-9]*\\).*/\\1/'); ";

/// A program that does this with each line, whose turn is $n.
std::vector<std::string> each_line(const std::string& what) {
    return {"sh", "-c", "while read -r line; do " + std::string(kTurn) + what + "; done"};
}

std::string say(const std::string& text) {
    return "echo \"{\\\"turn\\\":$n,\\\"text\\\":\\\"" + text + "\\\"}\"";
}

std::unique_ptr<ExternalPartner> start(std::vector<std::string> words, double deadline_s = 2.0) {
    return value_of(ExternalPartner::create(
        {.words = std::move(words), .waits = true, .deadline_s = deadline_s}));
}

/// A turn whose own words are these, and what is said to it; a partner's words stand behind "partner: ".
std::string answer(ExternalPartner& partner, const std::string& own = "own") {
    partner.take({}, {own, {}});
    const auto reply = partner.poll(0.0);
    CHECK_FALSE(partner.poll(0.0));
    return !reply ? "nothing yet" : (reply->is_partners ? "partner: " : "") + reply->text;
}

std::vector<std::string> troubles_of(ExternalPartner& partner) {
    std::vector<std::string> told;
    for (std::string one = partner.take_trouble(); !one.empty(); one = partner.take_trouble()) {
        told.push_back(std::move(one));
    }
    return told;
}

std::string missing(const std::string& why) {
    return "What another program was to say is missing: the partner " + why +
           "; the program's own words are said instead.";
}

std::string over(const std::string& why) {
    return "Nobody else talks any more: the partner " + why +
           ", the third time in a row; the program's own words are said.";
}

}  // namespace

TEST_CASE("partner: a program that keeps to the lines says what is said") {
    const auto partner = start(each_line(say("Number $n.")));
    CHECK(answer(*partner) == "partner: Number 1.");
    CHECK(answer(*partner) == "partner: Number 2.");
    CHECK(troubles_of(*partner).empty());
}

TEST_CASE("partner: it is told the turn, what was made of it, and nothing of who speaks") {
    const auto partner =
        start(each_line("echo \"{\\\"turn\\\":$n,\\\"text\\\":\\\"$(echo \"$line\" | "
                        "tr -d '\\\"{}')\\\"}\""));
    dialogue::Question question;
    question.prompt = "Which one?";
    dialogue::Turn turn;
    turn.asked = &question;
    turn.level = "A2";
    turn.mark.said = "egg";
    turn.feedback.kind = dialogue::FeedbackKind::wrong_meaning;
    turn.feedback.attempt = 2;
    turn.feedback.free_errors.push_back({dialogue::ErrorCode::agreement, 0, 0, "", ""});
    turn.right = true;  // is told to nobody
    partner->take(turn, {"Not yet.", {}});
    CHECK(value_of(partner->poll(0.0)).text ==
          "attempt:2,corrected:,errors:[R:VERB:SVA],kind:wrong_meaning,level:A2,ours:Not "
          "yet.,prompt:Which one?,said:egg,turn:1");
    turn.asked = nullptr;
    partner->take(turn, {"An egg.", {}});
    CHECK(value_of(partner->poll(0.0)).text == "asks:egg,level:A2,ours:An egg.,turn:2");
}

TEST_CASE("partner: each failure has its sentence once, and after three in a row it is ended") {
    struct Failure {
        std::string does;
        std::string why;
        double deadline_s = 20.0;  // it answers long before
    };
    const std::string long_text(401, 'a');
    for (const Failure& failure :
         {Failure{":", "has said nothing for 0.2 s", 0.2},
          Failure{"echo nonsense", "says a line that is no {\"turn\": …, \"text\": …}"},
          Failure{say(long_text), "says more than 400 characters"},
          Failure{say("好"), "says what is not in the letters of English"},
          Failure{"n=$((n+7)); " + say("early"), "answers what was not said yet"},
          Failure{"n=$((n-1)); " + say("late"), "has said nothing for 0.2 s", 0.2}}) {
        CAPTURE(failure.does.substr(0, 40));
        const auto partner = start(each_line(failure.does), failure.deadline_s);
        CHECK(answer(*partner) == "own");
        CHECK(troubles_of(*partner) == std::vector{missing(failure.why)});
        CHECK(answer(*partner, "two") == "two");
        CHECK(troubles_of(*partner).empty());
        CHECK(answer(*partner) == "own");
        CHECK(troubles_of(*partner) == std::vector{over(failure.why)});
        const double begun_s = monotonic_now_s();
        CHECK(answer(*partner, "four") == "four");
        CHECK(monotonic_now_s() - begun_s < 0.15);  // nobody is waited for
        CHECK(troubles_of(*partner).empty());
    }
}

TEST_CASE("partner: failures that are not in a row do not end it") {
    const auto partner =
        start(each_line("case $n in *[13579]) echo nonsense;; *) " + say("$n") + ";; esac"));
    for (int turn = 1; turn <= 8; ++turn) {
        CHECK(answer(*partner) == (turn % 2 == 1 ? "own" : "partner: " + std::to_string(turn)));
    }
    CHECK(troubles_of(*partner).size() == 1);
}

TEST_CASE("partner: one that ends is told of at once, and the program's own words go on") {
    const auto partner = start({"sh", "-c", "read -r line; exit 3"});
    CHECK(answer(*partner) == "own");
    CHECK(troubles_of(*partner) ==
          std::vector<std::string>{"Nobody else talks any more: the program sh has ended; the "
                                   "program's own words are said."});
    CHECK(answer(*partner) == "own");
    CHECK(troubles_of(*partner).empty());
    CHECK_FALSE(ExternalPartner::create({.words = {"no_such_program_6"}}));
}

TEST_CASE("partner: a flood does not hold a lesson up, and is not kept") {
    for (const char* flood :
         {"exec yes", "exec yes '{\"turn\":0,\"text\":\"a\"}'", "exec tr '\\0' a </dev/zero"}) {
        CAPTURE(flood);
        const auto partner = start({"sh", "-c", flood}, 0.3);
        const double begun_s = monotonic_now_s();
        for (int turn = 0; turn < 3; ++turn) {
            std::optional<dialogue::Reply> reply;
            partner->take({}, {"own", {}});
            while (!reply && monotonic_now_s() - begun_s < 10.0) {
                reply = partner->poll(0.0);
            }
            CHECK(value_of(reply).text == "own");
        }
        CHECK(monotonic_now_s() - begun_s < 5.0);
        CHECK(troubles_of(*partner).back().starts_with("Nobody else talks any more"));
    }
}

TEST_CASE("partner: a run that waits has its answer at the first look, whatever floods it") {
    const auto partner = value_of(
        ExternalPartner::create({.words = {"sh", "-c", "exec yes '{\"turn\":1,\"text\":\"a\"}'"},
                                 .waits = true,
                                 .deadline_s = 0.3}));
    for (int turn = 1; turn <= 3; ++turn) {
        partner->take({}, {"own", {}});
        CHECK(value_of(partner->poll(0.0)).text == (turn == 1 ? "a" : "own"));
    }
}

TEST_CASE("partner: in a window no poll waits; words come when they do, in the turns' order") {
    const auto partner = value_of(ExternalPartner::create(
        {.words = each_line("[ $n = 1 ] && sleep 1; " + say("$n")), .deadline_s = 20.0}));
    const double begun_s = monotonic_now_s();
    partner->take({}, {"one", {}});
    partner->take({}, {"two", {}});
    CHECK_FALSE(partner->poll(0.0));
    CHECK(monotonic_now_s() - begun_s < 0.8);
    std::vector<std::string> said;
    while (said.size() < 2 && monotonic_now_s() - begun_s < 20.0) {
        if (const auto reply = partner->poll(0.0)) {
            said.push_back(reply->text);
        }
    }
    CHECK(said == std::vector<std::string>{"1", "2"});
}

TEST_CASE("partner: what was passed over gets the own words, and what follows is not lost") {
    const auto partner = start({"sh", "-c",
                                "read -r a; read -r b; "
                                "echo '{\"turn\":2,\"text\":\"second\"}'; read -r c"});
    partner->take({}, {"one", {}});
    partner->take({}, {"two", {}});
    CHECK(value_of(partner->poll(0.0)).text == "one");
    CHECK(value_of(partner->poll(0.0)).text == "second");
    CHECK(troubles_of(*partner) == std::vector{missing("has passed over what was said")});
}

TEST_CASE("partner: nobody is waited for once somebody gives up") {
    bool gives_up = true;
    const auto partner = value_of(ExternalPartner::create({.words = {"sh", "-c", "exec sleep 100"},
                                                           .waits = true,
                                                           .deadline_s = 20.0,
                                                           .gives_up = [&] { return gives_up; }}));
    const double begun_s = monotonic_now_s();
    CHECK(answer(*partner) == "nothing yet");
    CHECK(monotonic_now_s() - begun_s < 1.0);
}
