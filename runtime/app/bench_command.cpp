#include "runtime/app/bench_command.h"

#include "runtime/app/installation.h"

#include <filesystem>
#include <unistd.h>
#include <vector>

namespace fulcrum::runtime {

int bench_command(std::span<const std::string> words) {
    std::error_code error;
    const auto here = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
    const std::string program = here / "fulcrum-bench";
    std::vector<std::string> text{program};
    text.insert(text.end(), words.begin(), words.end());
    std::vector<char*> arguments;
    arguments.reserve(text.size() + 1);
    for (std::string& word : text) {
        arguments.push_back(word.data());
    }
    arguments.push_back(nullptr);
    ::execv(program.c_str(), arguments.data());
    return complain({"the benchmarks are not built here", program,
                     "start them with ./fulcrum bench, which builds them"},
                    2);
}

}  // namespace fulcrum::runtime
