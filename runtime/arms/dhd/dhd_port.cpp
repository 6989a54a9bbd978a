#include "runtime/arms/dhd/dhd_port.h"

#include "haptics/base/range.h"
#include "haptics/loop/safety.h"
#include "runtime/arms/dhd/dhd_arm.h"
#include "runtime/arms/dhd/dhd_model.h"
#include "runtime/arms/port_door.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <pthread.h>
#include <sched.h>
#include <thread>

namespace fulcrum::runtime {
namespace {

// What the thread keeps, and outlives the port where a call hangs.
struct DhdThread {
    explicit DhdThread(const DhdArm& opened) : arm(opened) {}
    DhdArm arm;  // the thread's own
    PortDoor door;
    std::mutex mutex;  // of what follows
    std::condition_variable ended;
    bool runs = true;
};

class DhdPort final : public ArmPort {
  public:
    DhdPort(const DhdArm& arm, DeviceTraits traits, std::vector<ArmFact> facts)
        : thread_(std::make_shared<DhdThread>(arm)),
          traits_(std::move(traits)),
          facts_(std::move(facts)) {}
    ~DhdPort() override { stop(); }

    void start();
    void stop() noexcept override;
    [[nodiscard]] const DeviceTraits& traits() const noexcept override { return traits_; }
    // No handle is thrown to and fro faster than 10 N throw 45 g; the rest is not known of these sensors.
    [[nodiscard]] SensorLife sensor() const noexcept override { return {.most_m_per_s2 = 300.0}; }
    [[nodiscard]] std::vector<ArmFact> facts() const override { return facts_; }

  private:
    // `port` may be gone: it is touched behind the door alone.
    static void run(DhdThread& own, DhdPort* port);
    [[nodiscard]] Wrench exchange(const ArmSample& newest, DhdTrouble trouble) noexcept;

    std::shared_ptr<DhdThread> thread_;
    DeviceTraits traits_;
    std::vector<ArmFact> facts_;
    DhdTrouble told_ = DhdTrouble::none;  // the thread's
};

// Below the haptic loop, above what draws. Who is refused goes on without.
void ask_for_dhd_priority() noexcept {
    constexpr int kPriority = 60;
    sched_param wanted{};
    wanted.sched_priority = kPriority;
    (void)::pthread_setschedparam(::pthread_self(), SCHED_FIFO, &wanted);
}

void DhdPort::start() {
    std::thread([own = thread_, port = this] {
        ask_for_dhd_priority();
        run(*own, port);
        const std::scoped_lock lock(own->mutex);
        own->runs = false;
        own->ended.notify_all();
    }).detach();
}

void DhdPort::stop() noexcept {
    if (!thread_->door.is_open()) {
        return;
    }
    thread_->door.shut();
    std::unique_lock lock(thread_->mutex);
    thread_->ended.wait_for(lock, std::chrono::duration<double>(kDhdFarewell_s),
                            [&] { return !thread_->runs; });
}

void DhdPort::run(DhdThread& own, DhdPort* port) {
    using Clock = std::chrono::steady_clock;
    const auto round =
        std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(kDhdRound_s));
    auto next = Clock::now();
    while (true) {
        const ArmSample newest = own.arm.read(monotonic_now_s());
        Wrench wrench_D;
        if (!own.door.pass([&] { wrench_D = port->exchange(newest, own.arm.trouble()); })) {
            break;
        }
        own.arm.feel(wrench_D);
        // What a late round has missed is not made up for.
        next = std::max(next + round, Clock::now());
        std::this_thread::sleep_until(next);
    }
    own.arm.end();
}

Wrench DhdPort::exchange(const ArmSample& newest, DhdTrouble trouble) noexcept {
    sample.publish(newest);
    if (trouble != told_) {
        told_ = trouble;
        tell(words_of(trouble));
    }
    return wanted_D(monotonic_now_s());
}

Expected<void> check_dhd_settings(const DhdSettings& settings) {
    const std::array ranges{
        Range{"max_force_N", settings.max_force_N, 0.0, kHardForceCap_N},
        Range{"max_torque_Nm", settings.max_torque_Nm, 0.0, kHardTorqueCap_Nm},
    };
    return check_ranges("the arm's", ranges);
}

std::string name_dhd_arm(const DhdFunctions& use, char id, unsigned short serial) {
    const char* model = use.get_system_name(id);
    return (model != nullptr ? std::string(model) : "Force Dimension arm") +
           (serial != 0 ? " " + std::to_string(serial) : "");
}

std::string tell_dhd_error(const DhdFunctions& use) {
    const char* said = use.error_get_last_str();
    return said != nullptr ? " (" + std::string(said) + ")" : std::string();
}

DeviceTraits find_dhd_traits(const DhdFunctions& use, char id, unsigned short serial,
                             const DhdSettings& settings) {
    const DhdModel& model = find_dhd_model(use.get_system_type(id));
    DeviceTraits traits;
    traits.name = name_dhd_arm(use, id, serial);
    traits.renders_force = true;
    traits.max_force_N = std::min(model.force_N, settings.max_force_N);
    traits.max_torque_Nm =
        use.has_active_wrist(id) ? std::min(model.torque_Nm, settings.max_torque_Nm) : 0.0;
    traits.position_resolution_m = model.step_m;
    traits.reach_m = Vector3::Constant(model.reach_m);
    // What is carried at the handle is not more than what is felt there.
    constexpr double kMostMass_kg = 2.0;
    double mass_kg = 0.0;
    if (use.get_effector_mass != nullptr && use.get_effector_mass(&mass_kg, id) >= 0 &&
        mass_kg > 0.0 && mass_kg < kMostMass_kg) {
        traits.mass_kg = mass_kg;
    }
    return traits;
}

// Its zero: known, or looked for now where a person allowed it.
Expected<void> find_zero(const DhdFunctions& use, char id, const DhdSettings& settings,
                         const std::string& name) {
    if (use.is_initialized(id)) {
        return {};
    }
    if (!settings.may_initialise) {
        return fail(name + " does not know where its zero is, and finds it by moving by itself", {},
                    "keep hands and things away from it and begin again with " +
                        std::string(kInitialiseOption));
    }
    // Afterwards nothing holds it in its place: the force is the port's.
    if (use.auto_init(id) < 0 || use.stop_regulation(true, id) < 0 || !use.is_initialized(id)) {
        return fail(name + " did not find its zero" + tell_dhd_error(use), {},
                    "see that it can move freely, switch it off and on, and begin again");
    }
    return {};
}

Expected<std::unique_ptr<ArmPort>> open_arm(const DhdLibrary& library, char id,
                                            const DhdSettings& settings) {
    const DhdFunctions& use = library.use;
    const unsigned short serial = ask_dhd_serial(use, id);
    const DeviceTraits traits = find_dhd_traits(use, id, serial, settings);
    if (auto known = find_zero(use, id, settings, traits.name); !known) {
        return tl::unexpected(known.error());
    }
    DhdArm arm(use, id, serial, traits);
    if (!arm.begin()) {
        const std::string why = tell_dhd_error(use);
        (void)use.enable_force(0, id);
        return fail(traits.name + " takes no orders" + why, {},
                    "switch it off and on, and begin again");
    }
    std::vector<ArmFact> facts{
        {"dhd library", library.found_as},
        {"dhd version", library.version},
        {"dhd watchdog", arm.is_watched() ? "20 ms" : "none"},
        {"dhd hand", use.is_left_handed(id) ? "left" : "right"},
    };
    auto port = std::make_unique<DhdPort>(arm, arm.traits(), std::move(facts));
    port->start();
    return port;
}

}  // namespace

Expected<std::unique_ptr<ArmPort>> open_dhd(const DhdSettings& settings) {
    if (auto good = check_dhd_settings(settings); !good) {
        return tl::unexpected(good.error());
    }
    const auto library = load_dhd(settings.library);
    if (!library) {
        return tl::unexpected(library.error());
    }
    const int opened = library->use.open();
    if (opened < 0) {
        return fail("no arm of Force Dimension answers" + tell_dhd_error(library->use), {},
                    "switch it on, put its USB cable in, and see that you may use it: a udev rule "
                    "for the vendor 1451, of a Falcon 0403:cb48");
    }
    auto port = open_arm(*library, static_cast<char>(opened), settings);
    if (!port) {
        (void)library->use.close(static_cast<char>(opened));
    }
    return port;
}

}  // namespace fulcrum::runtime
