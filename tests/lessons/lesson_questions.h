// The questions of a lesson that ships, compiled.
#pragma once

#include "runtime/lesson/questions.h"
#include "runtime/lua/process/lesson_process.h"
#include "tests/lessons/program.h"

namespace fulcrum::test {

using Questions = std::map<std::string, dialogue::Question>;

/// The questions of scenarios/`lesson` by their names.
inline Questions questions_of(const std::string& lesson) {
    runtime::LessonFiles files;
    files.folder = std::filesystem::path(FULCRUM_SCENARIOS) / lesson;
    files.library = std::filesystem::path(FULCRUM_SCENARIOS) / "../scripts/lib";
    runtime::LessonProcessOptions options;
    options.executable = program_path();
    auto process = runtime::LessonProcess::start(files, options);
    REQUIRE(process);
    auto questions = runtime::compile_questions((*process)->description());
    REQUIRE(questions);
    return std::move(*questions);
}

}  // namespace fulcrum::test
