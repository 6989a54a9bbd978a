#include "tests/bench/harness/options.h"

#include <algorithm>
#include <map>

namespace fulcrum::bench {
namespace {

// A word names every benchmark that begins with it up to a hyphen: "integrators" means all four of them.
bool names(const std::string& word, const std::string& bench) {
    return bench == word || bench.starts_with(word + "-");
}

std::string listing(std::span<const std::string> known) {
    std::string text;
    for (const std::string& name : known) {
        text += (text.empty() ? "" : ", ") + name;
    }
    return text;
}

}  // namespace

Expected<BenchOptions> parse_bench_options(std::span<const std::string> words,
                                           std::span<const std::string> known) {
    BenchOptions options;
    const std::map<std::string, std::string*> values{{"--out", &options.out},
                                                     {"--mesh", &options.mesh},
                                                     {"--tool", &options.tool},
                                                     {"--text", &options.text}};
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string& word = words[i];
        if (word == "--quick") {
            options.quick = true;
        } else if (word == "--list") {
            options.list = true;
        } else if (word == "--help") {
            options.help = true;
        } else if (const auto value = values.find(word);
                   value != values.end() || word == "--draw") {
            if (i + 1 == words.size()) {
                return fail(word + " needs a value", {}, "see fulcrum bench --help");
            }
            ++i;
            if (value != values.end()) {
                *value->second = words[i];
            } else {
                options.draw.push_back(words[i]);
            }
        } else if (word.starts_with("--")) {
            return fail("the option " + word + " is not known", {}, "see fulcrum bench --help");
        } else {
            const auto before = options.names.size();
            std::ranges::copy_if(known, std::back_inserter(options.names),
                                 [&](const std::string& name) { return names(word, name); });
            if (options.names.size() == before) {
                return fail("there is no benchmark \"" + word + "\"", {},
                            "choose among " + listing(known));
            }
        }
    }
    return options;
}

std::string bench_usage() {
    return R"(What accuracy costs in time.

  fulcrum bench [NAME…]      measures all benchmarks, or those named, and draws error against time
      --out DIR              where CSV, SVG and index.html are written (bench-results)
      --quick                a rough answer: fewer settings, fewer repetitions
      --mesh FILE            an OBJ, GLB or glTF file of your own, for those that take one: snags, field-accuracy, god-object-step
      --tool FILE            another, for what touches it: field-accuracy
      --text FILE            a table of learners' sentences, for english
      --list                 what there is
      --draw FILE.csv        draws a figure again from its file, beside it; measures nothing
)";
}

}  // namespace fulcrum::bench
