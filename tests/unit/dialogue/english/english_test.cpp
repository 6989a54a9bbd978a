#include "dialogue/english/adjective.h"
#include "dialogue/english/antonyms.h"
#include "dialogue/english/common_noun.h"
#include "dialogue/english/letters.h"
#include "dialogue/english/lexicon.h"
#include "dialogue/english/number.h"
#include "dialogue/english/sorted_lines.h"
#include "dialogue/english/verb.h"
#include "tests/support/scratch_folder.h"
#include "tests/unit/dialogue/rig.h"

#include <rapidcheck.h>

using namespace fulcrum::dialogue;

namespace {

SortedLines opened(const fulcrum::ScratchFolder& folder, const std::string& text) {
    folder.write("lines", text);
    auto lines = SortedLines::open((folder.path() / "lines").string(), "some-package");
    REQUIRE(lines);
    return std::move(*lines);
}

}  // namespace

TEST_CASE("adjective: the positive degree is the word itself, and nothing has no degrees") {
    CHECK(degree_forms("heavy", Degree::positive) == std::vector<std::string>{"heavy"});
    CHECK(degree_forms("", Degree::superlative) == std::vector<std::string>{""});
    CHECK(with_ending("", "er").empty());
    CHECK(learner_forms("", Degree::comparative).empty());
    CHECK(learner_forms("", Degree::positive).empty());
}

TEST_CASE("learner forms: none is right, none comes twice, each has a code") {
    for (const char* adjective :
         {"heavy", "big", "large", "dry", "quiet", "simple", "beautiful", "good", "little", "many",
          "fun", "tired", "red", "icy", "free", "x", "good-looking"}) {
        for (const Degree degree : {Degree::comparative, Degree::superlative}) {
            INFO(adjective);
            const std::vector<std::string> right = degree_forms(adjective, degree);
            std::set<std::string> seen;
            for (const LearnerForm& form : learner_forms(adjective, degree)) {
                CHECK(std::find(right.begin(), right.end(), form.text) == right.end());
                CHECK(seen.insert(form.text).second);
                CHECK(form.code != ErrorCode::none);
                CHECK((form.slip >= 1 && form.slip <= 3));
            }
            CHECK(seen.size() >= 4);
        }
    }
}

TEST_CASE("learner forms: none for the plain adjective is right, comes twice or lacks a code") {
    for (const char* adjective : {"hard", "sticky", "slippery", "good", "y", "ty", "e"}) {
        std::set<std::string> seen{adjective};
        for (const LearnerForm& form : learner_forms(adjective, Degree::positive)) {
            INFO(form.text);
            CHECK(seen.insert(form.text).second);
            CHECK(form.code != ErrorCode::none);
        }
    }
}

TEST_CASE("verb: what learners say instead has a code and is neither number") {
    for (const char* word : {"is", "was", "weighs", "have"}) {
        VerbForms forms;
        REQUIRE(understand_verb(word, forms));
        for (const LearnerVerb& wrong : learner_verbs(forms)) {
            CHECK(wrong.code != ErrorCode::none);
            CHECK(wrong.text != forms.singular);
            CHECK(wrong.text != forms.plural);
        }
    }
}

TEST_CASE("number: all numbers below a thousand differ in words") {
    std::set<std::vector<std::string>> all;
    for (long number = 0; number < 1000; ++number) {
        CHECK(all.insert(number_words(number)).second);
    }
}

TEST_CASE("letters: distance is symmetric, zero only for equals, and bounded by the longer word") {
    CHECK(rc::check([](const std::string& a, const std::string& b) {
        const std::string first = a.substr(0, 32);
        const std::string second = b.substr(0, 32);
        const int distance = edit_distance(first, second);
        RC_ASSERT(distance == edit_distance(second, first));
        RC_ASSERT((distance == 0) == (first == second));
        RC_ASSERT(distance <= static_cast<int>(std::max(first.size(), second.size())));
    }));
}

TEST_CASE("letters: one edit is at distance one at most") {
    CHECK(rc::check([](const std::string& text, unsigned at, char letter) {
        const std::string word = text.substr(0, 31);
        std::string edited = word;
        edited.insert(at % (word.size() + 1), 1, letter);
        RC_ASSERT(edit_distance(word, edited) == 1);
    }));
}

TEST_CASE("lexicon: what a word mostly is, and a plural by exception") {
    const auto opened = Lexicon::open();
    REQUIRE(opened);
    const auto count = [&](const char* word, WordKind kind) { return opened->count(word, kind); };
    CHECK(count("moon", WordKind::noun) > 10 * count("moon", WordKind::verb));
    CHECK(count("heavy", WordKind::adjective) > count("heavy", WordKind::noun));
    CHECK(count("go", WordKind::verb) > 100);
    CHECK(count("moones", WordKind::noun) == 0);
    CHECK(count("", WordKind::noun) == 0);
    const std::vector<std::string> feet = opened->irregular_plurals("foot");
    CHECK(std::find(feet.begin(), feet.end(), "feet") != feet.end());
}

TEST_CASE("lexicon: a folder without WordNet is one sentence that names the package") {
    const auto message = [](const auto& opened) {
        REQUIRE_FALSE(opened);
        return opened.error().message;
    };
    for (const std::string& told :
         {message(Lexicon::open("/nowhere")), message(Antonyms::open("/nowhere")),
          message(CommonNouns::open("/nowhere"))}) {
        CHECK_THAT(told, Catch::Contains("wordnet-base"));
    }
}

TEST_CASE("sorted lines: every line is found by its beginning, and what isn't there is not") {
    const fulcrum::ScratchFolder folder;
    const SortedLines lines = opened(folder, "ant 1\nbee 2\nbee 3\nbeetle 4\ncat 5\n");
    CHECK(lines.starting_with("ant ") == "ant 1\n");
    CHECK(lines.starting_with("bee ") == "bee 2\nbee 3\n");
    CHECK(lines.starting_with("bee") == "bee 2\nbee 3\nbeetle 4\n");
    CHECK(lines.starting_with("cat ") == "cat 5\n");
    CHECK(lines.starting_with("a") == "ant 1\n");
    CHECK(lines.starting_with("aa").empty());
    CHECK(lines.starting_with("bef").empty());
    CHECK(lines.starting_with("zoo").empty());
    CHECK(lines.starting_with("").size() == lines.text().size());
}

TEST_CASE("sorted lines: a last line without its end, and one line alone") {
    const fulcrum::ScratchFolder folder;
    CHECK(opened(folder, "ant 1\nbee 2").starting_with("bee ") == "bee 2");
    CHECK(opened(folder, "ant 1").starting_with("ant") == "ant 1");
    CHECK(opened(folder, "\n").starting_with("a").empty());
}

TEST_CASE("sorted lines: what cannot be read is named with its package") {
    const fulcrum::ScratchFolder folder;
    folder.write("empty", "");
    for (const std::string name : {"missing", "empty", "."}) {
        const auto lines = SortedLines::open((folder.path() / name).string(), "some-package");
        REQUIRE_FALSE(lines);
        CHECK(lines.error().message.find(name) != std::string::npos);
        CHECK(lines.error().message.find("some-package") != std::string::npos);
    }
}
