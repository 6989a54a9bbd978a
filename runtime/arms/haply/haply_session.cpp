#include "runtime/arms/haply/haply_session.h"

#include "haptics/base/clock.h"
#include "runtime/arms/haply/haply_judge.h"
#include "runtime/arms/websocket/http_query.h"

namespace fulcrum::runtime {
namespace {

constexpr int kFound = 200;
constexpr double kScaleTolerance = 1.0e-6;
constexpr const char* kStartService =
    "install and start the Haply Inverse Service (systemctl start haply-inverse-service)";

std::string name_haply_service(std::uint16_t port) {
    return "127.0.0.1:" + std::to_string(port);
}

}  // namespace

Expected<std::unique_ptr<HaplySession>> HaplySession::open(std::uint16_t port,
                                                           const std::string& device_id,
                                                           double patience_s, MessageLog& log) {
    std::unique_ptr<HaplySession> made(new HaplySession(log));
    const auto done = made->ask_version(port, patience_s)
                          .and_then([&] { return made->ask_scale(port, patience_s); })
                          .and_then([&] { return made->meet(port, device_id, patience_s); });
    if (!done) {
        return tl::unexpected<Error>(done.error());
    }
    return made;
}

Expected<void> HaplySession::ask_version(std::uint16_t port, double patience_s) {
    const auto answer = ask_http("/version", port, monotonic_now_s() + patience_s);
    if (!answer) {
        return fail("no Haply service answers", name_haply_service(port), kStartService);
    }
    log_.write('<', answer->body);
    version_ = answer->status == kFound ? parse_haply_version(answer->body) : "";
    const auto word = choose_force_word(version_);
    if (!word) {
        return fail("the Haply service is of a version that is not known here: " +
                        (version_.empty() ? "it tells none" : version_),
                    name_haply_service(port),
                    "install version 3.1 to 3.9 of the Haply Inverse Service");
    }
    word_ = *word;
    return {};
}

Expected<void> HaplySession::ask_scale(std::uint16_t port, double patience_s) {
    for (const std::string_view path : {kHaplyScalePath, kHaplySettingsPath}) {
        const auto answer = ask_http(path, port, monotonic_now_s() + patience_s);
        if (answer && answer->status == kFound) {
            log_.write('<', answer->body);
            force_scale_ = parse_haply_force_scale(answer->body);
            scale_path_ = path;
        }
        if (force_scale_) {
            break;
        }
    }
    if (force_scale_ && (*force_scale_ > 1.0 + kScaleTolerance || *force_scale_ < 0.0)) {
        return fail("the Haply service makes every force stronger than it is ordered",
                    name_haply_service(port), "set its force scale to 1 in Haply Hub");
    }
    return {};
}

Expected<void> HaplySession::meet(std::uint16_t port, const std::string& device_id,
                                  double patience_s) {
    auto socket = WebSocket::connect(port, monotonic_now_s() + patience_s);
    if (!socket) {
        return tl::unexpected<Error>(
            Error{"the Haply service opens no stream: " + socket.error().message,
                  socket.error().where, kStartService});
    }
    socket_ = std::move(*socket);
    HaplyMessage first;
    switch (receive(first, monotonic_now_s() + patience_s)) {
        case Heard::state:
            break;
        case Heard::nothing:
            return fail("the Haply service does not tell which arms it has",
                        name_haply_service(port), "start it anew");
        case Heard::nonsense:
        case Heard::gone:
            return fail("the Haply service cannot be understood: " + why_, name_haply_service(port),
                        "install version 3.1 to 3.9 of the Haply Inverse Service");
    }
    auto arm = choose_haply_arm(first, device_id);
    if (!arm) {
        return tl::unexpected<Error>(arm.error());
    }
    if (!is_haply_id(arm->id)) {
        return fail("the Haply service has an arm without a proper name", name_haply_service(port),
                    "unplug the arm, plug it in, and start again");
    }
    arm_ = std::move(*arm);
    return check_haply_arm(arm_);
}

bool HaplySession::send(const Vector3& force_A, ForceWord word, bool wants_all, double deadline_s) {
    write_haply_command(arm_.id, word, force_A, wants_all, command_);
    log_.write('>', command_);
    if (socket_->send(command_, deadline_s)) {
        return true;
    }
    why_ = socket_->why();
    return false;
}

HaplySession::Heard HaplySession::receive(HaplyMessage& message, double deadline_s) {
    switch (socket_->receive(text_, deadline_s)) {
        case WebSocket::Heard::text:
            break;
        case WebSocket::Heard::nothing:
            return Heard::nothing;
        case WebSocket::Heard::gone:
            why_ = socket_->why();
            return Heard::gone;
    }
    log_.write('<', text_);
    auto parsed = parse_haply_message(text_);
    if (!parsed) {
        why_ = parsed.error().message;
        return Heard::nonsense;
    }
    message = std::move(*parsed);
    return Heard::state;
}

}  // namespace fulcrum::runtime
