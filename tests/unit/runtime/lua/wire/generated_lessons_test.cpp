// Lessons made by chance from the binding table: what the lesson's side takes, the program's side takes too.
// FULCRUM_LESSONS says how many.
#include "tests/support/both_sides.h"
#include "tests/support/generated_lesson.h"

#include <catch2/catch.hpp>

#include <cstdio>
#include <cstdlib>
#include <map>
#include <sstream>

using namespace fulcrum;
using namespace fulcrum::test;

namespace {

/// How often what was given was taken: calls, and fields of them.
struct Tally {
    int given = 0;
    int taken = 0;
};
using Tallies = std::map<std::string, Tally>;

std::string name_of(const Binding& binding) {
    return std::string(binding.owner) + ':' + binding.name;
}

void count(const GeneratedLesson& lesson, const BothSides& told, Tallies& calls, Tallies& fields) {
    std::vector<int> taken(lesson.calls.size(), 0);
    for (const std::string& print : told.prints) {
        std::istringstream words(print.starts_with("done ") ? print.substr(5) : "");
        for (std::size_t id = 0; words >> id;) {
            taken.at(id) = 1;
        }
    }
    for (std::size_t i = 0; i < lesson.calls.size(); ++i) {
        const std::string name = name_of(*lesson.calls[i].binding);
        Tally& call = calls[name];
        call = {call.given + 1, call.taken + taken[i]};
        for (const std::string& given : lesson.calls[i].fields) {
            Tally& field = fields[name + '.' + given];
            field = {field.given + 1, field.taken + taken[i]};
        }
    }
}

std::string never_taken(const Tallies& tallies) {
    std::string names;
    for (const auto& [name, tally] : tallies) {
        names += tally.taken == 0 ? ' ' + name : "";
    }
    return names;
}

}  // namespace

TEST_CASE(
    "wire: what the lesson's side takes of generated lessons is never nonsense to the program") {
    constexpr int kFew = 1500;
    constexpr int kMany = 50'000;  // in which each field is taken by some lesson
    const char* said = std::getenv("FULCRUM_LESSONS");
    const int n_lessons = said == nullptr ? kFew : std::atoi(said);
    Tallies calls;
    Tallies fields;
    int n_played = 0;
    for (int seed = 1; seed <= n_lessons; ++seed) {
        const Choices choices(static_cast<std::uint64_t>(seed));
        const GeneratedLesson lesson = LessonWriter(choices).write();
        LoadMessage message;
        message.lesson = {"lesson.lua", lesson.text};
        message.load_instructions = 10'000'000;
        message.frame_instructions = 10'000'000;
        const BothSides told = play_both_sides(message, choices, 3);
        if (!told.program.empty()) {
            FAIL_CHECK("seed " << seed << ": " << told.program << '\n' << lesson.text);
        }
        n_played += told.lesson.empty() ? 1 : 0;
        count(lesson, told, calls, fields);
    }
    int n_calls = 0;
    int n_taken = 0;
    for (const auto& [name, tally] : calls) {
        n_calls += tally.given;
        n_taken += tally.taken;
    }
    std::printf("%d lessons, %d played to the end, %d of %d calls taken\n", n_lessons, n_played,
                n_taken, n_calls);
    CHECK(100 * n_played >= 98 * n_lessons);
    // All functions but the head of the lesson and its end, which each of them has.
    CHECK(calls.size() == api_table().functions.size() - 2);
    CHECK(never_taken(calls).empty());
    if (n_lessons >= kMany) {
        CHECK(never_taken(fields).empty());
    }
}
