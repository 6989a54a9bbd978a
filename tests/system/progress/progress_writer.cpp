// A program that is there to be killed: writes records FIRST, FIRST+1, … of a workload to a database and says each number
// on its standard output as soon as it is acknowledged.
//
//   progress_writer DATABASE SEED RECORDS FIRST [queued]
//
// With "queued" the records are handed to a store thread, many at a time, and a number is said when that thread counts it
// as kept.
#include "runtime/progress/queued_store.h"
#include "runtime/progress/sqlite/sqlite_store.h"
#include "tests/system/progress/workload.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <unistd.h>
#include <utility>

namespace {

using namespace fulcrum;
using runtime::test::Workload;

// One small write is whole or not there, so a killed writer never says half a number.
bool say(std::int64_t number) {
    const std::string line = std::to_string(number) + "\n";
    return write(STDOUT_FILENO, line.data(), line.size()) == static_cast<ssize_t>(line.size());
}

int complain(const Error& error) {
    std::fprintf(stderr, "%s\n", to_sentence(error).c_str());
    return 1;
}

int write_one_by_one(runtime::ProgressStore& store, const Workload& work, std::int64_t first) {
    for (std::int64_t number = first; number < work.records(); ++number) {
        if (const auto kept = work.write(store, number); !kept) {
            return complain(kept.error());
        }
        if (!say(number)) {
            return 1;
        }
    }
    return 0;
}

int hand_over(runtime::QueuedStore& store, const Workload& work, std::int64_t first) {
    constexpr std::uint64_t kMostWaiting = 64;
    std::int64_t next_said = first;
    const auto say_kept = [&] {
        const auto kept_before = first + static_cast<std::int64_t>(store.status().kept);
        while (next_said < kept_before && say(next_said)) {
            ++next_said;
        }
        return next_said == kept_before;
    };
    for (std::int64_t number = first; number < work.records(); ++number) {
        if (const auto taken = work.write(store, number); !taken) {
            return complain(taken.error());
        }
        do {
            if (!say_kept()) {
                return 1;
            }
            if (const auto trouble = store.take_trouble()) {
                return complain(*trouble);
            }
        } while (store.status().taken - store.status().kept > kMostWaiting);
    }
    if (const auto settled = store.settle(600.0); !settled) {
        return complain(settled.error());
    }
    return say_kept() ? 0 : 1;
}

}  // namespace

int main(int count, char** arguments) {
    if (count != 5 && count != 6) {
        std::fprintf(stderr, "usage: progress_writer DATABASE SEED RECORDS FIRST [queued]\n");
        return 2;
    }
    const auto number_of = [&](int i) { return std::strtoll(arguments[i], nullptr, 10); };
    const Workload work(static_cast<std::uint64_t>(number_of(2)), number_of(3));
    auto store = runtime::open_sqlite_store(arguments[1]);
    if (!store) {
        return complain(store.error());
    }
    if (count == 6) {
        runtime::QueuedStore queued(std::move(*store));
        return hand_over(queued, work, number_of(4));
    }
    return write_one_by_one(**store, work, number_of(4));
}
