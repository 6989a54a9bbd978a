// A lesson run for its own sake by check, test and explain: no picture, no sound, no progress kept.
#pragma once

#include "runtime/app/installation.h"
#include "runtime/app/lesson_run.h"
#include "runtime/app/open_store.h"
#include "runtime/app/options.h"
#include "runtime/app/question_examples.h"
#include "runtime/app/run_request.h"

#include <utility>

namespace fulcrum::runtime {

/// The lesson's own test plays, where it has one.
[[nodiscard]] inline RunRequest quiet_request(const Options& options) {
    RunRequest request;
    request.plan.site = options.site;
    request.plan.speech = options.speech;
    request.plan.partner = options.partner;
    request.plan.picture = false;
    request.plan.sound = false;
    request.own_test = true;
    request.hands_there = HandsThere::all;
    return request;
}

/// Builds a run of the lesson that `options` name, keeping no progress, and gives it and the lesson's folder to `use`.
template <class Use>
int with_run(const Installation& installation, const Options& options, RunRequest request,
             const Use& use) {
    const auto folder = find_lesson(installation.places, options.lesson);
    if (!folder) {
        return complain(folder.error(), 2);
    }
    request.folder = *folder;
    const auto store = make_null_store();
    const auto run =
        LessonRun::create(installation.places, request, *store, installation.catalogue);
    return run ? use(**run, *folder) : complain_of_loading(run.error());
}

/// The examples of its questions, once the lesson has played; gives the exit code, 0 when all are as they are said to be.
[[nodiscard]] int tell_unmet_examples(LessonRun& run, const AnswerTaker& take_answer = {});

}  // namespace fulcrum::runtime
