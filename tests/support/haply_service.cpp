#include "tests/support/haply_service.h"

#include "haptics/base/clock.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fulcrum::test_support {
namespace {

constexpr double kTremble_Hz = 9.0;  // physiological tremor of a hand: 8 to 12

// From the base A to D and back, once more and apart from the program's.
Vector3 base_from_D(const Vector3& v_D) {
    return {v_D[0], -v_D[2], v_D[1]};
}
Vector3 D_from_base(const Vector3& v_A) {
    return {v_A[0], v_A[2], -v_A[1]};
}

bool is_readable(int file) {
    pollfd one{file, POLLIN, 0};
    return ::poll(&one, 1, 0) > 0;
}

}  // namespace

struct HaplyService::Guest {
    explicit Guest(LoopbackGuest came) : line(std::move(came)) {}
    LoopbackGuest line;
    std::string bytes;
    bool has_session = false;
};

SimulatedArmSettings HaplyService::make_hand() {
    SimulatedArmSettings settings = make_desktop_arm();
    settings.max_force_N = 10.0;
    settings.position_resolution_m = 1.0e-5;
    settings.human = kArm;
    // Nothing may hide that the hand trembles.
    settings.dry_friction_N = 0.0;
    return settings;
}

HaplyService::HaplyService(HaplyOptions options, const SimulatedArmSettings& arm)
    : options_(std::move(options)), arm_(arm, target_) {
    thread_ = std::thread([this] { serve(); });
}

HaplyService::~HaplyService() {
    ends_.store(true);
    thread_.join();
}

void HaplyService::change(const std::function<void(HaplyOptions&)>& by) {
    const std::lock_guard lock(mutex_);
    by(options_);
    felt_.pushes = 0;
}

void HaplyService::move_hand(const Vector3& to_D, const Quaternion& turn_D, double tremble_m) {
    const std::lock_guard lock(mutex_);
    aim_.pose_D = {to_D, turn_D};
    tremble_m_ = tremble_m;
}

HaplyFelt HaplyService::felt() {
    const std::lock_guard lock(mutex_);
    return felt_;
}

void HaplyService::forget_peak() {
    const std::lock_guard lock(mutex_);
    felt_.peak_N = 0.0;
}

void HaplyService::go_away(bool is_away) {
    is_away_.store(is_away);
}

void HaplyService::serve() {
    std::vector<std::unique_ptr<Guest>> guests;
    while (!ends_.load()) {
        if (is_away_.load()) {
            door_.reset();
            guests.clear();
        } else if (!door_) {
            door_ = std::make_unique<LoopbackListener>(port_);
        }
        std::vector<pollfd> all;
        if (door_) {
            all.push_back({door_->file(), POLLIN, 0});
        }
        for (const auto& guest : guests) {
            all.push_back({guest->line.file(), POLLIN, 0});
        }
        (void)::poll(all.data(), all.size(), 1);
        if (door_ && is_readable(door_->file())) {
            guests.push_back(std::make_unique<Guest>(door_->accept()));
        }
        look_after(guests);
        move_arm();
    }
}

void HaplyService::look_after(std::vector<std::unique_ptr<Guest>>& guests) {
    {
        const std::lock_guard lock(mutex_);
        if (options_.hangs) {
            return;
        }
    }
    for (auto& guest : guests) {
        if (is_readable(guest->line.file()) && !attend(*guest)) {
            guest.reset();
        }
    }
    std::erase(guests, nullptr);
    const std::lock_guard lock(mutex_);
    felt_.has_session =
        std::ranges::any_of(guests, [](const auto& guest) { return guest->has_session; });
    if (!felt_.has_session) {
        state_.force_A = Vector3::Zero();
    }
}

// False where it is done with them.
bool HaplyService::attend(Guest& guest) {
    const std::string more = guest.line.read();
    guest.bytes += more;
    if (more.empty()) {
        return false;
    }
    if (!guest.has_session) {
        return guest.bytes.find("\r\n\r\n") == std::string::npos || greet(guest);
    }
    const ClientMessages messages = take_client_frames(guest.bytes);
    {
        const std::lock_guard lock(mutex_);
        felt_.pongs += messages.pongs.size();
        felt_.was_unmasked = felt_.was_unmasked || messages.was_unmasked;
        felt_.said_goodbye = messages.says_goodbye;
    }
    for (const std::string& text : messages.texts) {
        if (!answer(guest, text)) {
            return false;
        }
    }
    return !messages.says_goodbye;
}

bool HaplyService::greet(Guest& guest) {
    const std::string head = guest.bytes.substr(0, guest.bytes.find("\r\n\r\n"));
    guest.bytes.erase(0, head.size() + 4);
    move_arm();
    const std::lock_guard lock(mutex_);
    const auto upgraded = answer_upgrade(head);
    if (!upgraded) {
        const std::size_t from = head.find(' ') + 1;
        (void)guest.line.write(
            answer_get(options_, head.substr(from, head.find(' ', from) - from)));
        return false;
    }
    guest.has_session = true;
    ++felt_.sessions;
    // The first state may come in one piece with the handshake.
    return guest.line.write(*upgraded +
                            make_wire_text(make_state_text(options_, state_, true), options_.wire));
}

bool HaplyService::answer(Guest& guest, const std::string& text) {
    HaplyOptions options;
    StandInOrder order;
    {
        const std::lock_guard lock(mutex_);
        options = options_;
        options_.cuts_off = false;
        options_.delay_s = options.delays_once ? 0.0 : options.delay_s;
        order = read_order_text(options, text);
        // What is not understood is applied once and forgotten: no force [?].
        state_.force_A = turn_to_base(options, order.force_A.value_or(Vector3::Zero()));
        note(order);
    }
    move_arm();
    if (options.is_silent) {
        return true;
    }
    if (options.delay_s > 0.0) {
        std::this_thread::sleep_for(std::chrono::duration<double>(options.delay_s));
    }
    if (!options.repeats || last_.empty()) {
        last_ = make_state_text(options, state_, order.wants_all);
    }
    const std::string bytes = make_wire_text(last_, options.wire);
    const std::size_t size = options.cuts_off ? bytes.size() / 2 : bytes.size();
    return guest.line.write(bytes.substr(0, size)) && !options.cuts_off;
}

void HaplyService::note(const StandInOrder& order) {
    ++felt_.messages;
    felt_.full_states += order.wants_all ? 1U : 0U;
    if (order.force_A.value_or(Vector3::Zero()) != Vector3::Zero()) {
        ++felt_.pushes;
    }
}

// The arm and the hand on it, up to now.
void HaplyService::move_arm() {
    const std::lock_guard lock(mutex_);
    const double now_s = monotonic_now_s();
    HandTarget target = aim_;
    const double phase = 2.0 * std::numbers::pi * kTremble_Hz * now_s;
    target.pose_D.position +=
        tremble_m_ * Vector3(std::sin(phase), std::cos(phase), std::sin(phase));
    target_.publish(target);
    DeviceReading reading;
    (void)arm_.read(now_s, reading);
    const double scale = options_.force_scale.value_or(1.0);
    (void)arm_.write(now_s, {.force = scale * D_from_base(state_.force_A)});
    state_.position_A = centre_A() + base_from_D(reading.pose_D.position);
    state_.velocity_A = base_from_D(arm_.velocity_D());
    const Quaternion& turn = reading.pose_D.orientation;
    const Vector3 axis_A = base_from_D(turn.vec());
    state_.grip_A = {turn.w(), axis_A.x(), axis_A.y(), axis_A.z()};
    felt_.force_D = arm_.force_D();
    felt_.position_D = arm_.position_D();
    felt_.peak_N = std::max(felt_.peak_N, felt_.force_D.norm());
}

}  // namespace fulcrum::test_support
