// What is offered to who neither types nor speaks, in every lesson as its own test plays it.
#include "tests/lessons/program.h"
#include "tests/support/longest_choice.h"

#include <regex>

using namespace fulcrum::test;
namespace fs = std::filesystem;

namespace {

using Words = std::vector<std::string>;

struct Offer {
    std::string prompt;
    Words caught;  ///< in this level, as it was told
    std::vector<Words> right;
    std::vector<Words> wrong;
    std::string line;
};

Words words_of(const std::string& sentence) {
    std::istringstream stream(sentence);
    Words words;
    for (std::string word; stream >> word;) {
        std::ranges::transform(word, word.begin(),
                               [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
        words.push_back(word == "an" ? "a" : word);  // the noun's own
    }
    return words;
}

std::size_t length_of(const Words& sentence) {
    std::size_t length = 0;
    for (const std::string& word : sentence) {
        length += word.size() + 1;
    }
    return length;
}

/// "It is metal. (right) It is wood."
void read_offer(const std::string& text, Offer& offer) {
    static const std::regex kSentence(R"(([^.?]+)[.?]( \(right\))? ?)");
    for (std::sregex_iterator at(text.begin(), text.end(), kSentence), end; at != end; ++at) {
        ((*at)[2].matched ? offer.right : offer.wrong).push_back(words_of((*at)[1]));
    }
    offer.line = text;
}

/// Every offer of a lesson that somebody plays with the keyboard; each question has one.
std::vector<Offer> offers_of(const std::string& lesson) {
    const Sandbox sandbox;
    const ProgramRun run = sandbox.run("run " + lesson + " --headless --by keyboard");
    INFO(lesson << ": " << run.output);
    REQUIRE(run.exit_code == 0);
    static const std::regex kLine(R"( +[0-9.]+ s  (\w+) +(.*))");
    static const std::regex kCaught(R"(This is an? (\w+)\. Feel .*)");
    std::vector<Offer> offers;
    Offer next;
    int asked = 0;
    std::istringstream lines(run.output);
    for (std::string line; std::getline(lines, line);) {
        std::smatch parts;
        std::smatch caught;
        if (!std::regex_match(line, parts, kLine)) {
            continue;
        }
        const std::string who = parts[1];
        const std::string text = parts[2];
        if (who == "level") {
            next.caught.clear();
        } else if (who == "shows" && std::regex_match(text, caught, kCaught)) {
            next.caught.push_back(caught[1]);
        } else if (who == "asks") {
            next.prompt = text;
            ++asked;
        } else if (who == "offers") {
            offers.push_back(next);
            read_offer(text, offers.back());
        }
    }
    CHECK(static_cast<int>(offers.size()) >= asked);
    return offers;
}

/// One run of words is another, or the same words stand in another order.
bool is_near(const Words& one, const Words& other) {
    Words sorted_one = one;
    Words sorted_other = other;
    std::ranges::sort(sorted_one);
    std::ranges::sort(sorted_other);
    if (sorted_one == sorted_other) {
        return true;
    }
    constexpr std::ptrdiff_t kLongestSlot = 4;  // words: "far from the support"
    const auto [a, b] = std::ranges::mismatch(one, other);
    auto end_a = one.end();
    auto end_b = other.end();
    while (end_a != a && end_b != b && *(end_a - 1) == *(end_b - 1)) {
        --end_a;
        --end_b;
    }
    return end_a - a <= kLongestSlot && end_b - b <= kLongestSlot;
}

/// Those of `all` that some choice says.
std::set<std::string> said_of(const Offer& offer, const Words& all) {
    std::set<std::string> said;
    for (const auto* choices : {&offer.right, &offer.wrong}) {
        for (const Words& choice : *choices) {
            for (const std::string& word : choice) {
                if (std::ranges::find(all, word) != all.end()) {
                    said.insert(word);
                }
            }
        }
    }
    return said;
}

}  // namespace

TEST_CASE("choices: in every lesson each question offers one right answer and wrong ones near it") {
    int n = 0;
    for (const auto& entry : fs::directory_iterator(FULCRUM_SCENARIOS)) {
        if (!fs::exists(entry.path() / "lesson.lua")) {
            continue;
        }
        for (const Offer& offer : offers_of(entry.path().filename())) {
            INFO(offer.prompt << " -> " << offer.line);
            ++n;
            for (const auto* choices : {&offer.right, &offer.wrong}) {
                for (const Words& choice : *choices) {
                    CHECK(length_of(choice) <= length_of(words_of(kLongestChoice)));
                }
            }
            if (offer.prompt.starts_with("Now you ask me")) {
                CHECK(offer.right.size() > 1);
                CHECK(offer.wrong.empty());
                continue;
            }
            REQUIRE(offer.right.size() == 1);
            CHECK(offer.wrong.size() >= 1);
            CHECK(offer.wrong.size() <= 3);
            // Yes and no have sentences of their own.
            const bool is_yes_or_no =
                offer.right[0][0].starts_with("yes") || offer.right[0][0].starts_with("no");
            for (const Words& wrong : offer.wrong) {
                CHECK((is_yes_or_no || is_near(offer.right[0], wrong)));
            }
        }
    }
    CHECK(n > 30);
}

TEST_CASE(
    "choices: gravity offers what was caught in this level, and all of it where all is asked") {
    const Words fruit{"apple", "banana", "egg", "watermelon"};
    for (const Offer& offer : offers_of("gravity")) {
        INFO(offer.prompt << " -> " << offer.line);
        REQUIRE(offer.caught.size() >= 2);
        CHECK(said_of(offer, fruit) ==
              std::set<std::string>(offer.caught.begin(), offer.caught.end()));
    }
}

TEST_CASE("choices: textures offer what lies there, and the sentence that is taught") {
    const Words guesses{"metal", "wood", "rock", "plastic", "glass", "paper", "rubber", "gold"};
    for (const Offer& offer : offers_of("textures")) {
        INFO(offer.prompt << " -> " << offer.line);
        for (const std::string& word : said_of(offer, guesses)) {
            CHECK((word == "metal" || word == "wood" || word == "rock"));
        }
        if (offer.prompt.ends_with("like?")) {
            const bool is_metal = offer.prompt.find("metal") != std::string::npos;
            CHECK(offer.right[0].size() == 5);
            CHECK(offer.right[0][2] == "hard");
            CHECK(offer.right[0][4] == (is_metal ? "smooth" : "rough"));
        }
    }
}
