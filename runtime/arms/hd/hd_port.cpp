#include "runtime/arms/hd/hd_port.h"

#include "haptics/base/range.h"
#include "haptics/loop/safety.h"
#include "runtime/arms/hd/hd_servo.h"
#include "runtime/arms/hd/hd_start.h"
#include "runtime/arms/hd/hd_trouble.h"

#include <array>
#include <chrono>
#include <condition_variable>
#include <thread>

namespace fulcrum::runtime {
namespace {

// The library's state is the program's.
std::atomic<bool> hd_is_open{false};

// What the threads keep, and outlives the port where a call hangs.
struct HdKept {
    HdKept(const HdFunctions& functions, const HdFound& arm, HdExchange& side)
        : use(functions),
          found(arm),
          servo(functions, arm.handle, arm.calibration_style, arm.traits, side) {}
    HdFunctions use;
    HdFound found;
    HdServo servo;
    unsigned long schedule = 0;
    PortDoor door;     // of the port's thread
    std::mutex mutex;  // of what follows
    std::condition_variable changed;
    bool stops = false;
    bool runs = false;
};

class HdPort final : public ArmPort, private HdExchange {
  public:
    HdPort(const HdFunctions& use, const HdFound& found, std::vector<ArmFact> facts)
        : kept_(std::make_shared<HdKept>(use, found, static_cast<HdExchange&>(*this))),
          facts_(std::move(facts)) {}
    ~HdPort() override { stop(); }

    [[nodiscard]] Expected<void> start();
    void stop() noexcept override;
    [[nodiscard]] const DeviceTraits& traits() const noexcept override {
        return kept_->found.traits;
    }
    // No handle is thrown to and fro faster than 10 N throw 45 g; the rest is not known of these sensors.
    [[nodiscard]] SensorLife sensor() const noexcept override { return {.most_m_per_s2 = 300.0}; }
    [[nodiscard]] std::vector<ArmFact> facts() const override { return facts_; }

  private:
    [[nodiscard]] Wrench exchange(const ArmSample& newest) noexcept override {
        sample.publish(newest);
        return wanted_D(monotonic_now_s());
    }
    // `port` may be gone: it is touched behind the door alone.
    static void watch(HdKept& kept, HdPort* port);

    std::shared_ptr<HdKept> kept_;
    std::vector<ArmFact> facts_;
};

// Sleeps; true when the port is to stop.
bool pause_hd(HdKept& kept, double seconds) {
    std::unique_lock lock(kept.mutex);
    return kept.changed.wait_for(lock, std::chrono::duration<double>(seconds),
                                 [&] { return kept.stops; });
}

// Until `n` ticks have come since; false where that takes too long.
bool wait_for_ticks(const HdServo& servo, std::uint64_t n, double patience_s) {
    const std::uint64_t before = servo.ticks();
    const double until_s = monotonic_now_s() + patience_s;
    while (servo.ticks() - before < n && monotonic_now_s() < until_s) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return servo.ticks() - before >= n;
}

// Without force, then without its loop, then closed.
void put_away(HdKept& kept) {
    const HdFunctions& use = kept.use;
    kept.servo.shut();
    // Two, for one may have taken its order before.
    constexpr double kPatience_s = 0.05;
    (void)wait_for_ticks(kept.servo, 2, kPatience_s);
    use.make_current_device(kept.found.handle);
    use.disable(hd_force_output);
    use.unschedule(kept.schedule);
    use.stop_scheduler();
    use.disable_device(kept.found.handle);
    (void)take_hd_errors(use);
    // A library may let go while its own thread hangs in a tick: what that needs stays, and no other arm is opened.
    while (kept.servo.is_inside()) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    hd_is_open.store(false);
}

Expected<void> HdPort::start() {
    HdKept& kept = *kept_;
    kept.use.enable(hd_force_output);
    constexpr unsigned long kRate_Hz = 1000;
    kept.use.set_scheduler_rate(kRate_Hz);
    (void)take_hd_errors(kept.use);
    kept.schedule = kept.use.schedule_asynchronous(&HdServo::run, &kept.servo, kHdUsualPriority);
    kept.use.start_scheduler();
    kept.runs = true;
    std::thread([own = kept_, port = this] {
        watch(*own, port);
        put_away(*own);
        const std::scoped_lock lock(own->mutex);
        own->runs = false;
        own->changed.notify_all();
    }).detach();
    // Some of the errors that starting leaves mean nothing: whether it runs the ticks tell. A machine that is busy begins later.
    constexpr std::uint64_t kEnoughTicks = 10;
    if (!wait_for_ticks(kept.servo, kEnoughTicks, kHdBegin_s)) {
        const std::string why = tell_hd_error(kept.use, take_hd_errors(kept.use));
        stop();
        return fail(kept.found.traits.name + " is there, but its loop does not run" + why, {},
                    "pull its plug out and in, and begin again");
    }
    return {};
}

void HdPort::watch(HdKept& kept, HdPort* port) {
    std::uint32_t told = hd_no_error;
    std::uint64_t ticks = kept.servo.ticks();
    double ticked_s = monotonic_now_s();
    do {
        const double now_s = monotonic_now_s();
        if (kept.servo.ticks() != ticks) {
            ticks = kept.servo.ticks();
            ticked_s = now_s;
        }
        const std::uint32_t trouble =
            now_s - ticked_s > kHdStill_s ? kHdStandsStill : kept.servo.trouble();
        if (trouble != told) {
            told = trouble;
            (void)kept.door.pass([&] { port->tell(words_of_hd(trouble)); });
        }
    } while (!pause_hd(kept, kHdLook_s));
}

void HdPort::stop() noexcept {
    HdKept& kept = *kept_;
    if (!kept.door.is_open()) {
        return;
    }
    kept.servo.shut();
    kept.door.shut();
    std::unique_lock lock(kept.mutex);
    kept.stops = true;
    kept.changed.notify_all();
    kept.changed.wait_for(lock, std::chrono::duration<double>(kHdFarewell_s),
                          [&] { return !kept.runs; });
}

// The library and the arm; where there is none of these the program has no arm.
Expected<std::unique_ptr<HdPort>> prepare_hd(const HdSettings& settings) {
    const auto library = load_hd(settings.library);
    if (!library) {
        return tl::unexpected(library.error());
    }
    const auto found = find_hd_arm(library->use, settings.max_force_N);
    if (!found) {
        return tl::unexpected(found.error());
    }
    std::vector<ArmFact> facts = found->facts;
    facts.insert(facts.begin(), {"hd library", library->found_as});
    return std::make_unique<HdPort>(library->use, *found, std::move(facts));
}

}  // namespace

Expected<std::unique_ptr<ArmPort>> open_hd(const HdSettings& settings) {
    const std::array ranges{Range{"max_force_N", settings.max_force_N, 0.0, kHardForceCap_N}};
    if (auto good = check_ranges("the arm's", ranges); !good) {
        return tl::unexpected(good.error());
    }
    if (hd_is_open.exchange(true)) {
        return fail("this program has an arm of OpenHaptics already", {},
                    "serve each by a program of its own");
    }
    auto port = prepare_hd(settings);
    if (!port) {
        hd_is_open.store(false);
        return tl::unexpected(port.error());
    }
    if (auto started = (*port)->start(); !started) {
        return tl::unexpected(started.error());
    }
    return std::unique_ptr<ArmPort>(std::move(*port));
}

}  // namespace fulcrum::runtime
