#include "dialogue/speech/sound_dictionary.h"
#include "dialogue/speech/word_graph.h"
#include "dialogue/template/compile.h"
#include "dialogue/template/matcher.h"
#include "tests/support/scratch_folder.h"
#include "tests/unit/dialogue/rig.h"

using namespace fulcrum::dialogue;

namespace {

TemplateSet compile(const std::vector<std::string>& sentences) {
    TemplateSource source;
    source.sentences = sentences;
    source.lists = {{"thing", {"watermelon", "apple", "egg"}}};
    return compile_templates(source).value();
}

// Whether a sentence can be heard: the nodes that its words lead to, one word after another.
class Heard {
  public:
    explicit Heard(WordGraph graph) : graph_(std::move(graph)) {}

    [[nodiscard]] bool contains(const std::string& sentence) const {
        std::set<int> at{0};
        std::istringstream words(sentence);
        for (std::string word; words >> word;) {
            at = behind(word, at);
        }
        return silently(at).contains(graph_.nodes - 1);
    }

  private:
    [[nodiscard]] std::set<int> silently(const std::set<int>& from) const {
        std::set<int> at = from;
        for (std::vector<int> open(from.begin(), from.end()); !open.empty();) {
            const int node = open.back();
            open.pop_back();
            for (const WordGraph::Arc& arc : graph_.arcs) {
                if (arc.from == node && arc.word == kNone && at.insert(arc.to).second) {
                    open.push_back(arc.to);
                }
            }
        }
        return at;
    }
    [[nodiscard]] std::set<int> behind(const std::string& word, const std::set<int>& at) const {
        const std::set<int> from = silently(at);
        std::set<int> to;
        for (const WordGraph::Arc& arc : graph_.arcs) {
            if (arc.word != kNone && graph_.words[static_cast<std::size_t>(arc.word)] == word &&
                from.contains(arc.from)) {
                to.insert(arc.to);
            }
        }
        return to;
    }

    WordGraph graph_;
};

using Read = std::map<std::string, std::string>;

Expected<int> read_into(std::string_view text, Read& read) {
    return read_sound_dictionary(
        text, [&](std::string_view word, std::string_view sounds) { read.emplace(word, sounds); });
}

std::string fault(std::string_view text) {
    Read read;
    const auto result = read_into(text, read);
    return result ? "" : result.error().message;
}

}  // namespace

TEST_CASE(
    "word graph: what only follows from a sentence is typed, for a closed vocabulary has to stay "
    "small") {
    const TemplateSet set = compile({"the {thing} is the <superlative:heavy>"});
    REQUIRE(match(set, "the egg is not the heaviest"));
    REQUIRE(match(set, "the egg weighs the most"));
    const WordGraph graph = make_word_graph(set);
    for (const char* said : {"the egg is not the heaviest", "the egg weighs the most", "neither"}) {
        INFO(said);
        CHECK_FALSE(Heard(graph).contains(said));
    }
    CHECK(Heard(graph).contains("the egg"));
    std::size_t n_arcs = 0;
    for (int i = 0; i < set.answers; ++i) {
        n_arcs += set.graphs[static_cast<std::size_t>(i)].arcs.size();
    }
    CHECK(graph.arcs.size() < 3 * n_arcs);
    CHECK(static_cast<std::size_t>(graph.nodes) < graph.arcs.size());
}

TEST_CASE("word graph: has what is right, what learners say, and nothing that cannot be heard") {
    const WordGraph graph = make_word_graph(compile({"the {thing} is the <superlative:heavy>"}));
    const Heard said(graph);
    CHECK(said.contains("the watermelon is the heaviest"));
    CHECK(said.contains("the egg is the most heavy"));
    CHECK(said.contains("egg is heaviest"));
    CHECK(said.contains("the apple"));  // a short answer
    CHECK_FALSE(said.contains(""));
    // Spelt otherwise, said alike.
    CHECK_FALSE(said.contains("the egg is the heavyest"));
    // Another sentence than the template's.
    CHECK_FALSE(said.contains("the heaviest is the egg"));
}

TEST_CASE("word graph: what sounds alike is heard as what is right") {
    const Heard said(make_word_graph(compile({"the {thing} is <comparative:heavy> than the egg"})));
    CHECK(said.contains("the apple is heavier than the egg"));
    CHECK(said.contains("the apple is heavier from the egg"));
    CHECK_FALSE(said.contains("the apple is heavier then the egg"));
}

TEST_CASE("word graph: each word and each arc is there once, from 0 to the last node") {
    const WordGraph graph =
        make_word_graph(compile({"the {thing} is the <superlative:beautiful>", "the {thing}"}));
    const std::set<std::string> words(graph.words.begin(), graph.words.end());
    CHECK(words.size() == graph.words.size());
    std::set<std::tuple<int, int, int>> arcs;
    for (const WordGraph::Arc& arc : graph.arcs) {
        CHECK(arcs.emplace(arc.from, arc.to, arc.word).second);
        CHECK(arc.from >= 0);
        CHECK(arc.from < graph.nodes - 1);
        CHECK(arc.to > 0);
        CHECK(arc.to < graph.nodes);
        CHECK(arc.word >= kNone);
        CHECK(arc.word < static_cast<int>(graph.words.size()));
        CHECK((arc.weight == 1.0 || arc.weight == kErrorWeight));
    }
    CHECK(std::ranges::any_of(graph.arcs, [](const auto& arc) { return arc.weight < 1.0; }));
}

TEST_CASE("word graph: numbers are said in words") {
    const WordGraph graph = make_word_graph(compile({"it has 21 moons"}));
    CHECK(Heard(graph).contains("it has twenty one moons"));
}

TEST_CASE(
    "sound dictionary: words with their sounds; remarks, blank lines and other ends of lines") {
    Read read;
    const auto n = read_into(
        ";; remark\r\napple AE P AH L\r\n\nread R IY D\nread(2) R EH D\n## end\ncafé K AH F EY",
        read);
    REQUIRE(n);
    CHECK(*n == 4);
    CHECK(read == Read{{"apple", "AE P AH L"},
                       {"read", "R IY D"},
                       {"read(2)", "R EH D"},
                       {"café", "K AH F EY"}});
}

TEST_CASE("sound dictionary: what is malformed is refused with its line, in one sentence") {
    struct {
        std::string text, message;
    } const rows[] = {
        {"apple AE P AH L\negg",
         "line 2 has no word with sounds behind it; the file may be cut off there, get it anew"},
        {"apple AE P A",
         "line 1 has \"A\", which is no sound of English; the file may be damaged there, get it "
         "anew"},
        {"apple ",
         "line 1 has no word with sounds behind it; the file may be cut off there, get it anew"},
        {" AE P",
         "line 1 has no word with sounds behind it; the file may be cut off there, get it anew"},
        {"apple AE  P",
         "line 1 has \" \", which is no sound of English; the file may be damaged there, get it "
         "anew"},
        {"apple 사과",
         "line 1 has \"사과\", which is no sound of English; the file may be damaged there, get it "
         "anew"},
        {std::string("apple AE\0P", 10),
         "line 1 has a letter that is no text; save it as plain text, in UTF-8"},
        {std::string("a\0p\0 \0A\0", 8),
         "line 1 has a letter that is no text; save it as plain text, in UTF-8"},
        {"egg EH G\nap\x1b[31mple AE",
         "line 2 has a letter that is no text; save it as plain text, in UTF-8"},
        {std::string(10'000'000, 'a'), "line 1 is longer than 500 letters; write one word a line"},
        {"", "it has no word; get it anew"},
        {";; nothing\n\n", "it has no word; get it anew"},
    };
    for (const auto& row : rows) {
        INFO(row.text.substr(0, 40));
        CHECK(fault(row.text) == row.message);
    }
}

TEST_CASE(
    "sound dictionary: a file that is missing, a folder, and one that is damaged name themselves") {
    const fulcrum::ScratchFolder folder;
    const auto message = [](const std::string& path) {
        const auto opened = open_sound_dictionary(path, [](std::string_view, std::string_view) {});
        return opened ? std::to_string(*opened) : opened.error().message;
    };
    const std::string path = (folder.path() / "words.dict").string();
    CHECK(message(path) == "the dictionary of sounds " + path +
                               " is missing; install the package pocketsphinx-en-us");
    CHECK(message(folder.path().string()) ==
          "the dictionary of sounds " + folder.path().string() +
              " is no file; give one, or install the package pocketsphinx-en-us");
    folder.write("words.dict", "egg EH G\n");
    CHECK(message(path) == "1");
    folder.write("words.dict", "egg EH G \nrock R AA  ");
    CHECK(message(path) == "2");
    folder.write("words.dict", "egg EH G\nrock R A");
    CHECK(message(path).starts_with("the dictionary of sounds " + path + ": line 2 has \"A\""));
}
