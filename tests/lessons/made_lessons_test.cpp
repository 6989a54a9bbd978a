// Lessons by chance, right ones and broken ones, looked at by fulcrum check --quick: whatever a teacher writes it ends with 0, 1 or 2,
// soon, and each sentence says where.
#include "tests/lessons/program.h"

#include <cstdlib>
#include <random>
#include <regex>

using namespace fulcrum::test;

namespace {

using Words = std::vector<std::string>;

/// A lesson's text, the same for the same seed and compiler. Every other one is careless: it has what no lesson may have, or slips of the
/// pen. Of the others most can be played.
class MadeLesson {
  public:
    explicit MadeLesson(std::uint64_t seed)
        : random_(seed),
          careless_(seed % 2 == 0),
          feel_(one_of({"\"hard\", \"soft\"", "\"hard\"", "\"big|large\", \"soft\""},
                       {"", "\"hard\", \"hard\"", "\"|\"", "3"})),
          size_(one_of({"\"two\", \"3\"", "\"metal\", \"wood\"", "\"a metal block\"", "\"Mars\""},
                       {"\"[a]\"", "{}"})),
          place_(one_of({"on the shelf", "(on|under) it", "[just] here"}, {"<place>", "", "[a"})) {}

    std::string make() {
        std::string text =
            "local game = require \"game\"\nlocal know = require \"know\"\n" + head();
        for (int i = below(3); i > 0; --i) {
            text += knowledge(i);
        }
        for (int i = below(4); i > 0; --i) {
            asked_.push_back("q" + std::to_string(i));
            text += question(asked_.back());
        }
        text += start();
        if (chance(30)) {
            text += "L:test { say = { " + listed(some(4, &MadeLesson::said)) +
                    " }, expect = { finished = true } }\n";
        }
        text += "return L\n";
        for (int i = careless_ ? below(4) : 0; i > 0; --i) {
            slip(text);
        }
        return text;
    }

  private:
    int below(int n) { return static_cast<int>(random_() % static_cast<std::uint64_t>(n)); }
    bool chance(int percent) { return below(100) < percent; }
    /// One of `words`; in a careless lesson now and then one of `odd`.
    std::string one_of(const Words& words, const Words& odd = {}) {
        const Words& from = careless_ && !odd.empty() && chance(12) ? odd : words;
        return from[static_cast<std::size_t>(below(static_cast<int>(from.size())))];
    }
    Words some(int most, std::string (MadeLesson::*text)()) {
        Words texts;
        for (int i = below(most + 1); i > 0; --i) {
            texts.push_back((this->*text)());
        }
        return texts;
    }
    static std::string listed(const Words& texts) {
        std::string all;
        for (const std::string& text : texts) {
            all += (all.empty() ? "\"" : ", \"") + text + '"';
        }
        return all;
    }

    std::string head() {
        return "local L = lesson { id = \"made\", title = \"Made\"" +
               one_of({"", "", ", free_english = true", ", tries = 1", ", feedback = { \"rule\" }"},
                      {", tries = 0", ", feedback = { \"scold\" }", ", id = 3", ", lists = {}"}) +
               " }\n" +
               one_of({"", "", "know.things(L)\n", "know.words(L, { \"weight\" })\n"},
                      {"know.words(L, { \"zzz\" })\n", "know.things(3)\n"});
    }

    // ---- sentences

    std::string word() {
        return one_of(
            {"egg",     "stone", "heavy", "the",  "a",     "is",    "are",   "not",
             "it",      "red",   "two",   "12",   "than",  "of",    "and",   "but",
             "because", "I",     "don't", "it's", "moons", "which", "metal", "wooden block",
             "Mars",    "very",  "there", "then", "no",    "one"},
            {"", " ", "?", "%", "O'Neil", "ice-cream", "3.5", "caf\u00e9", "\\", "the the", "\"",
             "["});
    }
    std::string part(int depth) {
        switch (below(depth > 2 ? 4 : 7)) {
            case 0:
                return '{' + one_of({"thing", "feel", "size"}, {"nothing", "", "{"}) + ":s" +
                       std::to_string(++n_slots_) + '}';
            case 1:
                return one_of({"<comparative:heavy>", "<superlative:big>", "<adjective:heavy>",
                               "<place>", "<comparative:good>"},
                              {"<place:heavy>", "<nothing>", "<comparative:>",
                               "<comparative:{thing}>", "<superlative:zz>", "<>"});
            case 4:
                return '[' + sequence(depth + 1) + ']';
            case 5:
                return '(' + sequence(depth + 1) + '|' + sequence(depth + 1) + ')';
            case 6:
                return one_of({"[a|an|the]", "[the]", "[very]"},
                              {"[]", "()", "(|)", "[a", "a]", "[a]b"});
            default:
                return word();
        }
    }
    std::string sequence(int depth) {
        std::string text = word();
        for (int i = below(4); i > 0; --i) {
            text += ' ' + part(depth);
        }
        return text;
    }
    /// Half of them as lessons have them.
    std::string answer() {
        return chance(50)
                   ? sequence(0)
                   : one_of({"[the|a|an] {thing} is <comparative:heavy> [than [the|a|an] {other}]",
                             "it is <adjective:{feel}>", "there are {size} moons",
                             "the {thing} is <made_of:{size}>", "the {thing} is <place>",
                             "[a|an|the] {thing} is the <superlative:big> [one|thing]",
                             "what is {feel}", "no, it is not", "{feel}"});
    }
    std::string said() {
        std::string text;
        for (int i = below(7); i > 0; --i) {
            text += (text.empty() ? "" : " ") + word();
        }
        return chance(40) ? one_of({"the egg is heavier", "it is soft", "two", "Because it is big.",
                                    "not the egg, the stone"})
                          : text;
    }

    // ---- declarations

    /// The lists and rules that stand in `sentences`; in a careless lesson now and then none or more.
    std::string words(const std::string& sentences) {
        const auto has = [&](const char* name) {
            return sentences.find(name) != std::string::npos || (careless_ && chance(10));
        };
        std::string lists = has("<place") ? " rules = { place = \"" + place_ + "\" }," : "";
        lists += " lists = { ";
        lists += has("{feel") ? "feel = { " + feel_ + " }, " : "";
        lists += has("{size") ? "size = { " + size_ + " }, " : "";
        return lists + "},";
    }
    std::string question(const std::string& name) {
        const std::string judged =
            one_of({"return a.thing == \"egg\"", "return true", "return false",
                    "return a.feel == \"soft\"", "return a.thing ~= a.other", "",
                    "return a.bodies.thing and a.bodies.thing.weight > 1"},
                   {"return a.nothing == 1", "local t = nil return t.x", "error \"x\"",
                    "while true do end", "return (\"x\"):rep(1e9)", "return world"});
        Words answers = some(2, &MadeLesson::answer);
        answers.push_back(answer());
        return "L:question \"" + name + "\" {\n  prompt = \"" +
               one_of({"Which one is heavier, the egg or the stone?", "How does it feel?",
                       "Is it red?", said() + "?"},
                      {"", "?"}) +
               "\"," + (chance(30) ? " again = \"" + said() + "\"," : "") + "\n  answers = { " +
               listed(answers) + " }," +
               (chance(20) ? "\n  nearly = { " + listed({"so " + answers[0]}) + " }," : "") +
               "\n " + words(listed(answers)) +
               (chance(20)
                    ? "\n  examples = { right = { " + listed(some(3, &MadeLesson::said)) + " } },"
                    : "") +
               "\n  right = function(a) " + judged + " end\n}\n";
    }
    std::string knowledge(int i) {
        const std::string asked =
            listed({"how " + word() + " is (it|the {thing})", "what about " + answer()});
        return "L:knows \"k" + std::to_string(i) + "\" {\n  asked = { " + asked + " }," +
               words(asked) + "\n  answer = function(asked, world) return " +
               one_of({"\"Red.\"", "nil", "asked.thing", "\"It is \" .. tostring(asked.feel)"},
                      {"3", "{}", "asked.nothing.x"}) +
               " end\n}\n";
    }
    std::string start() {
        std::string text = "function L:start(world)\n";
        for (const char* name : {"egg", "stone", "block"}) {
            if (chance(80)) {
                text += "  world:body { name = \"" + one_of({name}, {"egg", "x y", ""}) +
                        "\", model = \"" + one_of({"sphere", "box", "egg"}, {"eg", ""}) + "\"" +
                        one_of({"", ", solid = true, visible = true",
                                ", movable = true, mass = 0.1", ", noun = \"metal block\""},
                               {", mass = -1", ", at = { 0, 0 }", ", moable = true"}) +
                        " }\n";
            }
        }
        text += "  " +
                one_of({"", "world:spring { at = { 0, 0, 0 }, stiffness = 50 }", "world:bucket {}"},
                       {"world:bukket {}", "world:wind(3)"}) +
                "\n  game.play(L, world, function()\n";
        for (const std::string& name : asked_) {
            text += chance(85) ? "    game.ask \"" + name + "\"\n" : "";
        }
        return text + "  end)\nend\n";
    }

    /// What fingers do: a letter too few, too many or another one, a line lost or twice, the end lost.
    void slip(std::string& text) {
        if (text.size() < 2) {
            return;
        }
        const auto at = static_cast<std::size_t>(below(static_cast<int>(text.size() - 1)));
        const std::size_t line = at == 0 ? 0 : text.rfind('\n', at - 1) + 1;
        const std::size_t length = std::min(text.find('\n', line), text.size() - 1) - line + 1;
        const std::string odd = one_of({"}", "{", "\"", "]", "(", "|", "<", ",", "end ", "nil",
                                        "\\", "\xff", std::string(1, '\0'), "--", "[["});
        switch (below(7)) {
            case 0:
                text.erase(at, 1);
                break;
            case 1:
                text.insert(at, odd);
                break;
            case 2:
                text.replace(at, 1, odd);
                break;
            case 3:
                text.erase(line, length);
                break;
            case 4:
                text.insert(line, text.substr(line, length));
                break;
            case 5:
                std::swap(text[at], text[at + 1]);
                break;
            default:
                text.resize(chance(10) ? at : text.size());
        }
    }

    std::mt19937_64 random_;
    bool careless_;
    std::string feel_, size_, place_;  // what the lists and the rule hold
    Words asked_;
    int n_slots_ = 0;
};

/// What is wrong with how the program told of it; "" where nothing is.
std::string trouble_with(const ProgramRun& run) {
    static const std::regex kPlaced(R"(((lesson|lib/[a-z_]+)\.lua:\d+(, |: ))+.*[.?":!])");
    static const std::regex kEnd(
        R"(made: (no mistakes found|it can be played, but see the sentences? above)\. .*)");
    if (run.exit_code < 0 || run.exit_code > 2) {
        return "it ended with " + std::to_string(run.exit_code);
    }
    std::istringstream lines(run.output);
    int n = 0;
    for (std::string line; std::getline(lines, line); ++n) {
        const bool is_head = line.starts_with("Nothing wrong is found in these, but");
        if (!is_head && !std::regex_match(line, kPlaced) && !std::regex_match(line, kEnd)) {
            return "it says not where: " + line;
        }
        if (line.find("crashed") != std::string::npos ||
            line.find("not allowed") != std::string::npos) {
            return "its process broke: " + line;
        }
    }
    return n == 0 ? "it says nothing" : "";
}

}  // namespace

TEST_CASE("check: lessons made by chance are judged soon, and each sentence says where") {
    // The short form; tests/README.md has the long one.
    const char* const asked = std::getenv("FULCRUM_MADE_LESSONS");
    const int n = asked != nullptr ? std::atoi(asked) : 12;
    const Sandbox sandbox;
    int n_of_code[3] = {};
    for (int seed = 1; seed <= n; ++seed) {
        const std::string text = MadeLesson(static_cast<std::uint64_t>(seed)).make();
        sandbox.write("made/lesson.lua", text);
        // Processor time, which nothing else on the machine takes: past 10 s it is ended, and ends with 2.
        const ProgramRun run = sandbox.run("check --quick made", "prlimit --cpu=10");
        const std::string trouble = trouble_with(run);
        if (!trouble.empty()) {
            FAIL_CHECK("seed " << seed << ": " << trouble << "\n" << text << "\n" << run.output);
            continue;
        }
        ++n_of_code[run.exit_code];
    }
    // Some of each kind, or the lessons are all alike.
    CHECK(n_of_code[0] > n / 10);
    CHECK(n_of_code[1] > n / 10);
}
