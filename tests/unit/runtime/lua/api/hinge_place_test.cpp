#include "haptics/dynamics/axle.h"
#include "tests/unit/runtime/lua/hosted_lesson.h"

#include <catch2/catch.hpp>

#include <sstream>

namespace fulcrum::runtime {
namespace {

using test::HostedLesson;

std::string hinged(const std::string& hinge) {
    return "local door = world:body { name = 'door', solid = true, at = { 10, 0, 0 },\n"
           "hinge = { axis = { 0, 1, 0 }, inertia = 1, " +
           hinge + " } }\n";
}

std::string too_far(const std::string& what, int line) {
    return "lesson.lua:" + std::to_string(line) + ": the " + what +
           " of door is farther than 100 m from it; give a place nearer to where door is declared.";
}

TEST_CASE("hinge place: a hinge or a load out of its body's reach is told at its line") {
    const auto refusal = [](const std::string& hinge) {
        return HostedLesson().start(hinged(hinge));
    };
    // From the body, not from the middle of the scene; as far as a line reaches, not along each axis.
    CHECK(refusal("at = { 110, 0, 0 }").empty());
    CHECK(refusal("load_at = { -90, 0, 0 }").empty());
    CHECK(refusal("at = { 110.01, 0, 0 }") == too_far("hinge", 2));
    CHECK(refusal("at = { 90, 80, 0 }") == too_far("hinge", 2));
    CHECK(refusal("at = { -95, 0, 0 }") == too_far("hinge", 2));
    CHECK(refusal("load_at = { 10, 0, -150 }") == too_far("load", 2));
}

TEST_CASE("hinge place: an order of one out of reach is told at its line, and not dropped") {
    const auto turned = [](const std::string& at) {
        return HostedLesson().start(hinged("") + "door:turn { at = " + at + ", load = 5 }");
    };
    CHECK(turned("{ 110, 0, 0 }").empty());
    CHECK(turned("{ 5000, 0, 0 }") == too_far("hinge", 4));
    CHECK(turned("{ 90, 80, 0 }") == too_far("hinge", 4));
}

TEST_CASE("hinge place: the reference says how far one may be") {
    std::ostringstream limit;
    limit << "at most " << kFarthestOnAxle_m << " m from ";
    std::size_t n_told = 0;
    for (const Binding& binding : api_table().functions) {
        for (const Parameter& parameter : binding.parameters) {
            n_told += std::string(parameter.text).find(limit.str()) != std::string::npos ? 1 : 0;
            for (std::size_t i = 0; i < parameter.n_fields; ++i) {
                n_told +=
                    std::string(parameter.fields[i].text).find(limit.str()) != std::string::npos
                        ? 1
                        : 0;
            }
        }
    }
    CHECK(n_told == 3);
}

}  // namespace
}  // namespace fulcrum::runtime
