#include "runtime/arms/wam/wam_server.h"

#include "haptics/link/arm_server.h"
#include "haptics/loop/realtime_thread.h"
#include "runtime/arms/arm_device.h"
#include "runtime/arms/maker_values.h"
#include "runtime/link/arm_key.h"
#include "runtime/link/udp_socket.h"

#include <array>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace fulcrum::runtime {
namespace {

constexpr std::uint16_t kUsualPort = 4701;
// About its middle the handle can be moved so far, any way (haptics/device/arm/barrett_wam.h, make_wam_home).
constexpr double kReach_m = 0.12;
// A knob at the tool plate, and what of the wrist moves with it: the least there is.
constexpr double kHandle_kg = 0.1;

volatile std::sig_atomic_t g_ends = 0;

Vector3 to_D(const double (&v)[3]) {
    return {v[1], v[2], v[0]};
}

// The control thread is libbarrett's: there is none of its own to end.
class WamPort final : public ArmPort {
  public:
    explicit WamPort(int n_joints) {
        traits_.name = "Barrett WAM " + std::to_string(n_joints);
        traits_.renders_force = true;
        traits_.max_force_N = kHardForceCap_N;
        traits_.reach_m = Vector3::Constant(kReach_m);
    }
    void stop() noexcept override {}
    [[nodiscard]] const DeviceTraits& traits() const noexcept override { return traits_; }
    [[nodiscard]] std::vector<ArmFact> facts() const override { return {}; }

    void tell(const WamPose& pose) noexcept {
        ArmSample told;
        told.stamp_s = monotonic_now_s();
        const Vector3 position_D = to_D(pose.position_m);
        const auto& q = pose.turn_wxyz;
        Quaternion turn_D(q[0], q[2], q[3], q[1]);
        const double length = turn_D.coeffs().norm();
        constexpr double kUnitTolerance = 0.1;
        if (position_D.allFinite() && std::abs(length - 1.0) <= kUnitTolerance) {
            if (!middle_D_) {
                middle_D_ = position_D;
            }
            turn_D.normalize();
            told.pose_D = {position_D - *middle_D_, turn_D};
            told.is_there = true;
        }
        sample.publish(told);
    }
    [[nodiscard]] WamForce wanted() noexcept {
        const Vector3 force_D = bounded(wanted_D(monotonic_now_s()), traits_).force;
        return {{force_D.z(), force_D.x(), force_D.y()}};
    }

  private:
    DeviceTraits traits_;
    std::optional<Vector3> middle_D_;
};

struct Words {
    HostPort at{"127.0.0.1", kUsualPort};
    std::string key_file;
    double force_N = 5.0;
};

Expected<Words> read_words(int argc, char** argv) {
    Words words;
    for (int i = 1; i < argc; i += 2) {
        const std::string_view name = argv[i];
        const std::string value = i + 1 < argc ? argv[i + 1] : "";
        if (name == "--port") {
            const auto read =
                std::from_chars(value.data(), value.data() + value.size(), words.at.port);
            if (read.ec != std::errc{} || read.ptr != value.data() + value.size()) {
                return fail("--port " + value + " is no port", "", "give 0 to 65535");
            }
        } else if (name == "--address" && !value.empty()) {
            words.at.host = value;
        } else if (name == "--force-limit") {
            const auto read =
                std::from_chars(value.data(), value.data() + value.size(), words.force_N);
            if (read.ec != std::errc{} || read.ptr != value.data() + value.size() ||
                !(words.force_N >= 0.5 && words.force_N <= kHardForceCap_N)) {
                return fail("--force-limit " + value + " is none", "", "give 0.5 to 10 newtons");
            }
        } else if (name == "--key" && !value.empty()) {
            words.key_file = value;
        } else {
            return fail("fulcrum-wam does not know " + std::string(name), "",
                        "give --port N, --address A, --key FILE or --force-limit N");
        }
    }
    return words;
}

}  // namespace

struct WamServer::Parts {
    Parts(const ArmServerSettings& settings, int n_joints, const ArmKey& key,
          std::unique_ptr<UdpSocket> opened)
        : socket(std::move(opened)),
          seal(key),
          port(new WamPort(n_joints)),
          device(std::unique_ptr<ArmPort>(port)),
          server(settings, device, *socket, seal, numbers) {}

    std::unique_ptr<UdpSocket> socket;
    SodiumSeal seal;
    SodiumNumbers numbers;
    WamPort* port;
    ArmDevice device;
    ArmServer server;
    RealtimeThread thread;
    double told_s = 0.0;
};

WamServer::WamServer(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}

WamServer::~WamServer() {
    parts_->thread.stop();
}

std::unique_ptr<WamServer> WamServer::start(int argc, char** argv, int n_joints) {
    ArmServerSettings settings;
    settings.sensor.most_m_per_s2 = 300.0;
    settings.reach_m = Vector3::Constant(kReach_m);
    settings.handle_mass_kg = kHandle_kg;
    std::unique_ptr<WamServer> made;
    const auto started = read_words(argc, argv).and_then([&](const Words& words) {
        settings.safety.max_force_N = words.force_N;
        return find_arm_key_file(words.key_file)
            .and_then(load_or_make_arm_key)
            .and_then([&](const ArmKey& key) {
                return UdpSocket::listen(words.at).and_then(
                    [&](std::unique_ptr<UdpSocket>&& socket) {
                        made.reset(new WamServer(
                            std::make_unique<Parts>(settings, n_joints, key, std::move(socket))));
                        return made->parts_->thread.start(made->parts_->server,
                                                          {.epoch_s = monotonic_now_s()});
                    });
            });
    });
    if (!started) {
        std::fprintf(stderr, "%s\n", to_sentence(started.error()).c_str());
        return nullptr;
    }
    const auto note_end = [](int) { g_ends = 1; };
    std::signal(SIGINT, note_end);
    std::signal(SIGTERM, note_end);
    std::printf("The WAM waits at port %u. Play with it: ./fulcrum run gravity --hand wam:HOST\n",
                made->parts_->socket->port());
    (void)std::fflush(stdout);
    return made;
}

void WamServer::tell(const WamPose& pose) noexcept {
    parts_->port->tell(pose);
}

WamForce WamServer::wanted() noexcept {
    return parts_->port->wanted();
}

bool WamServer::goes_on() {
    constexpr double kTell_s = 1.0;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    if (const double now_s = monotonic_now_s(); now_s - parts_->told_s >= kTell_s) {
        parts_->told_s = now_s;
        const ArmServerStatus& status = parts_->server.status();
        std::printf("%s, %.2f N (most %.2f), %s\n", status.held ? "held" : "waiting",
                    status.applied_D.force.norm(), status.peak_force_N,
                    any(status.faults) ? "with a fault" : "well");
        (void)std::fflush(stdout);
    }
    return g_ends == 0;
}

}  // namespace fulcrum::runtime
