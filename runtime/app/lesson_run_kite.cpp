// The kite's part of lesson_run.h.
#include "runtime/app/lesson_run.h"
#include "runtime/scene/plan_kite.h"

namespace fulcrum::runtime {

// Null before it flies.
const KiteFrame* LessonRun::newest_kite() const {
    return kite_ && kite_->frame.value().n_nodes > 0 ? &kite_->frame.value() : nullptr;
}

// Another kite is made here, on the lesson's thread, and flown there.
void LessonRun::order_kite(const SessionOutput& output) {
    if (output.kite_design) {
        kite_->built.put(
            std::make_unique<KiteFlight>(with_design(plan_.kite->flight, *output.kite_design)));
    }
    kite_->orders.publish(output.kite);
}

}  // namespace fulcrum::runtime
