// A program that is there to be killed: writes records FIRST, FIRST+1, … of a workload to a database and says each number
// on its standard output as soon as it is acknowledged.
//
//   progress_writer DATABASE SEED RECORDS FIRST
#include "runtime/progress/sqlite/sqlite_store.h"
#include "tests/system/progress/workload.h"

#include <cstdio>
#include <cstdlib>
#include <string>
#include <unistd.h>

int main(int count, char** arguments) {
    using namespace fulcrum;
    if (count != 5) {
        std::fprintf(stderr, "usage: progress_writer DATABASE SEED RECORDS FIRST\n");
        return 2;
    }
    const auto number_of = [&](int i) { return std::strtoll(arguments[i], nullptr, 10); };
    const runtime::test::Workload work(static_cast<std::uint64_t>(number_of(2)), number_of(3));
    const auto store = runtime::open_sqlite_store(arguments[1]);
    if (!store) {
        std::fprintf(stderr, "%s\n", to_sentence(store.error()).c_str());
        return 1;
    }
    for (std::int64_t number = number_of(4); number < work.records(); ++number) {
        if (const auto kept = work.write(**store, number); !kept) {
            std::fprintf(stderr, "%s\n", to_sentence(kept.error()).c_str());
            return 1;
        }
        // One small write is whole or not there, so a killed writer never says half a number.
        const std::string line = std::to_string(number) + "\n";
        if (write(STDOUT_FILENO, line.data(), line.size()) != static_cast<ssize_t>(line.size())) {
            return 1;
        }
    }
    return 0;
}
