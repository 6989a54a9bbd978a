#include "runtime/app/open_hands.h"

#include "haptics/device/replay/recorded_traits.h"
#include "runtime/app/hand_fitting.h"
#include "runtime/app/run_request.h"
#include "runtime/scene/plan_hands.h"

#include <charconv>
#include <system_error>

namespace fulcrum::runtime {
namespace {

// What the record that the first hand repeats has of this one; null where it has nothing, or another file is repeated.
std::shared_ptr<const Record> find_replayed(const RunRequest& request, std::size_t hand) {
    if (hand == 0) {
        return request.replayed;
    }
    const HandChoice& choice = request.more_hands[hand - 1];
    const bool is_of_it = request.replayed && choice.hand == HandKind::replay &&
                          choice.hand_file == request.hand_file;
    auto alone = is_of_it ? find_hand(*request.replayed, hand) : std::nullopt;
    return alone ? std::make_shared<const Record>(std::move(*alone)) : nullptr;
}

// How far it went in the scene then, times the lesson's own scale.
std::optional<double> find_replayed_scale(const RunRequest& request, std::size_t hand) {
    const auto told = find_fact(request.replayed->header, fact_prefix(hand) + kScaleFact);
    double scale = 1.0;
    const bool is_number =
        told && std::from_chars(told->data(), told->data() + told->size(), scale).ec == std::errc{};
    return is_number ? std::optional(scale) : std::nullopt;
}

// What is asked of that hand beside the first; of one that the record is `alone` for, with what that has of it.
Expected<RunRequest> whole_request(const RunRequest& request, std::size_t hand,
                                   const std::shared_ptr<const Record>& alone) {
    RunRequest own = of_hand(request, hand);
    if (!alone) {
        return with_record(std::move(own));
    }
    own.replayed = alone;
    own.fit.scale = own.fit.scale ? own.fit.scale : find_replayed_scale(request, hand);
    return own;
}

// Each device stands before the learner as it is kept for it, and goes as far in the scene as was said or as it reaches. What it can reach
// and hold is known when it is open.
Expected<void> open_hand(const RunOrder& order, ProgressStore& store, std::size_t hand,
                         RunPlan& plan, RunHands& hands) {
    const RunRequest& request = order.request;
    auto made = std::make_unique<RunHand>();
    made->replayed = find_replayed(request, hand);
    RunRequest own = request;
    if (hand > 0) {
        auto whole = whole_request(request, hand, made->replayed);
        if (!whole) {
            return tl::unexpected(whole.error());
        }
        own = with_kept_fit(*whole, store);
        made->choice = request.more_hands[hand - 1];
        if (auto scaled = plan.scale_as_said(order, hands, hand, own.fit); !scaled) {
            return scaled;
        }
    } else {
        made->choice = static_cast<const HandChoice&>(request);
    }
    made->fit = own.fit;
    auto device = HandDevice::open(own, plan.plan().of_hand(hand));
    if (!device) {
        return tl::unexpected(device.error());
    }
    made->device = std::move(*device);
    hands.push_back(std::move(made));
    const HandDevice& opened = *hands.back()->device;
    if (hand == 0 || opened.wall_holder()) {
        if (auto fitted = plan.fit_to_force(order, hands); !fitted) {
            return fitted;
        }
    }
    const DeviceTraits& traits = opened.device().traits();
    if (const double factor = choose_scale(own.fit, traits); factor != 1.0) {
        plan.fit_to_reach(order, hands, hand, factor);
    }
    return validate(plan.plan().of_hand(hand), traits);
}

}  // namespace

Expected<void> open_hands(const RunOrder& order, ProgressStore& store, RunPlan& plan,
                          RunHands& hands) {
    for (std::size_t hand = 0; hand <= plan.plan().more_hands.size(); ++hand) {
        if (auto opened = open_hand(order, store, hand, plan, hands); !opened) {
            return opened;
        }
    }
    return {};
}

}  // namespace fulcrum::runtime
