#include "dialogue/marking/mark_answer.h"
#include "dialogue/template/arc_writer.h"
#include "dialogue/template/hearing.h"
#include "dialogue/template/phrases.h"
#include "dialogue/template/sentence_parts.h"
#include "dialogue/template/syntax.h"
#include "dialogue/template/what_follows.h"
#include "tests/unit/dialogue/questions.h"
#include "tests/unit/dialogue/rig.h"
#include "tests/unit/dialogue/table.h"
#include "tests/unit/dialogue/told_mark.h"

using namespace fulcrum::dialogue;

namespace {

/// Why the answers above, and the one that goes in, cannot be compiled; "column": with the column before it.
std::string compile_error(TableScene& scene, const std::string& in) {
    TemplateSource source{scene.source.answers, scene.source.lists, scene.source.rules};
    if (!in.empty()) {
        source.sentences.push_back(in);
    }
    const auto set = compile_templates(source);
    return set                  ? ""
           : scene.with.empty() ? set.error().message
                                : std::to_string(set.error().column) + ": " + set.error().message;
}

/// Each word as the templates know it: "word", "(filler)", "word~" when a slip was put right, "?" when unknown.
std::string heard(TableScene& scene, const std::string& in) {
    std::size_t work = 0;
    std::vector<std::string> words;
    for (const HeardWord& word : hear_words(scene.templates(), in, work)) {
        const std::string text = word.word == kNone ? "?" : scene.templates().words.text(word.word);
        words.push_back(word.filler ? "(" + text + ")"
                                    : text + (word.slip == ErrorCode::none ? "" : "~"));
    }
    return spaced(words);
}

/// How many words are not read, where a reason begins as the probe is told.
std::string unread(TableScene& scene, const std::string& in) {
    const Reason reason = scene.with == "so_too" ? Reason::so_too : Reason::because;
    std::size_t work = 0;
    const auto words = hear_words(scene.templates(), in, work, Its::contraction, reason);
    return std::to_string(
        std::ranges::count_if(words, [](const HeardWord& word) { return word.unread; }));
}

/// Right, and a short answer.
std::string is_short(TableScene& scene, const std::string& in) {
    const auto parse = match(scene.templates(), in);
    return yes_or_no(parse && parse->cost == 0 &&
                     scene.templates().graphs[static_cast<std::size_t>(parse->graph)].short_answer);
}

/// What is meant, and the errors found; "?" where it is not understood.
std::string meant(TableScene& scene, const std::string& in) {
    const Mark mark = mark_answer(scene.question(), in);
    if (!mark.understood) {
        return "?";
    }
    const std::string claim = mark.claim == Claim::same ? "" : told_of(mark, "claim");
    std::string all;
    for (const std::string& part : {claim, told_slots(mark.slots), codes_of(mark)}) {
        all += (all.empty() || part.empty() ? "" : " ") + part;
    }
    return all;
}

/// The code and the base of the one error.
std::string main_error(TableScene& scene, const std::string& in) {
    const Mark mark = mark_answer(scene.question(), in);
    REQUIRE(mark.form_errors.size() == 1);
    return std::string(mark.form_errors[0].errant()) + " of " + mark.form_errors[0].base;
}

/// The last slot of the last reading.
std::string last_reading(TableScene& scene, const std::string& in) {
    const Mark mark = mark_answer(scene.question(), in);
    REQUIRE_FALSE(mark.readings.empty());
    return told_slots({mark.readings.back().back()});
}

/// Writes the one place that the words of a probe name: "word is after_list", "degree heavy comparative the", "plural foot
/// counted", "it singular" or "article".
void write_place(const std::vector<std::string>& place, ArcWriter& writer, int from, int to) {
    const auto has = [&](const char* word) { return std::ranges::count(place, word) > 0; };
    if (place[0] == "word") {
        add_word(writer, place[1], place[1],
                 {.after_list = has("after_list"),
                  .after_adjective = has("after_adjective"),
                  .before_adjective = has("before_adjective")},
                 from, to);
    } else if (place[0] == "degree") {
        add_degree(writer, {"", {{place[1], {Noun{place[1]}}}}}, kNone,
                   has("superlative") ? Degree::superlative : Degree::comparative, has("the"), from,
                   to);
    } else if (place[0] == "plural") {
        add_plural(writer, place[1], has("counted"), from, to);
    } else if (place[0] == "it") {
        add_it(writer,
               has("singular") ? SubjectNumber::singular
               : has("plural") ? SubjectNumber::plural
                               : SubjectNumber::unknown,
               from, to);
    } else {
        add_article(writer, "", SubjectNumber::unknown, from, to);
    }
}

/// The code of one way of saying a place, "-" where it is none; "how many" ways there are, and how many "wrong ones".
std::string phrase(TableScene& scene, const std::string& in) {
    TemplateSet set;
    ArcWriter writer(set, 1000);
    const int start = writer.add_node();
    const int end = writer.add_node();
    write_place(listed(scene.with, " "), writer, start, end);
    const Graph graph = writer.finish(start, end);
    std::map<std::string, ErrorCode> ways;
    for (const Arc& arc : graph.arcs) {
        std::vector<std::string> said;
        for (const int word : graph.said_by(arc)) {
            said.push_back(set.words.text(word));
        }
        if (arc.element != kNone) {
            ways[spaced(said)] = arc.code;
        }
    }
    if (in == "how many") {
        return std::to_string(ways.size());
    }
    if (in == "wrong ones") {
        return std::to_string(std::ranges::count_if(
            ways, [](const auto& way) { return way.second != ErrorCode::none; }));
    }
    const auto found = ways.find(in);
    return found == ways.end() ? "-" : std::string(errant_code(found->second));
}

/// A tree as text: s(…) a(…) p(…) o(…) words, {list:slot}, <rule:word>.
std::string shown(const Syntax& syntax, int index = 0) {
    using Kind = SyntaxNode::Kind;
    const SyntaxNode& node = syntax[static_cast<std::size_t>(index)];
    std::vector<std::string> children;
    for (const int child : node.children) {
        CHECK(child > index);
        children.push_back(shown(syntax, child));
    }
    const std::string inside = spaced(children);
    const std::string argument = node.argument.empty() ? "" : ":" + node.argument;
    switch (node.kind) {
        case Kind::sequence:
            return children.size() == 1 ? inside : "s(" + inside + ")";
        case Kind::alternatives:
            return children.size() == 1 ? inside : "a(" + inside + ")";
        case Kind::permutation:
            return "p(" + inside + ")";
        case Kind::optional:
            return "o(" + inside + ")";
        case Kind::word:
            return node.text;
        case Kind::list:
            return "{" + node.text + argument + "}";
        case Kind::rule:
            return "<" + node.text + argument + (inside.empty() ? "" : ":" + inside) + ">";
    }
    return "?";
}

/// The tree, or the column and what is wrong there.
std::string tree(TableScene&, const std::string& in) {
    const auto syntax = parse_template(in);
    return syntax ? shown(*syntax)
                  : std::to_string(syntax.error().column) + ": " + syntax.error().message;
}

/// The text with "not" behind its first "is".
std::string denied(TableScene&, const std::string& in) {
    const TemplateSet set = compiled_templates({{"the {thing}"}, fruit(), {}});
    const auto syntax = parse_template(in);
    REQUIRE(syntax);
    const ParsedRules rules;
    return SentenceParts(set, rules, in, *syntax).denied(in.find("is"));
}

/// What `ask` says of a template and the first part of its own sequence.
template <class Ask>
Probe of_first_part(Ask ask) {
    return [ask](TableScene&, const std::string& in) {
        const auto syntax = parse_template(in);
        REQUIRE(syntax);
        const SyntaxNode& whole = unwrapped(*syntax, 0);
        const bool is_sequence = whole.kind == SyntaxNode::Kind::sequence;
        return yes_or_no(
            ask(*syntax, &(is_sequence ? unwrapped(*syntax, whole.children[0]) : whole)));
    };
}

const std::map<std::string, Probe> kTemplateProbes{
    {"match", probe_match},
    {"matches",
     [](TableScene& scene, const std::string& in) {
         return yes_or_no(match(scene.templates(), in).has_value());
     }},
    {"called",
     [](TableScene& scene, const std::string& in) {
         const auto parse = match(scene.templates(), in);
         return yes_or_no(parse && parse->cost == 0);
     }},
    {"mark", probe_mark},
    {"meant", meant},
    {"main_error", main_error},
    {"last_reading", last_reading},
    {"are_no_planet",
     [](TableScene& scene, const std::string& in) {
         const std::string back = mark_answer(scene.question(), in).corrected;
         return yes_or_no(back.find("are no planet ") != std::string::npos ||
                          back.find("are no planet.") != std::string::npos);
     }},
    {"short", is_short},
    {"error", compile_error},
    {"heard", heard},
    {"heard_words",
     [](TableScene& scene, const std::string& in) {
         std::size_t work = 0;
         return std::to_string(hear_words(scene.templates(), in, work).size());
     }},
    {"unread", unread},
    {"consequence",
     [](TableScene& scene, const std::string& in) {
         return yes_or_no(has_consequence(scene.templates(), in));
     }},
    {"phrase", phrase},
    {"is_article", [](TableScene&, const std::string& in) { return yes_or_no(is_article(in)); }},
    {"tree", tree},
    {"denied", denied},
    {"closes", of_first_part([](const Syntax& syntax, const SyntaxNode* first) {
         return closes_phrase(syntax, first, false);
     })},
    {"no_article", of_first_part([](const Syntax& syntax, const SyntaxNode*) {
         return takes_no_article(syntax, 0);
     })},
    {"optional_noun", of_first_part(is_optional_noun)},
    {"than", of_first_part(begins_with_than)},
    {"words", [](TableScene&, const std::string& in) { return spaced(words_of(in)); }},
    {"between_blanks", [](TableScene&, const std::string& in) { return words_between_blanks(in); }},
    {"without_blanks",
     [](TableScene&, const std::string& in) { return std::string(without_blanks(in)); }}};

}  // namespace

TEST_CASE("template: what is said to a template is taken as the tables say") {
    hold_tables("template", kTemplateProbes);
}
