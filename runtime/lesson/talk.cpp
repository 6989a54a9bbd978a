#include "runtime/lesson/talk.h"

#include "dialogue/partner/ready_partners.h"

#include <utility>

namespace fulcrum::runtime {

Talk Talk::build(const Plan& /*plan*/, const dialogue::Catalogue& catalogue) {
    Talk talk(catalogue);
    talk.partner_ = std::make_unique<dialogue::ShippedPartner>();
    return talk;
}

void Talk::take(const dialogue::Turn& turn) {
    were_asked_.push_back(turn.asked == nullptr);
    partner_->take(turn, own_.say(turn));
}

std::optional<Talk::Said> Talk::poll(double time_s) {
    auto reply = partner_->poll(time_s);
    if (!reply) {
        return std::nullopt;
    }
    Said said{std::move(*reply), were_asked_.front()};
    were_asked_.pop_front();
    return said;
}

}  // namespace fulcrum::runtime
