// What the benchmark program was asked for.
#pragma once

#include "haptics/base/error.h"

#include <span>
#include <string>
#include <vector>

namespace fulcrum::bench {

struct BenchOptions {
    std::vector<std::string> names;  ///< of benchmarks; empty: all
    std::vector<std::string> draw;   ///< CSV files to draw again, instead of running anything
    std::string out = "bench-results";
    std::string mesh;  ///< an OBJ or GLB file for benchmarks that take one; empty: their own shapes
    std::string tool;  ///< another, for what touches it
    std::string text;  ///< a table of learners' sentences, for benchmarks of English
    bool quick = false;
    bool list = false;
    bool help = false;
};

/// Reads the words after the program's name. Refuses an unknown option or benchmark, naming those there are.
[[nodiscard]] Expected<BenchOptions> parse_bench_options(std::span<const std::string> words,
                                                         std::span<const std::string> known);

/// What `--help` prints.
[[nodiscard]] std::string bench_usage();

}  // namespace fulcrum::bench
