#include "runtime/files/run_program.h"

#include "haptics/base/clock.h"

#include <catch2/catch.hpp>

#include <chrono>
#include <thread>

using namespace fulcrum;
using namespace fulcrum::runtime;

namespace {

constexpr std::size_t kPlenty = 1'000'000;
constexpr double kPatience_s = 20.0;

Expected<std::string> run_shell(const std::string& script, double most_s = kPatience_s,
                                std::size_t most_bytes = kPlenty) {
    const std::atomic<bool> never{false};
    return run_program({{"sh", "-c", script}, most_bytes, most_s}, never);
}

std::string refusal(const Expected<std::string>& answer) {
    REQUIRE_FALSE(answer);
    return to_sentence(answer.error());
}

}  // namespace

TEST_CASE("run program: gives every byte that it wrote, and its words arrive as they are") {
    const std::atomic<bool> never{false};
    const auto said =
        run_program({{"printf", "%s|%s", "a b; $(rm x)", "\"*\""}, kPlenty, 5.0}, never);
    REQUIRE(said);
    CHECK(*said == "a b; $(rm x)|\"*\"");
    const auto many = run_shell("head -c 300000 /dev/zero");
    REQUIRE(many);
    CHECK(many->size() == 300'000);
    CHECK(run_shell("cat; echo heard nothing >&2").value().empty());
}

TEST_CASE(
    "run program: what is missing, fails, writes too much or takes too long is one sentence") {
    const std::atomic<bool> never{false};
    CHECK(refusal(run_program({{"no_such_program_1"}, kPlenty, 5.0}, never))
              .find("the program no_such_program_1 can't be started") == 0);
    CHECK(refusal(run_program({{}, kPlenty, 5.0}, never)).find("no program is named") == 0);
    CHECK(refusal(run_shell("echo x; exit 3")).find("the program sh failed") == 0);
    CHECK(refusal(run_shell("kill -9 $$")).find("failed") != std::string::npos);
    CHECK(refusal(run_shell("yes", kPatience_s, 1000)).find("wrote more than 1000") !=
          std::string::npos);
    const double begun_s = monotonic_now_s();
    CHECK(refusal(run_shell("sleep 100", 0.1)).find("took too long") != std::string::npos);
    // Who closes his output and goes on is not waited for either.
    CHECK(refusal(run_shell("exec >&-; sleep 100", 0.3)).find("failed") != std::string::npos);
    CHECK(monotonic_now_s() - begun_s < 0.5 * kPatience_s);
}

TEST_CASE("run program: ends with all that it started as soon as nobody waits") {
    std::atomic<bool> cancelled{false};
    std::thread canceller([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        cancelled = true;
    });
    const double begun_s = monotonic_now_s();
    const auto answer =
        run_program({{"sh", "-c", "sleep 100 & sleep 100"}, kPlenty, 100.0}, cancelled);
    canceller.join();
    CHECK(refusal(answer).find("was stopped") != std::string::npos);
    CHECK(monotonic_now_s() - begun_s < kPatience_s);
}
