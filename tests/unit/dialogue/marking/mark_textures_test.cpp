// Adjectives and the passive as learners say them. The sentences are put together here, apart from the library's own
// tables, so that what is right and what is wrong is said twice, by two hands.
#include "dialogue/marking/mark_answer.h"
#include "tests/unit/dialogue/questions.h"
#include "tests/unit/dialogue/told_mark.h"

#include <catch2/catch.hpp>

using namespace fulcrum::dialogue;

namespace {

struct Thing {
    const char *value, *bare, *with_article, *is;
};
// As a person would write them.
constexpr Thing kThings[] = {{"spaceship", "spaceship", "a spaceship", "is"},
                             {"table", "table", "the table", "is"},
                             {"chair", "chair", "this chair", "is"},
                             {"windows", "windows", "the windows", "are"},
                             {"scissors", "scissors", "these scissors", "are"},
                             {"bottle", "bottle", "a bottle", "is"},
                             {"tyre", "tire", "the tire", "is"},
                             {"tyre", "tyre", "A tyre", "is"},
                             {"ball", "ball", "my ball", "is"},
                             {"castle", "castle", "The castle", "is"},
                             {"statue", "statue", "a statue", "is"},
                             {"cup", "cup", "that cup", "is"},
                             {"book", "book", "a book", "is"},
                             {"pencil", "pencil", "the pencil", "is"},
                             {"door", "door", "a door", "is"},
                             {"boat", "boat", "the boat", "is"},
                             {"key", "key", "a key", "is"},
                             {"coin", "coins", "coins", "are"}};
constexpr const char* kMaterials[] = {"metal",  "wood",  "rock",  "stone",
                                      "rubber", "glass", "paper", "sandpaper"};
constexpr const char* kAdjectives[] = {"hard",  "soft",     "smooth", "rough",
                                       "bumpy", "slippery", "sticky"};

/// Counts answers and those marked otherwise than they should be; the first of these are told.
struct Count {
    int tried = 0;
    int wrong = 0;
    std::string first{};

    void add(const Question& question, const std::string& said, const std::string& codes,
             const Slots& slots) {
        ++tried;
        const Mark mark = mark_answer(question, said);
        if (!mark.understood || codes_of(mark) != codes || mark.slots != slots ||
            mark.turned_round) {
            ++wrong;
            first += wrong > 5 ? "" : "\n" + said + ": " + codes_of(mark) + ", not " + codes;
        }
    }
};

std::string other(const std::string& is) {
    return is == "is" ? "are" : "is";
}

}  // namespace

TEST_CASE("mark: the passive, right in every way that English has, carries no error") {
    const Question question = made_of_what();
    Count count;
    for (const Thing& thing : kThings) {
        for (const std::string material : kMaterials) {
            const Slots slots{{"thing", thing.value}, {"material", material}};
            const std::string subject = std::string(thing.with_article) + " " + thing.is + " ";
            for (const char* made : {"made of ", "made out of ", "made up of ", "MADE OF SOME ",
                                     "made of this ", "made of that "}) {
                count.add(question, subject + made + material, "", slots);
                count.add(question, "I think " + subject + made + material + ".", "", slots);
            }
        }
    }
    for (const std::string material : kMaterials) {
        const Slots slots{{"material", material}};
        for (const char* start : {"", "It is ", "It's ", "They are ", "It is made of ", "Made of ",
                                  "This is made of ", "They're made of ", "of ", "these are "}) {
            count.add(question, start + material, "", slots);
        }
    }
    INFO(count.first);
    CHECK(count.tried == 18 * 8 * 12 + 80);
    CHECK(count.wrong == 0);
}

TEST_CASE("mark: each wrong passive has its label, and the meaning is kept") {
    const Question question = made_of_what();
    Count count;
    for (const Thing& thing : kThings) {
        const std::string subject = std::string(thing.with_article) + " ";
        const std::string is = thing.is;
        for (const std::string material : kMaterials) {
            const Slots slots{{"thing", thing.value}, {"material", material}};
            const struct {
                std::string said;
                const char* codes;
            } rows[] = {
                {subject + is + " made by " + material, "R:PREP"},
                {subject + is + " made from " + material, "R:PREP"},
                {subject + is + " made with " + material, "R:PREP"},
                {subject + is + " made " + material, "M:PREP"},
                {subject + is + " make of " + material, "R:VERB:FORM"},
                {subject + is + " making of " + material, "R:VERB:FORM"},
                {subject + is + " maked of " + material, "R:VERB:INFL"},
                {subject + "has made of " + material, "R:VERB:FORM"},
                {subject + "be made of " + material, "R:VERB:FORM"},
                {subject + other(is) + " made of " + material, "R:VERB:SVA"},
                {subject + "made of " + material, "M:VERB"},
                {subject + "makes of " + material, "R:VERB:VOICE"},
                {subject + "make of " + material, "R:VERB:VOICE"},
                {subject + is + " made of a " + material, "U:DET"},
                {subject + is + " made of the " + material, "U:DET"},
                {subject + "made by a " + material, "M:VERB R:PREP U:DET"},
                {subject + "it " + is + " made of " + material, "U:PRON"},
            };
            for (const auto& row : rows) {
                const bool changed = std::string(thing.value) == "book" && material == "wood";
                const bool from = row.said.find("made from") != std::string::npos;
                count.add(question, row.said, changed && from ? "" : row.codes, slots);
            }
            if (is == "is") {
                count.add(question, std::string(thing.bare) + " is made of " + material, "M:DET",
                          slots);
            }
        }
    }
    for (const std::string material : kMaterials) {
        const Slots slots{{"material", material}};
        count.add(question, "It made of " + material, "M:VERB", slots);
        count.add(question, "is made of " + material, "M:PRON", slots);
        count.add(question, "They is made of " + material, "R:VERB:SVA", slots);
        count.add(question, "It makes of " + material, "R:VERB:VOICE", slots);
        count.add(question, "It is made by " + material, "R:PREP", slots);
    }
    for (const std::string plural : {"metals", "woods", "rubbers", "glasses", "papers"}) {
        const std::string material =
            plural == "glasses" ? "glass" : plural.substr(0, plural.size() - 1);
        count.add(question, "the table is made of " + plural, "R:NOUN:NUM",
                  {{"thing", "table"}, {"material", material}});
    }
    INFO(count.first);
    CHECK(count.tried == 18 * 8 * 17 + 15 * 8 + 40 + 5);
    CHECK(count.wrong == 0);
}

TEST_CASE("mark: one or two adjectives of a material, right, carry no error") {
    const Question question = feels_how();
    Count count;
    for (const std::string material : kMaterials) {
        for (const std::string one : kAdjectives) {
            const Slots single{{"material", material}, {"feel", one}};
            for (const char* verb : {" is ", " feels ", " is very ", " feels quite ", " felt "}) {
                count.add(question, material + verb + one, "", single);
                count.add(question, "The " + material + verb + one + "!", "", single);
            }
            for (const std::string two : kAdjectives) {
                Slots both = single;
                both.emplace_back("also", two);
                for (const char* join :
                     {" and ", " but ", ", and it is ", " and very ", " and also ", ". It is "}) {
                    count.add(question, material + " is " + one + join + two, "", both);
                    count.add(question, material + " feels both " + one + join + two, "", both);
                }
            }
        }
    }
    for (const std::string one : kAdjectives) {
        for (const std::string two : kAdjectives) {
            for (const char* start : {"", "It is ", "It feels ", "They are ", "They feel "}) {
                count.add(question, start + one + " and " + two, "",
                          {{"feel", one}, {"also", two}});
            }
        }
    }
    INFO(count.first);
    CHECK(count.tried == 8 * 7 * (10 + 7 * 12) + 49 * 5);
    CHECK(count.wrong == 0);
}

TEST_CASE("mark: each wrong adjective sentence has its label, and the meaning is kept") {
    const Question question = feels_how();
    Count count;
    const struct {
        const char *adjective, *adverb, *noun, *comparative;
    } forms[] = {{"hard", "hardly", "hardness", "harder"},
                 {"soft", "softly", "softness", "softer"},
                 {"smooth", "smoothly", "smoothness", "smoother"},
                 {"rough", "roughly", "roughness", "rougher"},
                 {"bumpy", "bumpily", "bump", "bumpier"},
                 {"slippery", "slipperily", "slipperiness", "more slippery"},
                 {"sticky", "stickily", "stick", "stickier"}};
    for (const std::string material : kMaterials) {
        for (const auto& form : forms) {
            const std::string one = form.adjective;
            const Slots single{{"material", material}, {"feel", one}};
            Slots both = single;
            both.emplace_back("also", "smooth");
            const struct {
                std::string said;
                const char* codes;
                bool two;
            } rows[] = {
                {material + " " + one, "M:VERB", false},
                {material + " are " + one, "R:VERB:SVA", false},
                {"the " + material + " are " + one, "R:VERB:SVA", false},
                {material + " feel " + one, "R:VERB:SVA", false},
                {material + " feels like " + one, "U:PREP", false},
                {material + " is feel " + one, "R:VERB:FORM", false},
                {material + " be " + one, "R:VERB:FORM", false},
                {material + " is a " + one, "U:DET", false},
                {material + " is the " + one, "U:DET", false},
                {material + " is much " + one, "R:ADV", false},
                {material + " is " + form.adverb, "R:MORPH", false},
                {material + " is " + form.noun, "R:MORPH", false},
                {material + " is " + form.comparative, "R:ADJ:FORM", false},
                {material + " is more " + one, "R:ADJ:FORM", false},
                {material + " is " + one + " smooth", "M:CONJ", true},
                {material + " is " + one + ", smooth", "M:CONJ", true},
                {material + " is " + one + " or smooth", "R:CONJ", true},
                {material + " is " + one + " end smooth", "R:SPELL", true},
                {material + " is " + form.adverb + " and smoothly", "R:MORPH R:MORPH", true},
                {material + " " + one + " smooth", "M:VERB M:CONJ", true},
            };
            for (const auto& row : rows) {
                count.add(question, row.said, row.codes, row.two ? both : single);
            }
        }
    }
    for (const std::string mass : {"metal", "wood", "rubber", "glass", "paper", "sandpaper"}) {
        const std::string plural = mass == "glass" ? "glasses" : mass + "s";
        const Slots slots{{"material", mass}, {"feel", "hard"}};
        count.add(question, "a " + mass + " is hard", "U:DET", slots);
        count.add(question, "the " + plural + " are hard", "R:NOUN:NUM", slots);
    }
    INFO(count.first);
    CHECK(count.tried == 8 * 7 * 20 + 12);
    CHECK(count.wrong == 0);
}
