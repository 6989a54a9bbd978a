#include "runtime/arms/haply/haply_command.h"

#include <catch2/catch.hpp>

#include <limits>

namespace fulcrum::runtime {
namespace {

std::string command(const Vector3& force_A, ForceWord word = ForceWord::vector,
                    bool wants_all = false) {
    std::string text = "what was there";
    write_haply_command("049D", word, force_A, wants_all, text);
    return text;
}

}  // namespace

TEST_CASE("haply command: a force as the documents have it, by either word, never by both") {
    CHECK(
        command({0.5, -1.25, 3.0}) ==
        R"({"inverse3":[{"device_id":"049D","commands":{"set_cursor_force":{"vector":{"x":0.500000,"y":-1.250000,"z":3.000000}}}}]})");
    CHECK(
        command(Vector3::Zero(), ForceWord::values) ==
        R"({"inverse3":[{"device_id":"049D","commands":{"set_cursor_force":{"values":{"x":0.000000,"y":0.000000,"z":0.000000}}}}]})");
    CHECK(command(Vector3::Zero(), ForceWord::vector, true)
              .starts_with(R"({"session":{"force_render_full_state":{}},"inverse3":[)"));
}

TEST_CASE("haply command: what is no number goes as zero, what is huge or tiny without exponent") {
    const double none = std::numeric_limits<double>::quiet_NaN();
    const double endless = std::numeric_limits<double>::infinity();
    CHECK(command({none, 1.0, 1.0}) == command(Vector3::Zero()));
    CHECK(command({1.0, endless, 1.0}) == command(Vector3::Zero()));
    CHECK(command({1.0e-30, 1.0e30, 0.0}) == command({0.0, 1000.0, 0.0}));
}

TEST_CASE("haply command: the word by the version; what is not known has none") {
    for (const char* now : {"3.5.0", "v3.5.1", "3.6.2-4-gabc", "3.10.0", "3.5.0.0"}) {
        CAPTURE(now);
        CHECK(choose_force_word(now) == ForceWord::vector);
    }
    for (const char* then : {"3.1.1", "v3.4.8", "3.4.8-2-gce34c39e", "3.3.2.0"}) {
        CAPTURE(then);
        CHECK(choose_force_word(then) == ForceWord::values);
    }
    for (const char* other :
         {"", "2.9.1", "3.0.7", "4.0.0", "3", "3.", "three", ".5", "v", "-3.5"}) {
        CAPTURE(other);
        CHECK_FALSE(choose_force_word(other));
    }
    CHECK(other(ForceWord::vector) == ForceWord::values);
    CHECK(other(ForceWord::values) == ForceWord::vector);
}

TEST_CASE("haply command: an arm's name can break out of no text") {
    for (const char* good : {"049D", "a_b-C", "0"}) {
        CHECK(is_haply_id(good));
    }
    for (const char* bad : {"", "a\"b", "a b", "a\\", "a\n", "\xc3\xa4"}) {
        CAPTURE(bad);
        CHECK_FALSE(is_haply_id(bad));
    }
    CHECK(is_haply_id(std::string(64, 'a')));
    CHECK_FALSE(is_haply_id(std::string(65, 'a')));
}

}  // namespace fulcrum::runtime
