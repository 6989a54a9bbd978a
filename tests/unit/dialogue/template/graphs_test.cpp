#include "dialogue/template/arc_writer.h"
#include "dialogue/template/article_writer.h"
#include "dialogue/template/compile.h"
#include "dialogue/template/graph.h"
#include "dialogue/template/graph_builder.h"
#include "dialogue/template/resolve_articles.h"
#include "dialogue/template/sentences.h"
#include "dialogue/template/slot_entries.h"
#include "dialogue/template/variant_texts.h"
#include "dialogue/template/what_follows.h"
#include "tests/unit/dialogue/questions.h"
#include "tests/unit/dialogue/rig.h"

using namespace fulcrum::dialogue;

namespace {

/// All right sentences of the first graph, by trying every series of choices.
std::set<std::string> sentences(const std::string& text, const NamedTexts& rules = {}) {
    const TemplateSet set = compiled_templates({{text}, {{"n", {"two", "three"}}}, rules});
    std::set<std::string> result;
    for (unsigned seed = 0; seed < 4096; ++seed) {
        unsigned rest = seed;
        const Sample sample = walk(set, 0, false, [&](std::size_t ways) {
            const std::size_t choice = rest % ways;
            rest /= static_cast<unsigned>(ways);
            return choice;
        });
        result.insert(sample.said);
    }
    return result;
}

using Sentences = std::set<std::string>;

/// The articles of a branch, each with what belongs there where that is another: "a the:the …".
std::string articles(Branch branch, ArticlePolicy policy) {
    TemplateSet set;
    ArcWriter writer(set, kLargestGraph_arcs);
    const int from = writer.add_node();
    const int to = writer.add_node();
    const int determiner = writer.add_element({Role::determiner});
    ArticleWriter(writer, policy, false, determiner, from, to).write(branch);
    std::string text;
    for (const Arc& arc : writer.arcs()) {
        const std::string said = writer.said_by(arc);
        const std::string right = writer.right_of(arc);
        text += (text.empty() ? "" : " ") + (said.empty() ? "-" : said);
        text += arc.code == ErrorCode::none ? "" : ":" + (right.empty() ? "-" : right);
    }
    return text;
}

TemplateSet set_of(const std::string& sentence, std::vector<std::string> things) {
    TemplateSource source;
    source.sentences = {sentence};
    source.lists = {{"thing", std::move(things)}, {"where", {"on", "under"}}};
    auto set = compile_templates(source);
    REQUIRE(set);
    return std::move(*set);
}

std::vector<Variant> made(const std::string& text) {
    TemplateSource source{{text}, fruit(), {}};
    source.lists.emplace_back("other", fruit()[0].second);
    return variants_of(compiled_templates(source), {}, text);
}

bool has(const std::vector<Variant>& variants, const std::string& text, Claim claim) {
    return std::ranges::any_of(variants, [&](const Variant& variant) {
        return variant.text == text && variant.claim == claim;
    });
}

Piece piece(Role role, const std::string& right, const std::string& said) {
    Piece made;
    made.element.role = role;
    made.right = right;
    made.said = said;
    return made;
}

}  // namespace

TEST_CASE("graph: strings are numbered once each") {
    StringTable table;
    CHECK(table.find("a") == kNone);
    const int a = table.intern("a");
    const int b = table.intern("b");
    CHECK(a != b);
    CHECK(table.intern("a") == a);
    CHECK(table.find("b") == b);
    CHECK(table.text(a) == "a");
    CHECK(table.size() == 2);
}

TEST_CASE("graph builder: brackets, alternatives, orders, lists and rules make their sentences") {
    CHECK(sentences("go [now]") == Sentences{"go", "go now"});
    CHECK(sentences("(go|run) home") == Sentences{"go home", "run home"});
    CHECK(sentences("go [now|then]") == Sentences{"go", "go now", "go then"});
    CHECK(sentences("(go;now)") == Sentences{"go now", "now go"});
    CHECK(sentences("(x;y;z)").size() == 6);
    CHECK(sentences("yes|no") == Sentences{"yes", "no"});
    CHECK(sentences("<r> home", {{"r", "go|run"}}) == Sentences{"go home", "run home"});
    CHECK(sentences("go [[now] home]") == Sentences{"go", "go home", "go now home"});
    CHECK(sentences("go {n}").count("go two") == 1);
}

TEST_CASE("graph builder: slots are known as possible and as required") {
    const auto masks = [](const std::string& text) {
        const TemplateSet set = compiled_templates({{text}, {{"a", {"x"}}, {"b", {"y"}}}, {}});
        return std::pair(set.graphs[0].slots, set.graphs[0].required);
    };
    CHECK(masks("{a} {b}") == std::pair(3U, 3U));
    CHECK(masks("{a} [{b}]") == std::pair(3U, 1U));
    CHECK(masks("go ({a}|{b})") == std::pair(3U, 0U));
    CHECK(masks("({a} {b}|{a})") == std::pair(3U, 1U));
    CHECK(masks("({a};{b})") == std::pair(3U, 3U));
}

TEST_CASE("arc writer: nodes made in any order are numbered upwards") {
    TemplateSet set;
    ArcWriter writer(set, 100);
    const int end = writer.add_node();
    const int late = writer.add_node();
    const int start = writer.add_node();
    const int middle = writer.add_node();
    const int element = writer.add_element({});
    writer.add_arc(middle, late, element, {"two", "two", ErrorCode::none, 0, true});
    writer.add_arc(start, middle, element, {"one", "one", ErrorCode::none, 0, true});
    writer.join(late, end);
    writer.add_arc(start, late, element, {"both at once", "one two"});
    const Graph graph = writer.finish(start, end);
    REQUIRE(graph.nodes() == 4);
    REQUIRE(graph.arcs.size() == 4);
    for (const Arc& arc : graph.arcs) {
        CHECK(arc.from < arc.to);
    }
    CHECK(graph.arcs_from(graph.start()).size() == 2);
    CHECK(graph.arcs_from(graph.start())[1].word_count == 3);
    CHECK(graph.arcs_from(graph.end()).empty());
    CHECK(set.words.text(graph.said_by(graph.arcs_from(graph.start())[0])[0]) == "one");
}

TEST_CASE("arc writer: what can't be reached is dropped, and the budget holds") {
    TemplateSet set;
    ArcWriter writer(set, 2);
    const int start = writer.add_node();
    const int end = writer.add_node();
    const int nowhere = writer.add_node();
    const int element = writer.add_element({});
    writer.add_arc(start, end, element, {"a", "a"});
    CHECK_FALSE(writer.full());
    writer.add_arc(nowhere, end, element, {"b", "b"});
    CHECK(writer.full());
    writer.add_arc(start, end, element, {"c", "c"});
    writer.join(start, end);
    const Graph graph = writer.finish(start, end);
    CHECK(graph.arcs.size() == 1);
    CHECK(graph.nodes() == 2);
}

TEST_CASE("arc writer: a misspelling has no standing, a recast's word the most") {
    TemplateSet set;
    ArcWriter writer(set, 10);
    const int start = writer.add_node();
    const int end = writer.add_node();
    const int element = writer.add_element({});
    writer.add_arc(start, end, element, {"heavyest", "heaviest", ErrorCode::spelling, 10});
    writer.add_arc(start, end, element, {"most heavy", "heaviest", ErrorCode::adjective_form, 20});
    writer.add_arc(start, end, element, {"heaviest", "heaviest", ErrorCode::none, 0, true});
    const auto standing = [&](const char* word) {
        return set.standing[static_cast<std::size_t>(set.words.find(word))];
    };
    CHECK(standing("heavyest") == 0);
    CHECK(standing("most") == 1);
    CHECK(standing("heaviest") == 2);
}

TEST_CASE("article writer: behind no there is none, whatever the noun") {
    for (const Branch branch : {Branch::with_a, Branch::bare_or_the, Branch::name}) {
        CHECK(articles(branch, ArticlePolicy::after_no) ==
              "- a:- an:- the:- this:- that:- these:- those:- some:- its:-");
    }
}

TEST_CASE("article writer: what is around everybody has its the") {
    CHECK(articles(Branch::the_stuff, ArticlePolicy::definite) ==
          "the this that -:the a:the an:the");
}

TEST_CASE("slot entries: two slots of one list have two of its entries") {
    const TemplateSet set =
        set_of("the {thing} is {where} the {thing:other}", {"ball", "box", "egg"});
    CHECK(render(canonical_pieces(set, 0, {})) == "The ball is on the box.");
    CHECK(render(canonical_pieces(set, 0, {{"other", "ball"}})) == "The box is on the ball.");
    CHECK(render(canonical_pieces(set, 0, {{"thing", "box"}, {"where", "under"}})) ==
          "The box is under the ball.");
    // What is said is said, though it is the same thing twice.
    CHECK(render(canonical_pieces(set, 0, {{"thing", "egg"}, {"other", "egg"}})) ==
          "The egg is on the egg.");
    // Two lists of the same words are the same things.
    TemplateSource two;
    two.sentences = {"the {thing} is on the {other}"};
    two.lists = {{"thing", {"ball", "box"}}, {"other", {"ball", "box"}}};
    const auto both = compile_templates(two);
    REQUIRE(both);
    CHECK(render(canonical_pieces(*both, 0, {})) == "The ball is on the box.");
    CHECK(wanted_entries(set, {{"other", "nothing of it"}}) == wanted_entries(set, {}));
}

TEST_CASE("slot entries: a list of one entry has no other") {
    const TemplateSet set = set_of("the {thing} is {where} the {thing:other}", {"ball"});
    CHECK(render(canonical_pieces(set, 0, {})) == "The ball is on the ball.");
}

TEST_CASE("what follows: where all ends a phrase does, and the last noun is its head") {
    const auto syntax = parse_template("big egg");
    REQUIRE(syntax);
    CHECK(closes_phrase(*syntax, nullptr, true));
    CHECK_FALSE(closes_phrase(*syntax, nullptr, false));
    const SyntaxNode& egg = syntax->back();
    const SyntaxNode& big = unwrapped(*syntax, unwrapped(*syntax, 0).children[0]);
    CHECK(may_be_noun(big));
    CHECK_FALSE(is_head_noun(big, &egg));
    CHECK(is_head_noun(egg, nullptr));
}

TEST_CASE("variant texts: the author's own words stay around what is said otherwise") {
    const auto compared = made("[the|a] {thing} is <comparative:heavy> [than [the|a] {other}]");
    CHECK(has(compared, "[the|a] {other} is not (as|so) (<adjective:heavy>)  as [the|a] {thing}",
              Claim::same));
    CHECK(has(compared,
              "[the|a] {thing} is the (<comparative:heavy>) (one|of the two|one of the two)",
              Claim::same));
    const auto denied = made("[(it|the bowl) is] under the {thing}");
    REQUIRE(denied.size() == 1);
    CHECK(denied[0].text == "(it|the bowl) is not under the {thing}");
    CHECK(denied[0].about == "thing");
}

TEST_CASE("variant texts: only what is on one scale has an opposite, and only what weighs a verb") {
    const auto far = made("the {thing} is <comparative:far> than the {other}");
    CHECK(std::ranges::none_of(far, [](const Variant& variant) {
        return variant.text.find("weigh") != std::string::npos ||
               variant.text.find("near") != std::string::npos;
    }));
    const auto deed = made("it weighs {thing}");
    REQUIRE(deed.size() == 1);
    CHECK(deed[0].text == "it does not weigh {thing}");
    CHECK(deed[0].claim == Claim::excluded);
    CHECK(made("it is heavy").empty());
    CHECK(made("what is {thing}").empty());
}

TEST_CASE("resolve articles: neighbours are pieces that belong in the sentence") {
    const std::vector<Piece> pieces = {piece(Role::determiner, "the", "the"),
                                       piece(Role::modifier, "", "a"),
                                       piece(Role::noun, "egg", "egg")};
    CHECK(before(pieces, 2) == 0);
    CHECK(before(pieces, 0) == kNone);
    CHECK(after(pieces, 0) == 2);
    CHECK(after(pieces, 2) == kNone);
    CHECK(after({}, kNone) == kNone);
}

TEST_CASE(
    "resolve articles: of two determiners the second goes, or the first before a noun's own") {
    std::vector<Piece> two = {piece(Role::determiner, "my", "my"),
                              piece(Role::determiner, "the", "the"),
                              piece(Role::noun, "egg", "egg")};
    part_determiners(two, 1);
    CHECK(two[0].right == "my");
    CHECK(two[1].right.empty());
    CHECK(two[1].code == ErrorCode::extra_determiner);
    CHECK(two[1].cost > 0);

    std::vector<Piece> number = {piece(Role::determiner, "the", "the"),
                                 piece(Role::noun, "a", "a")};
    number[1].element.slot = 0;
    part_determiners(number, 1);
    CHECK(number[0].right.empty());
    CHECK(number[1].right == "a");

    // What was not said is no error.
    std::vector<Piece> missing = {piece(Role::determiner, "the", "the"),
                                  piece(Role::determiner, "an", "")};
    missing[1].code = ErrorCode::missing_determiner;
    missing[1].cost = 10;
    part_determiners(missing, 1);
    CHECK(missing[1].code == ErrorCode::none);
    CHECK(missing[1].cost == 0);
}

TEST_CASE("resolve articles: a word that only looks like a determiner stays") {
    std::vector<Piece> that = {piece(Role::word, "that", "that"),
                               piece(Role::determiner, "the", "the")};
    part_determiners(that, 1);
    CHECK(that[1].right == "the");
    std::vector<Piece> pronoun = {piece(Role::noun, "this", "this"),
                                  piece(Role::determiner, "the", "the")};
    part_determiners(pronoun, 1);
    CHECK(pronoun[1].right == "the");
}
