// The program that lesson processes are in tests: it does what the real one's main() does first. With --write-meta FOLDER it writes
// the generated annotations and reference instead.
#include "runtime/lua/api/binding_table.h"
#include "runtime/lua/process/lesson_process.h"
#include "tests/unit/runtime/lua/library_texts.h"

#include <cstdio>
#include <fstream>
#include <string>

int main(int argc, char** argv) {
    if (const auto socket = fulcrum::runtime::lesson_process_socket(argc, argv)) {
        return fulcrum::runtime::lesson_process_main(*socket);
    }
    if (argc == 3 && std::string(argv[1]) == "--write-meta") {
        const std::string folder = argv[2];
        std::ofstream(folder + "/fulcrum.lua")
            << fulcrum::runtime::make_annotations(fulcrum::runtime::api_table());
        std::ofstream(folder + "/reference.md") << fulcrum::runtime::make_reference(
            fulcrum::runtime::api_table(),
            fulcrum::runtime::test::read_library(folder + "/../lib"));
        return 0;
    }
    std::fputs("this is a part of the tests; --write-meta FOLDER writes scripts/meta\n", stderr);
    return 2;
}
