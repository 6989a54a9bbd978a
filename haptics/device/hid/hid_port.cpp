#include "haptics/device/hid/hid_port.h"

#include "haptics/base/clock.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <pthread.h>
#include <sched.h>
#include <thread>

namespace fulcrum::hid {
namespace {

constexpr int kMostAtOnce = 64;   // reports that are read without handing one over
constexpr double kAgain_s = 0.5;  // until a device that refused its effects is asked again
constexpr double kFade_s = 0.05;  // in which a force that nobody renews goes to zero
constexpr std::size_t kMostReportBytes = 4096;
// A device that has said the same so often, with no longer pause, does so while it rests: its silence means something. One that speaks of
// changes alone says nothing twice.
constexpr int kRepeats = 50;
constexpr double kLongestPause_s = 0.1;

// Below the haptic loop, above what draws: both threads sleep nearly always. Who is refused goes on without.
void ask_for_priority() noexcept {
    constexpr int kPriority = 60;
    sched_param wanted{};
    wanted.sched_priority = kPriority;
    (void)pthread_setschedparam(pthread_self(), SCHED_FIFO, &wanted);
}

bool is_same(const HidNode& a, const HidNode& b) {
    return a.vendor == b.vendor && a.product == b.product &&
           (a.serial.empty() || b.serial.empty() || a.serial == b.serial);
}

}  // namespace

HidPort::HidPort(std::shared_ptr<HidBus> bus, const HidNode& node,
                 const ForceEffectSettings& settings)
    : bus_(std::move(bus)), node_(node), ability_(find_ability(node)), settings_(settings) {
    said_.reserve(kMostReportBytes);
}

Expected<std::shared_ptr<HidPort>> HidPort::start(std::shared_ptr<HidBus> bus, const HidNode& node,
                                                  const ForceEffectSettings& settings) {
    std::shared_ptr<HidPort> port(new HidPort(std::move(bus), node, settings));
    const bool has_force = port->ability_.force.has_value();
    port->takes_force_.store(!has_force, std::memory_order_release);
    port->reader_runs_ = true;
    port->writer_runs_ = has_force;
    // Each keeps the port as long as it runs.
    std::thread([port] {
        ask_for_priority();
        port->run_reader();
        port->leave(port->reader_runs_);
    }).detach();
    if (has_force) {
        std::thread([port] {
            ask_for_priority();
            port->run_writer();
            port->leave(port->writer_runs_);
        }).detach();
    }
    std::unique_lock lock(port->mutex_);
    const bool is_ready =
        port->changed_.wait_for(lock, std::chrono::duration<double>(kBegin_s),
                                [&] { return !port->path_.empty() && port->takes_force(); });
    if (is_ready) {
        port->notice_.clear();
        return port;
    }
    const std::string why = port->notice_;
    lock.unlock();
    port->stop();
    return fail(call(node) + " does not answer" + (why.empty() ? "" : ": " + why), node.path,
                "unplug it and plug it in again");
}

void HidPort::stop() noexcept {
    stops_.store(true, std::memory_order_release);
    std::unique_lock lock(mutex_);
    changed_.notify_all();
    changed_.wait_for(lock, std::chrono::duration<double>(kFarewell_s),
                      [&] { return !reader_runs_ && !writer_runs_; });
}

void HidPort::leave(bool& runs) noexcept {
    const std::lock_guard lock(mutex_);
    runs = false;
    changed_.notify_all();
}

bool HidPort::pause(double seconds) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, std::chrono::duration<double>(seconds), [&] { return stops(); });
}

void HidPort::tell(const std::string& sentence) {
    const std::lock_guard lock(mutex_);
    notice_ = sentence;
}

std::string HidPort::take_notice() {
    const std::lock_guard lock(mutex_);
    return std::exchange(notice_, {});
}

double HidPort::overdue_s(double now_s) const noexcept {
    const double since_s = ordered_s_.load(std::memory_order_acquire);
    return since_s > 0.0 ? std::max(0.0, now_s - since_s) : 0.0;
}

HidCounts HidPort::counts() const noexcept {
    return {reports_.load(), garbage_.load(), losses_.load(), writes_failed_.load()};
}

void HidPort::run_reader() {
    bool was_there = false;
    while (!stops()) {
        const std::unique_ptr<HidLink> link = connect();
        if (!link) {
            publish(false);
            if (pause(kSearch_s)) {
                break;
            }
            continue;
        }
        if (was_there) {
            tell(call(node_) + " is back.");
        }
        was_there = true;
        read_until_lost(*link);
        publish(false);
        {
            const std::lock_guard lock(mutex_);
            path_.clear();
            changed_.notify_all();
        }
        if (!stops()) {
            losses_.fetch_add(1);
            tell(call(node_) + " has gone; plug it in again, and the lesson goes on with it.");
        }
    }
}

// The device where it was, or where it stands now; nothing when it is not there.
std::unique_ptr<HidLink> HidPort::connect() {
    auto found = bus_->look(node_.path);
    if (!found || !is_same(*found, node_)) {
        const std::vector<HidNode> nodes = bus_->list();
        const auto same = std::find_if(nodes.begin(), nodes.end(), [&](const HidNode& node) {
            return is_same(node, node_) && find_ability(node).form == ability_.form;
        });
        if (same == nodes.end()) {
            return nullptr;
        }
        found = *same;
    }
    auto link = open_same(*found);
    if (!link) {
        tell(to_sentence(link.error()));
        return nullptr;
    }
    const std::lock_guard lock(mutex_);
    path_ = found->path;
    changed_.notify_all();
    return std::move(*link);
}

// What was understood of its reports must hold still.
Expected<std::unique_ptr<HidLink>> HidPort::open_same(const HidNode& found) {
    if (found.descriptor != node_.descriptor) {
        return fail(call(node_) + " came back with other reports", found.path,
                    "begin the lesson again");
    }
    return bus_->open(found.path);
}

void HidPort::read_until_lost(HidLink& link) {
    // Where a cap or a stick was before it went means nothing now.
    newest_ = {};
    newest_.reported_s = monotonic_now_s();
    repeats_ = 0;
    said_.clear();
    std::array<std::uint8_t, kMostReportBytes> report{};
    while (!stops()) {
        int n = link.read(report, kReadWait_ms);
        for (int i = 1; n > 0 && i < kMostAtOnce; ++i) {
            (void)take_report(std::span(report).first(static_cast<std::size_t>(n)));
            n = link.read(report, 0);
        }
        if (n < 0) {
            return;
        }
        if (n > 0) {
            (void)take_report(std::span(report).first(static_cast<std::size_t>(n)));
        }
        publish(true);
    }
}

bool HidPort::take_report(std::span<const std::uint8_t> report) noexcept {
    const bool was_of_use = ability_.form == HandForm::space_mouse
                                ? ability_.cap->take_report(report, newest_.cap)
                                : ability_.stick->take_report(report, newest_.stick);
    (was_of_use ? reports_ : garbage_).fetch_add(1, std::memory_order_relaxed);
    if (was_of_use) {
        note_repeat(report);
    }
    return was_of_use;
}

void HidPort::note_repeat(std::span<const std::uint8_t> report) noexcept {
    const double now_s = monotonic_now_s();
    if (now_s - newest_.reported_s > kLongestPause_s) {
        repeats_ = 0;
    }
    const bool is_same = std::ranges::equal(report, said_);
    repeats_ = std::min(repeats_ + (is_same ? 1 : 0), kRepeats);
    if (!is_same) {
        said_.assign(report.begin(), report.end());
    }
    newest_.reported_s = now_s;
    newest_.repeats_itself = repeats_ == kRepeats;
}

void HidPort::publish(bool is_there) noexcept {
    newest_.is_there = is_there;
    newest_.stamp_s = monotonic_now_s();
    sample.publish(newest_);
}

void HidPort::run_writer() {
    while (!stops()) {
        std::string path;
        {
            std::unique_lock lock(mutex_);
            changed_.wait(lock, [&] { return stops() || !path_.empty(); });
            path = path_;
        }
        if (stops()) {
            return;
        }
        auto link = bus_->open(path);
        if (link) {
            ForceEffects effects(ability_.descriptor, *ability_.force, settings_);
            if (const auto begun = effects.begin(**link)) {
                write_until_lost(**link, effects);
            } else {
                tell(to_sentence(begun.error()));
            }
        }
        if (pause(kAgain_s)) {
            return;
        }
    }
}

void HidPort::write_until_lost(HidLink& link, ForceEffects& effects) {
    {
        const std::lock_guard lock(mutex_);
        takes_force_.store(true, std::memory_order_release);
        changed_.notify_all();
    }
    double renewed_s = monotonic_now_s();
    bool taken = true;
    while (taken && !pause(kWrite_s)) {
        ordered_s_.store(monotonic_now_s(), std::memory_order_release);
        taken = write_newest(link, effects);
        if (taken && monotonic_now_s() - renewed_s >= effects.renew_every_s()) {
            taken = effects.renew(link);
            renewed_s = monotonic_now_s();
        }
        ordered_s_.store(0.0, std::memory_order_release);
    }
    takes_force_.store(false, std::memory_order_release);
    if (!taken) {
        writes_failed_.fetch_add(1);
    }
    effects.end(link);
}

// The newest force, or what is left of it when nobody has spoken for a while.
bool HidPort::write_newest(HidLink& link, ForceEffects& effects) {
    force.take();
    const HidForce& wanted = force.value();
    const double late_s = monotonic_now_s() - wanted.stamp_s - kSilence_s;
    const double share = late_s > 0.0 ? std::max(0.0, 1.0 - late_s / kFade_s) : 1.0;
    return effects.set(link, share * wanted.x, share * wanted.y);
}

}  // namespace fulcrum::hid
