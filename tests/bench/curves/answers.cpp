// What understanding an answer costs: compiling a question, marking right and wrong answers, and the same against a plain
// list of all sentences that the templates make, which is what a graph is to beat.
#include "dialogue/marking/mark_answer.h"
#include "dialogue/template/matcher.h"
#include "tests/bench/harness/curve.h"

namespace fulcrum::bench {
namespace {

using namespace fulcrum::dialogue;

QuestionSource fruit_question() {
    return {"heaviest",
            "Which one is the heaviest?",
            {"[a|an|the] {thing} is the <superlative:heavy> [one|object|fruit]"},
            {{"thing", {"watermelon", "apple", "banana", "egg"}}}};
}

/// 60 things, compared with each other.
QuestionSource large_question() {
    QuestionSource source{"heavier",
                          "Which one is heavier?",
                          {"<article> {thing} is <comparative:heavy> than <article> {thing:other}"},
                          {{"thing", {}}}};
    for (int i = 0; i < 60; ++i) {
        source.lists[0].second.push_back("thing" + std::string(1, static_cast<char>('a' + i / 26)) +
                                         std::string(1, static_cast<char>('a' + i % 26)));
    }
    return source;
}

std::size_t count_arcs(const TemplateSet& set) {
    std::size_t arcs = 0;
    for (const Graph& graph : set.graphs) {
        arcs += graph.arcs.size();
    }
    return arcs;
}

/// How many sentences a graph stands for: paths from start to end.
double count_sentences(const Graph& graph) {
    std::vector<double> paths(static_cast<std::size_t>(graph.nodes()), 0.0);
    paths[0] = 1.0;
    for (const Arc& arc : graph.arcs) {
        paths[static_cast<std::size_t>(arc.to)] += paths[static_cast<std::size_t>(arc.from)];
    }
    return paths.back();
}

/// All sentences of the graph, by walking every path.
void list_sentences(const TemplateSet& set, const Graph& graph, int node, std::string said,
                    std::vector<std::string>& list) {
    if (node == graph.end()) {
        list.push_back(std::move(said));
        return;
    }
    for (const Arc& arc : graph.arcs_from(node)) {
        std::string longer = said;
        for (const int word : graph.said_by(arc)) {
            longer += set.words.text(word) + " ";
        }
        list_sentences(set, graph, arc.to, std::move(longer), list);
    }
}

// Rows of the sheet: what was done, to how large a thing, and its time.
class Rows {
  public:
    Rows(Sheet& sheet, const Timing& timing) : sheet_(sheet), timing_(timing) {}

    template <class Work>
    Cost add(const std::string& what, double size, const std::string& of, const Work& work) {
        const Cost cost = measure_cost(work, timing_);
        sheet_.add({what, cost.median_us, cost.p99_us, size, of});
        return cost;
    }

  private:
    Sheet& sheet_;
    Timing timing_;
};

void measure_question(Rows& rows, const std::string& name, const QuestionSource& source,
                      const std::vector<std::string>& answers) {
    const Question question = must(compile_question(source));
    const TemplateSet& set = *question.templates;
    rows.add(name + ": compile", static_cast<double>(count_arcs(set)),
             "arcs, for " + to_text(count_sentences(set.graphs[0])) + " sentences",
             [&] { keep(compile_question(source)); });
    for (const std::string& answer : answers) {
        MatchWork work;
        (void)match(set, answer, &work);
        rows.add(name + ": " + answer, static_cast<double>(work.steps), "steps of the match",
                 [&] { keep(mark_answer(question, answer)); });
    }
}

// All sentences of the fruit question, searched from front to back; it mends no spelling.
void measure_list(Rows& rows) {
    const Question question = must(compile_question(fruit_question()));
    const TemplateSet& set = *question.templates;
    std::vector<std::string> list;
    list_sentences(set, set.graphs[0], 0, "", list);
    const std::string said = "watermelon is most heavy ";
    rows.add("four fruits, a plain list: " + said, static_cast<double>(list.size()), "sentences",
             [&] { keep(std::find(list.begin(), list.end(), said)); });
    rows.add("four fruits, the graph: " + said, static_cast<double>(count_arcs(set)), "arcs",
             [&] { keep(match(set, said)); });
}

Report run_answers(Run& run) {
    Sheet sheet{
        "answers",
        "Understanding an answer",
        "Questions are compiled, right and wrong answers marked with spelling and grammar mended, "
        "each timed on its own.",
        "Name as many things in a question as the lesson has: time follows the graph's arcs, not "
        "the sentences they stand for.",
        {"what", "median us", "99 % us", "size", "of"}};
    Rows rows(sheet, {run.pick(1000, 50), 1, 20});
    measure_question(rows, "four fruits", fruit_question(),
                     {"a watermelon is the heaviest", "watermelon is most heavy",
                      "watermellon is teh heavist", "what is that"});
    run.progress(0.3);
    measure_question(rows, "sixty things", large_question(),
                     {"a thingaa is heavier than a thingba", "thingaa more heavy then thingba"});
    run.progress(0.8);
    measure_list(rows);
    return {sheet};
}

const Registration kAnswers{{"answers", "compiling a question and marking an answer", run_answers}};

}  // namespace
}  // namespace fulcrum::bench
