#include "tests/bench/harness/options.h"

#include <catch2/catch.hpp>

namespace fulcrum::bench {
namespace {

const std::vector<std::string> kKnown{"integrators-free", "integrators-wall", "stability"};

Expected<BenchOptions> parse(const std::vector<std::string>& words) {
    return parse_bench_options(words, kKnown);
}

TEST_CASE("bench options: a name, the first part of several names, or none for all") {
    CHECK(parse({})->names.empty());
    CHECK(parse({"stability"})->names == std::vector<std::string>{"stability"});
    CHECK(parse({"integrators", "--quick"})->names ==
          std::vector<std::string>{"integrators-free", "integrators-wall"});
    CHECK(parse({"integrators", "--quick"})->quick);
}

TEST_CASE("bench options: out, mesh and draw take their values") {
    const auto options = parse({"--out", "there", "--draw", "a.csv", "--draw", "b.csv", "--mesh",
                                "bunny.obj", "--tool", "teapot.glb", "--text", "learners.tsv"});
    REQUIRE(options);
    CHECK(options->mesh == "bunny.obj");
    CHECK(options->tool == "teapot.glb");
    CHECK(options->text == "learners.tsv");
    CHECK(options->out == "there");
    CHECK(options->draw == std::vector<std::string>{"a.csv", "b.csv"});
}

TEST_CASE("bench options: what is not known is refused in a sentence that helps") {
    const auto unknown = parse({"stabilty"});
    REQUIRE_FALSE(unknown);
    CHECK(unknown.error().what_to_do.find("stability") != std::string::npos);
    CHECK_FALSE(parse({"integ"}));
    CHECK_FALSE(parse({"--fast"}));
    CHECK_FALSE(parse({"--out"}));
    CHECK_FALSE(parse({"--mesh"}));
    CHECK_FALSE(parse({"--tool"}));
    CHECK_FALSE(parse({"--text"}));
}

}  // namespace
}  // namespace fulcrum::bench
