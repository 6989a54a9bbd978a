// What understanding an answer costs: compiling a question, marking right and wrong answers, and the same against a plain
// list of all sentences that the templates make, which is what a graph is to beat.
//
//   bench_dialogue > dialogue.csv
#include "dialogue/marking/mark.h"
#include "dialogue/template/matcher.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

using namespace fulcrum::dialogue;

namespace {

constexpr int kWarmUp = 50;
constexpr int kRuns = 1000;

struct Times {
    double p50_us, p99_us, max_us;
};

template <class Work>
Times measure(const Work& work) {
    std::vector<double> times_us;
    for (int run = -kWarmUp; run < kRuns; ++run) {
        const auto start = std::chrono::steady_clock::now();
        work();
        const std::chrono::duration<double, std::micro> taken =
            std::chrono::steady_clock::now() - start;
        if (run >= 0) {
            times_us.push_back(taken.count());
        }
    }
    std::sort(times_us.begin(), times_us.end());
    return {times_us[kRuns / 2], times_us[kRuns * 99 / 100], times_us.back()};
}

void print(const char* what, const Times& times, double size) {
    std::printf("%s,%.2f,%.2f,%.2f,%.0f\n", what, times.p50_us, times.p99_us, times.max_us, size);
}

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

void bench(const char* name, const QuestionSource& source,
           const std::vector<std::string>& answers) {
    const auto question = compile_question(source);
    if (!question) {
        std::printf("# %s: %s\n", name, question.error().message.c_str());
        return;
    }
    std::printf("# %s: %zu arcs stand for %.3g sentences\n", name, count_arcs(*question->templates),
                count_sentences(question->templates->graphs[0]));
    print((std::string(name) + " compile").c_str(),
          measure([&] { (void)compile_question(source); }),
          static_cast<double>(count_arcs(*question->templates)));
    for (const std::string& answer : answers) {
        MatchWork work;
        (void)match(*question->templates, answer, &work);
        const Times times = measure([&] { (void)mark_answer(*question, answer); });
        print((std::string(name) + " mark: " + answer).c_str(), times,
              static_cast<double>(work.steps));
    }
}

}  // namespace

int main() {
    std::printf(
        "# %d runs after %d; the last column: arcs of a compiled question, steps of a match, "
        "sentences of a list\n",
        kRuns, kWarmUp);
    std::printf("what,p50_us,p99_us,max_us,size\n");
    bench("four fruits", fruit_question(),
          {"a watermelon is the heaviest", "watermelon is most heavy", "watermellon is teh heavist",
           "what is that"});
    bench("sixty things", large_question(),
          {"a thingaa is heavier than a thingba", "thingaa more heavy then thingba"});

    // The list: all sentences of the fruit question, searched from front to back; it mends no spelling.
    const auto question = compile_question(fruit_question());
    const TemplateSet& set = *question->templates;
    std::vector<std::string> list;
    list_sentences(set, set.graphs[0], 0, "", list);
    const std::string said = "watermelon is most heavy ";
    bool found = false;
    const Times plain =
        measure([&] { found = std::find(list.begin(), list.end(), said) != list.end(); });
    print("four fruits list: watermelon is most heavy", plain, static_cast<double>(list.size()));
    const Times graph = measure([&] { (void)match(set, said); });
    std::printf("# found %d; graph / list: %.2f of the time\n", found ? 1 : 0,
                graph.p50_us / plain.p50_us);
    return 0;
}
