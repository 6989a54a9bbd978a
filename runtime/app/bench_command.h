// fulcrum bench: hands over to the program of benchmarks, which lies beside this one.
#pragma once

#include <span>
#include <string>

namespace fulcrum::runtime {

/// Becomes that program with the words after "bench"; returns an exit code only where it has not been built.
[[nodiscard]] int bench_command(std::span<const std::string> words);

}  // namespace fulcrum::runtime
