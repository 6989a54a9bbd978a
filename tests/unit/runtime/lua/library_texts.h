// The modules of scripts/lib as texts, for the reference.
#pragma once

#include "runtime/lua/api/reference_sections.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace fulcrum::runtime::test {

/// Every .lua file of the folder, in alphabetical order.
inline std::vector<LibraryModule> read_library(const std::string& folder) {
    std::vector<LibraryModule> modules;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() == ".lua") {
            std::ifstream file(entry.path(), std::ios::binary);
            modules.push_back(
                {entry.path().stem().string(), {std::istreambuf_iterator<char>(file), {}}});
        }
    }
    std::sort(modules.begin(), modules.end(),
              [](const auto& a, const auto& b) { return a.name < b.name; });
    return modules;
}

}  // namespace fulcrum::runtime::test
