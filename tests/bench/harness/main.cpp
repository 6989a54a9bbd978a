// fulcrum bench: runs the registered benchmarks and writes what they found as CSV, SVG and one page.
#include "runtime/lua/process/lesson_process.h"
#include "runtime/text/progress_line.h"
#include "tests/bench/harness/csv.h"
#include "tests/bench/harness/environment.h"
#include "tests/bench/harness/options.h"
#include "tests/bench/harness/page.h"
#include "tests/bench/harness/registry.h"
#include "tests/bench/harness/svg.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace fulcrum::bench {
namespace {

namespace fs = std::filesystem;

int complain(const Error& error) {
    std::fprintf(stderr, "%s\n", to_sentence(error).c_str());
    return 2;
}

// Whole or not at all: a full disk leaves what was there before.
Expected<void> write_file(const fs::path& path, const std::string& text) {
    fs::path half = path;
    half += ".part";
    std::ofstream file(half, std::ios::binary);
    file << text;
    file.close();
    std::error_code error;
    if (file) {
        fs::rename(half, path, error);
    }
    if (!file || error) {
        std::error_code ignored;
        fs::remove(half, ignored);
        return fail("the file cannot be written", path.string(),
                    "make room there, or choose another folder");
    }
    return {};
}

// The figure is drawn from the file, as anybody draws it again, and not from numbers that only this run had.
Expected<void> write_exhibit(const fs::path& folder, Exhibit& exhibit,
                             const Environment& environment) {
    const fs::path file = folder / (name_of(exhibit) + ".csv");
    const std::string text = to_csv(exhibit, environment);
    auto kept = read_csv(text, file.string());
    if (!kept) {
        return tl::unexpected(kept.error());
    }
    exhibit = std::move(*kept);
    const std::string picture = draw_svg(exhibit);
    return write_file(file, text).and_then([&] {
        return picture.empty() ? Expected<void>{}
                               : write_file(folder / (name_of(exhibit) + ".svg"), picture);
    });
}

Expected<void> draw_again(const std::string& name) {
    constexpr std::uintmax_t kMostBytes = 64U << 20U;  // ours are below one
    std::error_code error;
    const bool readable =
        fs::is_regular_file(name, error) && fs::file_size(name, error) <= kMostBytes;
    std::ifstream file(name, std::ios::binary);
    const std::string text = readable ? std::string{std::istreambuf_iterator<char>(file), {}} : "";
    if (!file || !readable) {
        return fail("the file cannot be read", name, "give a CSV file that fulcrum bench wrote");
    }
    return read_csv(text, name).and_then([&](const Exhibit& exhibit) -> Expected<void> {
        if (std::holds_alternative<Sheet>(exhibit)) {
            return fail("a table has no figure", name, "give the file of a curve or a chart");
        }
        return write_file(fs::path(name).replace_extension(".svg"), draw_svg(exhibit));
    });
}

// One moving line on a terminal, else a line a benchmark.
class Progress {
  public:
    Progress(std::size_t index, std::size_t count, const Bench& bench)
        : label_("[" + std::to_string(index + 1) + "/" + std::to_string(count) + "] " + bench.name),
          line_(label_, {.after_s = 0.0}) {
        if (!line_.is_on_terminal()) {
            std::fprintf(stderr, "%s …\n", label_.c_str());
        }
        say(0.0, bench.what);
    }
    void say(double share, const std::string& what) { line_.say(share, what); }
    void done() {
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began_;
        line_.clear();
        std::fprintf(stderr, "%s: %.1f s\n", label_.c_str(), took.count());
    }

  private:
    std::string label_;
    runtime::ProgressLine line_;
    std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
};

void join_peer(const Peer& peer, Run& run, CostCurve& curve) {
    std::ranges::copy(peer.points(run), std::back_inserter(curve.points));
    // Peers of one kind carry one note.
    if (curve.work.find(peer.note) == std::string::npos) {
        curve.work += ". " + peer.note;
    }
}

// Lets the peers join the curve or sheet that carries their name.
void join_peers(Exhibit& exhibit, Run& run) {
    auto* const curve = std::get_if<CostCurve>(&exhibit);
    auto* const sheet = std::get_if<Sheet>(&exhibit);
    for (const Peer& peer : all_peers()) {
        if (peer.curve != name_of(exhibit)) {
            continue;
        }
        run.progress(1.0, peer.name);
        if (curve != nullptr && peer.points) {
            join_peer(peer, run, *curve);
        }
        if (sheet != nullptr && peer.rows) {
            std::ranges::copy(peer.rows(run), std::back_inserter(sheet->rows));
        }
    }
}

// Which other libraries stand on these exhibits' axes, and which could not.
std::vector<std::string> describe_peers(const Report& exhibits) {
    std::vector<std::string> names;
    for (const Peer& peer : all_peers()) {
        const bool joined = std::ranges::any_of(
            exhibits, [&](const Exhibit& exhibit) { return name_of(exhibit) == peer.curve; });
        if (joined && (names.empty() || names.back() != peer.name)) {
            names.push_back(peer.name);
        }
    }
    std::string built;
    for (const std::string& name : names) {
        built += (built.empty() ? "" : ", ") + name;
    }
    const std::string missing = FULCRUM_MISSING_PEERS;
    std::vector<std::string> sentences;
    if (!built.empty()) {
        sentences.push_back("Measured beside ours in the same run: " + built + ".");
    }
    if (!missing.empty()) {
        sentences.push_back(
            "Not measured, for they were not installed or not asked for when this was built: " +
            missing + "; packages-peers.txt names their packages.");
    }
    return sentences;
}

// What a reader of the page must know first: above all that it is not all of it yet.
std::vector<std::string> describe_run(const Report& exhibits, std::size_t n_done,
                                      std::size_t n_chosen) {
    std::vector<std::string> sentences = describe_peers(exhibits);
    if (n_done < n_chosen) {
        sentences.insert(sentences.begin(),
                         "Not all of it: " + std::to_string(n_done) + " of " +
                             std::to_string(n_chosen) +
                             " benchmarks had been measured when this was written.");
    }
    return sentences;
}

Expected<void> run_all(const BenchOptions& options, const Environment& environment) {
    std::error_code error;
    fs::create_directories(options.out, error);
    if (error) {
        return fail("the folder cannot be made: " + error.message(), options.out,
                    "choose another with --out");
    }
    std::vector<const Bench*> chosen;
    for (const Bench& bench : all_benches()) {
        if (options.names.empty() ||
            std::ranges::find(options.names, bench.name) != options.names.end()) {
            chosen.push_back(&bench);
        }
    }
    const fs::path page = fs::path(options.out) / "index.html";
    Report exhibits;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        Progress progress(i, chosen.size(), *chosen[i]);
        Run run(
            options.quick,
            [&](double share, const std::string& what) { progress.say(share, what); }, options.mesh,
            options.tool, options.text);
        for (Exhibit& exhibit : chosen[i]->run(run)) {
            join_peers(exhibit, run);
            // At once: a run that is broken off leaves what it has.
            if (const auto written = write_exhibit(options.out, exhibit, environment); !written) {
                return written;
            }
            exhibits.push_back(std::move(exhibit));
        }
        // After each: a run that is broken off leaves a page of what it has.
        if (const auto written = write_file(
                page,
                make_page(exhibits, environment, describe_run(exhibits, i + 1, chosen.size())));
            !written) {
            return written;
        }
        progress.done();
    }
    std::printf("%s\n", page.c_str());
    return {};
}

int run_program(std::span<const std::string> words) {
    std::vector<std::string> known;
    for (const Bench& bench : all_benches()) {
        known.push_back(bench.name);
    }
    const auto options = parse_bench_options(words, known);
    if (!options) {
        return complain(options.error());
    }
    if (options->help) {
        std::fputs(bench_usage().c_str(), stdout);
        return 0;
    }
    if (options->list) {
        for (const Bench& bench : all_benches()) {
            std::printf("%-24s %s\n", bench.name.c_str(), bench.what.c_str());
        }
        return 0;
    }
    for (const std::string& file : options->draw) {
        if (const auto drawn = draw_again(file); !drawn) {
            return complain(drawn.error());
        }
    }
    if (!options->draw.empty()) {
        return 0;
    }
    std::string command = "fulcrum bench";
    for (const std::string& word : words) {
        command += " " + word;
    }
    const auto done = run_all(*options, find_environment(command));
    return done ? 0 : complain(done.error());
}

}  // namespace
}  // namespace fulcrum::bench

int main(int argc, char** argv) {
    // A benchmark that plays a lesson starts this program again as the lesson's process.
    if (const auto socket = fulcrum::runtime::lesson_process_socket(argc, argv)) {
        return fulcrum::runtime::lesson_process_main(*socket);
    }
    try {
        const int code =
            fulcrum::bench::run_program(std::vector<std::string>(argv + 1, argv + argc));
        if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
            std::fputs("standard output could not be written; make room there.\n", stderr);
            return 2;
        }
        return code;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "The benchmarks cannot go on: %s.\n", error.what());
        return 2;
    }
}
