#include "runtime/app/run_why.h"

namespace fulcrum::runtime {

void RunWhy::build(const LessonDescription& lesson, const RunHands& hands) {
    if (hands.front()->loop->effects().empty()) {
        return;
    }
    for (const auto& hand : hands) {
        const HapticLoop& loop = *hand->loop;
        asked_.push_back(std::make_unique<Asked>(
            WhyShown(loop.effects(), lesson.forces, {loop.max_force_N(), loop.max_torque_Nm()})));
        hand->channels.shares = &asked_.back()->shares;
    }
}

void RunWhy::look(const SessionInput& gathered) {
    for (std::size_t hand = 0; hand < asked_.size(); ++hand) {
        Asked& asked = *asked_[hand];
        if (asked.shares.take()) {
            asked.shown.look(asked.shares.value(),
                             hand == 0 ? gathered.hand : gathered.more_hands[hand - 1],
                             gathered.clock_s);
        }
    }
}

ViewWhy RunWhy::show(std::size_t hand, const dialogue::Catalogue& catalogue) const {
    if (hand >= asked_.size()) {
        return {};
    }
    ViewWhy why = asked_[hand]->shown.show(catalogue);
    if (asked_.size() > 1) {
        why.title = catalogue.say("hud.why_of", {{"number", std::to_string(hand + 1)}});
    }
    return why;
}

}  // namespace fulcrum::runtime
