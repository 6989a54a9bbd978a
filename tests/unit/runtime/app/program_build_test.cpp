#include "runtime/app/program_build.h"

#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

// The linker writes the id into the file itself, so it stands there byte for byte.
TEST_CASE("program build: the id is the one that the linker wrote into this program's file") {
    const std::string id = program_build_id();
    INFO(id);
    REQUIRE(id.size() >= 32);
    REQUIRE(id.find_first_not_of("0123456789abcdef") == std::string::npos);
    std::string bytes;
    for (std::size_t i = 0; i < id.size(); i += 2) {
        bytes += static_cast<char>(std::stoi(id.substr(i, 2), nullptr, 16));
    }
    std::ifstream file("/proc/self/exe", std::ios::binary);
    const std::string program{std::istreambuf_iterator<char>(file), {}};
    check_says(program, {bytes});
}
