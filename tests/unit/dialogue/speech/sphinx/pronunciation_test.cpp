#include "dialogue/speech/sphinx/pronunciation.h"

#include <catch2/catch.hpp>

#include <map>

using namespace fulcrum::dialogue;

namespace {

std::optional<std::string> look_up(std::string_view word) {
    static const std::map<std::string, std::string, std::less<>> kWords{
        {"good", "G UH D"},      {"make", "M EY K"}, {"break", "B R EY K"},
        {"want", "W AA N T"},    {"man", "M AE N"},  {"box", "B AA K S"},
        {"foot", "F UH T"},      {"big", "B IH G"},  {"hard", "HH AA R D"},
        {"heavy", "HH EH V IY"}, {"play", "P L EY"}, {"heavier", "HH EH V IY ER"}};
    const auto found = kWords.find(word);
    return found == kWords.end() ? std::nullopt : std::optional(found->second);
}

std::string sounds(std::string_view word) {
    return pronounce(word, look_up).value_or("?");
}

}  // namespace

TEST_CASE("pronunciation: the dictionary's comes first") {
    CHECK(sounds("heavier") == "HH EH V IY ER");
    CHECK(sounds("make") == "M EY K");
}

TEST_CASE("pronunciation: what learners make by rule sounds as the rule says") {
    CHECK(sounds("goodest") == "G UH D AH S T");
    CHECK(sounds("gooder") == "G UH D ER");
    CHECK(sounds("maked") == "M EY K T");
    CHECK(sounds("wanted") == "W AA N T IH D");
    CHECK(sounds("played") == "P L EY D");
    CHECK(sounds("mans") == "M AE N Z");
    CHECK(sounds("foots") == "F UH T S");
    CHECK(sounds("boxs") == "B AA K S IH Z");
    CHECK(sounds("boxes") == "B AA K S IH Z");
    CHECK(sounds("man's") == "M AE N Z");
    CHECK(sounds("hardly") == "HH AA R D L IY");
    CHECK(sounds("hardness") == "HH AA R D N AH S");
    // The rules of spelling undone.
    CHECK(sounds("bigger") == "B IH G ER");
    CHECK(sounds("heaviest") == "HH EH V IY AH S T");
    CHECK(sounds("heaviness") == "HH EH V IY N AH S");
}

TEST_CASE("pronunciation: what nobody knows has none") {
    for (const char* word : {"", "s", "ed", "zyzzyva", "xs", "est", "er"}) {
        CHECK(sounds(word) == "?");
    }
}
