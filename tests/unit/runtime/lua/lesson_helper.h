// The program that plays a lesson's process in these tests: it lies beside the tests' own.
#pragma once

#include <filesystem>
#include <string>

namespace fulcrum::runtime::test {

inline std::string lesson_helper() {
    return std::filesystem::read_symlink("/proc/self/exe").parent_path() / "lesson_process_helper";
}

}  // namespace fulcrum::runtime::test
