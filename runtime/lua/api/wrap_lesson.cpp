// lesson{…} and what hangs on the lesson itself: questions, tests, listeners.
#include "runtime/effect/asking/lesson_fields.h"
#include "runtime/effect/asking/question_fields.h"
#include "runtime/lua/api/binding_table.h"
#include "runtime/lua/api/lesson_context.h"
#include "runtime/lua/api/take_fields.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace fulcrum::runtime {
namespace {

template <std::size_t n>
bool is_one_of(const std::array<std::string_view, n>& known, std::string_view word) {
    return std::find(known.begin(), known.end(), word) != known.end();
}

/// "a, b or c".
template <std::size_t n>
std::string listed(const std::array<std::string_view, n>& words, const char* last) {
    std::string text;
    for (std::size_t i = 0; i < n; ++i) {
        text += (i == 0 ? "" : i + 1 == n ? last : ", ") + std::string(words[i]);
    }
    return text;
}

/// What a test expects must be something that a lesson ends with.
void check_expected(lua_State* lua, const std::string& name, const std::string& value) {
    if (!is_one_of(kTestFacts, name)) {
        const std::string near = nearest_word(name, {kTestFacts.begin(), kTestFacts.end()});
        raise_in_lesson(lua, "test.expect has no \"" + clean_text(name, 40) + "\"; " +
                                 (near.empty() ? "it has " + listed(kTestFacts, " and ")
                                               : "did you mean \"" + near + "\"?"));
    }
    const bool is_flag = value == "true" || value == "false";
    const std::size_t first_digit = value.starts_with('-') ? 1 : 0;
    const bool is_whole = value.size() > first_digit &&
                          value.find_first_not_of("0123456789", first_digit) == std::string::npos;
    const bool wants_flag = std::find(kTestFacts.begin(), kTestFacts.begin() + kTestFlags, name) !=
                            kTestFacts.begin() + kTestFlags;
    if (wants_flag ? !is_flag : !is_whole) {
        raise_in_lesson(lua, "test.expect." + name + " is " +
                                 (wants_flag ? "true or false" : "a whole number") + "; got " +
                                 clean_text(value, 40));
    }
}

/// The steps of feedback that were given; none where there were none.
dialogue::FeedbackLadder take_ladder(lua_State* lua, const char* called, const Argument& given) {
    if (!given.given) {
        return {};
    }
    auto ladder = dialogue::read_ladder(given.texts);
    if (!ladder) {
        raise_in_lesson(lua, std::string(called) + ": " + ladder.error().message);
    }
    return std::move(*ladder);
}

int make_lesson(lua_State* lua, LessonContext& context, const Arguments& arguments) {
    if (context.lesson_ref != LUA_NOREF) {
        raise_in_lesson(lua, "a file makes one lesson; this is the second lesson{…}");
    }
    take_fields(fields::kLesson, arguments, context.description);
    if (!is_one_of(kEnglishLevels, context.description.level)) {
        raise_in_lesson(lua, "lesson.level is " + listed(kEnglishLevels, " or ") + "; got \"" +
                                 clean_text(context.description.level, 16) + '"');
    }
    if (arguments["force_limit"].given) {
        context.description.force_limit_N = arguments["force_limit"].number;
    }
    context.description.feedback = take_ladder(lua, "lesson.feedback", arguments["feedback"]);
    context.most_hands = static_cast<std::size_t>(arguments["hands"].number);
    if (context.most_hands > 1) {
        ScriptError unmet = place_in_lesson(lua);
        unmet.message =
            "the lesson says hands = 2; declare the second one by another "
            "world:hand { … } in L:start";
        context.needs.emplace_back(Need::hands, std::move(unmet));
    }
    lua_newtable(lua);
    luaL_setmetatable(lua, "fulcrum.lesson");
    lua_pushvalue(lua, -1);
    context.lesson_ref = luaL_ref(lua, LUA_REGISTRYINDEX);
    return 1;
}

int add_question(lua_State* lua, LessonContext& context, const Arguments& arguments) {
    QuestionDescription question;
    take_fields(fields::kQuestion, arguments, question);
    if (arguments["examples"].given) {
        take_fields(fields::kExamples, arguments.record("examples"), question.examples);
    }
    question.feedback = take_ladder(lua, "question.feedback", arguments["feedback"]);
    question.line = place_in_lesson(lua).line;
    auto& known = context.description.questions;
    if (std::any_of(known.begin(), known.end(),
                    [&](const auto& q) { return q.id == question.id; })) {
        raise_in_lesson(
            lua, "there is already a question \"" + question.id + "\"; give this one another name");
    }
    if (known.size() >= kMaxQuestions) {
        raise_in_lesson(lua,
                        "a lesson has at most " + std::to_string(kMaxQuestions) + " questions");
    }
    if (question.answers.empty()) {
        raise_in_lesson(
            lua,
            "question.answers is empty; give at least one sentence that a learner may answer with");
    }
    lua_pushvalue(lua, arguments["right"].stack_index);
    context.judges.emplace_back(question.id, luaL_ref(lua, LUA_REGISTRYINDEX));
    known.push_back(std::move(question));
    return 0;
}

int add_knowledge(lua_State* lua, LessonContext& context, const Arguments& arguments) {
    KnowledgeDescription knowledge;
    take_fields(fields::kKnowledge, arguments, knowledge);
    if (arguments["examples"].given) {
        take_fields(fields::kAskedExamples, arguments.record("examples"), knowledge.examples);
    }
    knowledge.line = place_in_lesson(lua).line;
    auto& known = context.description.knowledge;
    if (std::any_of(known.begin(), known.end(),
                    [&](const auto& k) { return k.id == knowledge.id; })) {
        raise_in_lesson(
            lua, "the lesson knows \"" + knowledge.id + "\" already; give this another name");
    }
    if (known.size() >= kMaxQuestions) {
        raise_in_lesson(lua, "a lesson knows at most " + std::to_string(kMaxQuestions) + " things");
    }
    if (knowledge.asked.empty()) {
        raise_in_lesson(lua, "knows.asked is empty; give at least one question that asks for it");
    }
    lua_pushvalue(lua, arguments["answer"].stack_index);
    context.tellers.emplace_back(knowledge.id, luaL_ref(lua, LUA_REGISTRYINDEX));
    known.push_back(std::move(knowledge));
    return 0;
}

/// Wrong, in form and unclear are parts of one whole.
void check_parts(lua_State* lua, const LearnerRates& rates) {
    constexpr double kRounding = 1e-9;  // 0.7 + 0.2 + 0.1
    const double sum = rates.wrong + rates.form + rates.unclear;
    if (sum > 1.0 + kRounding) {
        lua_pushfstring(lua,
                        "test.learner errs in %f of its answers, wrong, form and unclear together; "
                        "1 is all of them",
                        sum);
        raise_in_lesson(lua, lua_tostring(lua, -1));
    }
}

int add_test(lua_State* lua, LessonContext& context, const Arguments& arguments) {
    LessonTestDescription test;
    take_fields(fields::kTest, arguments, test);
    if (arguments["learner"].given) {
        test.learner.emplace();
        take_fields(fields::kRates, arguments.record("learner"), *test.learner);
        if (!test.say.empty()) {
            raise_in_lesson(lua, "test has say and learner; leave out one of them");
        }
        check_parts(lua, *test.learner);
    }
    test.line = place_in_lesson(lua).line;
    for (const auto& [name, value] : test.expect) {
        check_expected(lua, name, value);
    }
    for (const auto& [field, file] :
         {std::pair{"test.hand", std::string_view(test.hand)},
          std::pair{"test.second_hand", std::string_view(test.second_hand)}}) {
        if (!file.empty() && !is_hand_file_name(file)) {
            raise_in_lesson(lua, std::string(field) +
                                     " is the name of a Lua file beside the lesson, such as "
                                     "\"sweep.lua\"; got \"" +
                                     clean_text(file, 40) + '"');
        }
    }
    if (context.description.tests.size() >= kMaxListItems) {
        raise_in_lesson(lua, "a lesson has at most " + std::to_string(kMaxListItems) + " tests");
    }
    context.description.tests.push_back(std::move(test));
    return 0;
}

int add_listener(lua_State* lua, LessonContext& context, const Arguments& arguments) {
    if (context.listeners.size() >= 32) {
        raise_in_lesson(lua, "a lesson has at most 32 listeners");
    }
    lua_pushvalue(lua, arguments["listener"].stack_index);
    context.listeners.push_back(luaL_ref(lua, LUA_REGISTRYINDEX));
    return 0;
}

}  // namespace

void add_lesson_api(ApiTable& table) {
    using enum ParameterType;
    table.functions.push_back(
        {"", "lesson", CallShape::record, CallTime::loading, rows_of(fields::kLesson), "Lesson",
         "Begins a lesson. The file ends with `return` of what this gives.", &make_lesson});
    table.functions.push_back({"lesson", "question", CallShape::named_record, CallTime::loading,
                               rows_of(fields::kQuestion), "", "Declares a question.",
                               &add_question});
    table.functions.push_back(
        {"lesson", "knows", CallShape::named_record, CallTime::loading, rows_of(fields::kKnowledge),
         "",
         "Declares something that a learner may ask for while no question is open: with the Tab "
         "key, or aloud; and where a question's own answers ask (\"Now you ask me!\"): there it is "
         "a right answer.",
         &add_knowledge});
    table.functions.push_back({"lesson", "test", CallShape::record, CallTime::loading,
                               rows_of(fields::kTest), "",
                               "Declares how the lesson is played in tests.", &add_test});
    table.functions.push_back({"lesson",
                               "listen",
                               CallShape::positional,
                               CallTime::acting,
                               {{"listener", function, "", 0, 0, kRequired,
                                 "function(event): event.name says what happened, see Events"}},
                               "",
                               "Calls a function with every event, after the lesson's own; "
                               "\"update\" comes each frame with event.dt.",
                               &add_listener});
}

}  // namespace fulcrum::runtime
