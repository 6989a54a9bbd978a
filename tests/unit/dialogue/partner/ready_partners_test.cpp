#include "dialogue/partner/ready_partners.h"

#include "tests/support/english_words.h"
#include "tests/unit/dialogue/questions.h"
#include "tests/unit/dialogue/rig.h"
#include "tests/unit/dialogue/talk.h"

using namespace fulcrum::dialogue;

namespace {

/// All that there is to say at this time.
std::vector<Reply> poll_all(Partner& partner, double time_s = 0.0) {
    std::vector<Reply> replies;
    while (auto reply = partner.poll(time_s)) {
        replies.push_back(std::move(*reply));
    }
    return replies;
}

}  // namespace

TEST_CASE("partners: the shipped one says the program's words, once to each turn, in order") {
    ShippedPartner partner;
    CHECK_FALSE(partner.poll(0.0));
    partner.take({}, {"one", {"a"}});
    partner.take({}, {"two", {}});
    const auto replies = poll_all(partner);
    REQUIRE(replies.size() == 2);
    CHECK(replies[0].text == "one");
    CHECK(replies[0].keys == std::vector<std::string>{"a"});
    CHECK(replies[1].text == "two");
    CHECK_FALSE(replies[0].is_partners);
    CHECK(partner.take_trouble().empty());
}

TEST_CASE("partners: the one that says nothing answers each turn all the same") {
    NullPartner partner;
    partner.take({}, {"one", {}});
    partner.take({}, {"two", {}});
    const auto replies = poll_all(partner);
    REQUIRE(replies.size() == 2);
    CHECK((replies[0].text.empty() && replies[1].text.empty()));
}

TEST_CASE("partners: a script speaks at its turns and not before its time, else the program does") {
    ScriptedPartner partner({{2, {"scripted", 5.0}}});
    for (const char* own : {"one", "two", "three"}) {
        partner.take({}, {own, {}});
    }
    CHECK(poll_all(partner, 4.9).size() == 1);
    const auto late = poll_all(partner, 5.0);
    REQUIRE(late.size() == 2);
    CHECK(late[0].text == "scripted");
    CHECK(late[0].is_partners);
    CHECK(late[1].text == "three");
    CHECK_FALSE(late[1].is_partners);
}

TEST_CASE("own words: what the lesson knows is said instead, and out of turn there is nothing") {
    const Catalogue words = english_words();
    OwnWords own(words);
    CHECK(own.say({}).text.empty());
    Turn asked;
    asked.told = "It is an apple.";
    CHECK(own.say(asked).text == "It is an apple.");
    Conversation talk(words);
    talk.ask(heaviest());
    Turn turn = talk.respond(talk.hear("a watermelon is the heaviest"), true);
    CHECK(own.say(turn).keys == std::vector<std::string>{"feedback.praise.1"});
    turn.told = "Nobody knows that.";
    CHECK(own.say(turn).text == "Nobody knows that.");
}
