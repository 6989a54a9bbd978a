#include "runtime/app/hand_fitting.h"

#include "runtime/app/installation.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace fulcrum::runtime {
namespace {

constexpr int kUsualClutch = 3;
constexpr const char* kNotGood = "not good";

std::string name_of_kind(const hid::HidNode& node) {
    std::array<char, 16> ids{};
    std::snprintf(ids.data(), ids.size(), "%04x:%04x", node.vendor, node.product);
    return std::string("hid:") + ids.data();
}

std::string with(std::string name, const std::string& more) {
    return more.empty() ? name : std::move(name) + " " + more;
}

// Whether anything is kept of the device itself; which hand somebody writes with is not of one.
bool is_of_a_device(HandFit fit) {
    fit.left_handed.reset();
    return !words_of(fit).empty();
}

// By which name settings were kept before devices had names of their own: an address, or a kind.
std::string name_before(const RunRequest& request) {
    return request.hand == HandKind::link  ? name_of(request)
           : request.hand == HandKind::hid ? name_of_kind(request.hid.node)
                                           : name_device(request);
}

// What is kept under the name that it had before, for the device that it is of: an address is the arm's that was tried there; of a kind
// the verdict is nobody's.
HandFit fit_before(const RunRequest& request, const HandFit& kept) {
    const bool is_its_own = kept.checked.empty() || request.hand == HandKind::hid ||
                            kept.checked.ends_with(" " + request.arm_name);
    HandFit fit = is_its_own ? kept : HandFit{};
    if (request.hand == HandKind::hid) {
        fit.checked.clear();
    }
    return fit;
}

}  // namespace

std::string name_device(const RunRequest& request) {
    switch (request.hand) {
        case HandKind::link:
            // One that the run starts is that arm wherever it is plugged in; what another computer calls itself says no serial.
            return request.own_arm != nullptr && !request.arm_name.empty()
                       ? "arm " + request.arm_name
                       : with(name_of(request), request.arm_name);
        case HandKind::hid:
            return with(name_of_kind(request.hid.node), request.hid.node.serial);
        case HandKind::mouse:
            return "mouse";
        case HandKind::keys:
            return "keys";
        case HandKind::scripted:
            return "simulated hand";
        case HandKind::replay:
        case HandKind::none:
            break;
    }
    return {};
}

// A guest is another each time, and a simulated pupil plays alike each time.
bool is_somebody(const RunRequest& request) {
    return !request.learner.empty() && request.learner != kSimulatedPupil &&
           !name_device(request).empty();
}

int usual_clutch(HandKind kind) noexcept {
    return kind == HandKind::link ? kUsualClutch : 0;
}

std::string verdict_of(bool asked, const std::string& device) {
    return (asked ? "good " : "moves ") + device;
}

std::string bad_verdict_of(const std::string& device) {
    return kNotGood + (" " + device);
}

// Words that name no device are of whichever it is.
bool is_refused(const HandFit& fit, const std::string& device) {
    return fit.checked == kNotGood || fit.checked == bad_verdict_of(device);
}

bool is_tried(const HandFit& fit, bool asked, const std::string& device) {
    return fit.checked == verdict_of(true, device) ||
           (!asked && fit.checked == verdict_of(false, device));
}

double choose_scale(const HandFit& fit, const DeviceTraits& traits) {
    const Vector3& reach_m = traits.reach_m;
    if (fit.scale || !reach_m.allFinite() || !(reach_m.minCoeff() > 0.0)) {
        return 1.0;
    }
    return std::clamp(kUsualReach_m / reach_m.minCoeff(), 1.0, kMostFitScale);
}

std::unique_ptr<Device> fit_device(const RunRequest& request, std::unique_ptr<Device> device) {
    if (request.hand != HandKind::link && request.hand != HandKind::hid) {
        return device;
    }
    DeviceFit fit = device_fit(request.fit);
    fit.clutch_button = request.fit.clutch_button.value_or(usual_clutch(request.hand));
    return std::make_unique<FittedDevice>(fit, std::move(device));
}

RunRequest with_kept_fit(const RunRequest& request, ProgressStore& store) {
    RunRequest fitted = request;
    if (!is_somebody(request)) {
        return fitted;
    }
    // Who is not known yet has nothing kept; a name that cannot be one is refused where it is enrolled.
    if (const auto learner = store.enrol(request.learner)) {
        const std::string name = name_device(request);
        KeptFit kept = read_fit(store, *learner, name);
        if (const std::string before = name_before(request);
            before != name && !is_of_a_device(kept.fit)) {
            kept.fit = join(kept.fit, fit_before(request, read_fit(store, *learner, before).fit));
            (void)keep_fit(store, *learner, name, kept.fit);
        }
        for (const std::string& notice : kept.notices) {
            say(notice);
        }
        fitted.fit = join(request.fit, kept.fit);
    }
    return fitted;
}

void keep_fit_of(const RunRequest& request, ProgressStore& store) {
    if (!is_somebody(request) || words_of(request.fit).empty()) {
        return;
    }
    const auto kept = store.enrol(request.learner).and_then([&](const Learner& learner) {
        return keep_fit(store, learner, name_device(request), request.fit);
    });
    if (!kept) {
        std::fprintf(stderr, "How the hand is set was not kept: %s\n",
                     to_sentence(kept.error()).c_str());
    }
}

}  // namespace fulcrum::runtime
