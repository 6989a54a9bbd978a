#include "runtime/app/quiet_run.h"

namespace fulcrum::runtime {

int tell_unmet_examples(LessonRun& run, const AnswerTaker& take_answer) {
    const auto unmet = find_unmet_examples(run, take_answer);
    if (!unmet) {
        return complain(unmet.error(), 1);
    }
    say_all(*unmet);
    return unmet->empty() ? 0 : 1;
}

}  // namespace fulcrum::runtime
