#include "runtime/app/arm_line.h"

#include "haptics/base/clock.h"
#include "runtime/app/interrupt.h"
#include "runtime/app/link_words.h"
#include "runtime/link/arm_key.h"

#include <chrono>
#include <thread>
#include <utility>

namespace fulcrum::runtime {
namespace {

Expected<std::shared_ptr<OwnArm>> start_own_arm(const HandChoice& choice) {
    std::vector<std::string> words = arm_words(*choice.own_arm);
    if (!choice.key_file.empty()) {
        words.insert(words.end(), {"--key", choice.key_file});
    }
    words.insert(words.end(), choice.arm_words.begin(), choice.arm_words.end());
    return OwnArm::start(std::move(words), std::string(choice.own_arm->name))
        .map([](std::unique_ptr<OwnArm>&& arm) { return std::shared_ptr<OwnArm>(std::move(arm)); });
}

Expected<void> meet_arm(HandChoice& choice) {
    if (choice.hand != HandKind::link) {
        return {};
    }
    return ArmLine::open(choice).and_then([&](std::unique_ptr<ArmLine>&& line) {
        choice.started_arm = line->own_arm();
        return line->greet({}, monotonic_now_s()).map([&](std::unique_ptr<LinkDevice>&& arm) {
            choice.arm_name = arm->traits().name;
        });
    });
}

}  // namespace

Expected<std::unique_ptr<ArmLine>> ArmLine::open(const HandChoice& choice) {
    std::shared_ptr<OwnArm> own_arm = choice.started_arm;
    if (choice.own_arm != nullptr && own_arm == nullptr) {
        auto started = start_own_arm(choice);
        if (!started) {
            return tl::unexpected(started.error());
        }
        own_arm = std::move(*started);
    }
    const std::string where = own_arm != nullptr ? own_arm->address() : choice.hand_address;
    const auto address = parse_host_port(where);
    if (!address) {
        return tl::unexpected(address.error());
    }
    const auto file = find_arm_key_file(choice.key_file);
    const auto key = file.and_then(load_or_make_arm_key);
    if (!key) {
        return tl::unexpected(key.error());
    }
    auto socket = UdpSocket::connect(*address);
    if (!socket) {
        return tl::unexpected(socket.error());
    }
    std::unique_ptr<ArmLine> line(new ArmLine(std::move(*socket), *key));
    line->own_arm_ = std::move(own_arm);
    line->address_ = where;
    line->key_file_ = file->string();
    return line;
}

Expected<std::unique_ptr<LinkDevice>> ArmLine::greet(const LinkDeviceSettings& settings,
                                                     double began_s) {
    auto device = std::make_unique<LinkDevice>(settings, *socket_, seal_, numbers_);
    const double from_s = monotonic_now_s();
    while (!device->greet(monotonic_now_s() - began_s)) {
        if (monotonic_now_s() - from_s > kGreeting_s || interrupted()) {
            return tl::unexpected(
                explain_silence(device->status(), socket_->was_refused(), address_, key_file_));
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return device;
}

Expected<void> meet_arms(RunRequest& request) {
    Expected<void> met = meet_arm(request);
    for (std::size_t i = 0; met && i < request.more_hands.size(); ++i) {
        met = meet_arm(request.more_hands[i]);
    }
    return met;
}

}  // namespace fulcrum::runtime
