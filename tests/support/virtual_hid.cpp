#include "tests/support/virtual_hid.h"

#include "haptics/base/clock.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

namespace fulcrum::test_support {
namespace {

int word_at(const Bytes& report, std::size_t i) {
    return report.at(i) | report.at(i + 1) << 8;
}
int signed_at(const Bytes& report, std::size_t i) {
    return static_cast<std::int16_t>(word_at(report, i));
}

constexpr int kConstantForce = 1;  // first of the effect types
constexpr int kStart = 1;
constexpr int kStop = 3;

}  // namespace

bool ForceStick::take_output(const Bytes& report) {
    return take(report, false);
}
bool ForceStick::take_feature(const Bytes& report) {
    return take(report, true);
}

// Bytes are counted by hand from the descriptor: this is the other side, and knows nothing of the parser.
bool ForceStick::take(const Bytes& report, bool is_feature) {
    const std::lock_guard lock(mutex_);
    ++orders_;
    const int which = report.at(0) - shape_.first_report;
    switch (which) {
        case 1:
            set_effect(report);
            return !is_feature;
        case 2:
            if (report.size() != 4 || effects_.count(report.at(1)) == 0) {
                return false;
            }
            effects_[report.at(1)].magnitude = signed_at(report, 2) / double(shape_.magnitude);
            return !is_feature;
        case 3:
            return !is_feature && operate(report);
        case 4:
            return !is_feature && report.size() == 2 && control(report.at(1));
        case 5:
            gain_ = report.at(1) / 255.0;
            return !is_feature && report.size() == 2;
        case 6:
            effects_.erase(report.at(1));
            return !is_feature && report.size() == 2;
        case 7:
            return is_feature == shape_.features_made && report.size() == 2 && create(report.at(1));
        default:
            return false;
    }
}

void ForceStick::set_effect(const Bytes& report) {
    Effect& effect = effects_.at(report.at(1));
    effect.kind = report.at(2);
    effect.duration_s = word_at(report, 3) / 1000.0;
    effect.gain = report.at(9) / 255.0;
    effect.trigger = report.at(10);
    const int flags = report.at(11);
    effect.enable_x = (flags & 1) != 0;
    effect.enable_y = shape_.has_y && (flags & 2) != 0;
    effect.by_direction = !shape_.by_axes && (flags & (shape_.has_y ? 4 : 2)) != 0;
    effect.bearing_deg =
        shape_.has_units ? word_at(report, 12) / 100.0 : word_at(report, 12) * 360.0 / 65535.0;
}

bool ForceStick::operate(const Bytes& report) {
    const auto found = report.size() == 4 ? effects_.find(report.at(1)) : effects_.end();
    if (found == effects_.end()) {
        return false;
    }
    if (report.at(2) == kStart) {
        found->second.until_s = monotonic_now_s() + found->second.duration_s * report.at(3);
    } else if (report.at(2) == kStop) {
        found->second.until_s = -1.0;
    }
    return true;
}

// 1 actuators on, 2 off, 3 stop all, 4 reset, 5 pause, 6 go on.
bool ForceStick::control(int what) {
    if (what == 1 || what == 2) {
        actuators_ = what == 1;
    }
    if (what == 3) {
        for (auto& [index, effect] : effects_) {
            effect.until_s = -1.0;
        }
    }
    if (what == 4) {
        effects_.clear();
        actuators_ = false;
    }
    return what >= 1 && what <= 6;
}

bool ForceStick::create(int kind) {
    full_ = room_ == 0;
    loaded_.reset();
    if (full_) {
        return true;
    }
    room_ -= room_ > 0 ? 1 : 0;
    int index = 1;
    while (effects_.count(index) != 0) {
        ++index;
    }
    effects_[index] = {};
    effects_[index].kind = kind;
    loaded_ = index;
    return true;
}

Bytes ForceStick::give_feature(std::uint8_t number) {
    const std::lock_guard lock(mutex_);
    if (number != shape_.first_report + 8) {
        return {};
    }
    if (slow_ > 0) {
        --slow_;
        return {};
    }
    const auto index = static_cast<std::uint8_t>(loaded_.value_or(0));
    const auto status = static_cast<std::uint8_t>(loaded_ ? 1 : full_ ? 2 : 3);
    return {number, index, status, 0, 0};
}

ForceStick::Felt ForceStick::felt() const {
    const std::lock_guard lock(mutex_);
    Felt felt;
    for (const auto& [index, effect] : effects_) {
        if (!actuators_ || effect.kind != kConstantForce || effect.until_s < monotonic_now_s()) {
            continue;
        }
        const double share = effect.magnitude * effect.gain * gain_;
        if (effect.by_direction) {
            // A direction is where the force comes from, clockwise from straight ahead.
            const double bearing_rad = effect.bearing_deg * std::numbers::pi / 180.0;
            felt.right -= share * std::sin(bearing_rad);
            felt.away -= share * std::cos(bearing_rad);
        } else {
            felt.right -= effect.enable_x ? share : 0.0;
            felt.away -= effect.enable_y ? share : 0.0;
        }
    }
    return felt;
}

std::size_t ForceStick::n_effects() const {
    const std::lock_guard lock(mutex_);
    return effects_.size();
}
void ForceStick::make_room(int n) {
    const std::lock_guard lock(mutex_);
    room_ = n;
}
void ForceStick::be_slow(int n) {
    const std::lock_guard lock(mutex_);
    slow_ = n;
}
double ForceStick::device_gain() const {
    const std::lock_guard lock(mutex_);
    return gain_;
}
int ForceStick::orders() const {
    const std::lock_guard lock(mutex_);
    return orders_;
}
void ForceStick::press_trigger() {
    const std::lock_guard lock(mutex_);
    for (auto& [index, effect] : effects_) {
        if (effect.trigger != 0) {
            effect.until_s = monotonic_now_s() + effect.duration_s;
        }
    }
}

struct MemoryBus::Seat {
    hid::HidNode node;
    std::shared_ptr<VirtualHid> device;
    std::mutex mutex;
    std::condition_variable changed;
    bool plugged = true;
    bool stalls = false;
    std::map<const void*, std::deque<Bytes>> queues;  // of each link
};

namespace {

class MemoryLink final : public hid::HidLink {
  public:
    explicit MemoryLink(std::shared_ptr<MemoryBus::Seat> seat) : seat_(std::move(seat)) {
        const std::lock_guard lock(seat_->mutex);
        seat_->queues[this];
    }
    ~MemoryLink() override {
        const std::lock_guard lock(seat_->mutex);
        seat_->queues.erase(this);
    }

    int read(std::span<std::uint8_t> report, int timeout_ms) override {
        std::unique_lock lock(seat_->mutex);
        auto& queue = seat_->queues[this];
        seat_->changed.wait_for(lock, std::chrono::milliseconds(timeout_ms),
                                [&] { return !seat_->plugged || !queue.empty(); });
        if (!seat_->plugged) {
            return -1;
        }
        if (queue.empty()) {
            return 0;
        }
        const std::size_t n = std::min(report.size(), queue.front().size());
        std::copy_n(queue.front().begin(), n, report.begin());
        queue.pop_front();
        return static_cast<int>(n);
    }
    bool write(std::span<const std::uint8_t> report) override {
        return wait_for_it() && seat_->device->take_output({report.begin(), report.end()});
    }
    bool send_feature(std::span<const std::uint8_t> report) override {
        return wait_for_it() && seat_->device->take_feature({report.begin(), report.end()});
    }
    int get_feature(std::span<std::uint8_t> report) override {
        if (!wait_for_it()) {
            return -1;
        }
        const Bytes answer = seat_->device->give_feature(report[0]);
        const std::size_t n = std::min(report.size(), answer.size());
        std::copy_n(answer.begin(), n, report.begin());
        return answer.empty() ? -1 : static_cast<int>(n);
    }

  private:
    bool wait_for_it() {
        std::unique_lock lock(seat_->mutex);
        seat_->changed.wait(lock, [&] { return !seat_->plugged || !seat_->stalls; });
        return seat_->plugged;
    }

    std::shared_ptr<MemoryBus::Seat> seat_;
};

}  // namespace

void MemoryBus::plug(const hid::HidNode& node, std::shared_ptr<VirtualHid> device) {
    const std::lock_guard lock(mutex_);
    auto seat = std::make_shared<Seat>();
    seat->node = node;
    seat->device = std::move(device);
    seats_[node.path] = std::move(seat);
}

void MemoryBus::unplug(const std::string& path) {
    const std::lock_guard lock(mutex_);
    const auto seat = seats_.at(path);
    seats_.erase(path);
    const std::lock_guard seat_lock(seat->mutex);
    seat->plugged = false;
    seat->changed.notify_all();
}

void MemoryBus::report(const std::string& path, const Bytes& report) {
    const std::lock_guard lock(mutex_);
    const auto& seat = seats_.at(path);
    const std::lock_guard seat_lock(seat->mutex);
    for (auto& [link, queue] : seat->queues) {
        queue.push_back(report);
    }
    seat->changed.notify_all();
}

void MemoryBus::stall(const std::string& path, bool stalls) {
    const std::lock_guard lock(mutex_);
    const auto& seat = seats_.at(path);
    const std::lock_guard seat_lock(seat->mutex);
    seat->stalls = stalls;
    seat->changed.notify_all();
}

int MemoryBus::links(const std::string& path) const {
    const std::lock_guard lock(mutex_);
    const auto& seat = seats_.at(path);
    const std::lock_guard seat_lock(seat->mutex);
    return static_cast<int>(seat->queues.size());
}

std::vector<hid::HidNode> MemoryBus::list() {
    const std::lock_guard lock(mutex_);
    std::vector<hid::HidNode> nodes;
    for (const auto& [path, seat] : seats_) {
        nodes.push_back(seat->node);
    }
    return nodes;
}

Expected<hid::HidNode> MemoryBus::look(const std::string& path) {
    const std::lock_guard lock(mutex_);
    const auto found = seats_.find(path);
    if (found == seats_.end()) {
        return fail("there is no device to be opened", path, "plug it in");
    }
    return found->second->node;
}

Expected<std::unique_ptr<hid::HidLink>> MemoryBus::open(const std::string& path) {
    const std::lock_guard lock(mutex_);
    const auto found = seats_.find(path);
    if (found == seats_.end()) {
        return fail("there is no device to be opened", path, "plug it in");
    }
    return std::make_unique<MemoryLink>(found->second);
}

hid::HidNode make_hid_node(const std::string& path, const Bytes& descriptor, std::uint16_t vendor,
                           std::uint16_t product, const std::string& name) {
    hid::HidNode node;
    node.path = path;
    node.name = name;
    node.vendor = vendor;
    node.product = product;
    node.descriptor = descriptor;
    node.may_open = true;
    return node;
}

Bytes cap_report(std::uint8_t number, std::initializer_list<int> values) {
    Bytes report{number};
    for (const int value : values) {
        report.push_back(static_cast<std::uint8_t>(value & 0xFF));
        report.push_back(static_cast<std::uint8_t>(value >> 8 & 0xFF));
    }
    return report;
}

Bytes stick_report(const ForceStickShape& shape, int x, int y, int throttle, int buttons) {
    Bytes report = cap_report(shape.first_report, {x, y});
    report.push_back(static_cast<std::uint8_t>(throttle));
    report.push_back(static_cast<std::uint8_t>(buttons));
    return report;
}

}  // namespace fulcrum::test_support
