#include "runtime/arms/dhd/dhd_arm.h"

#include "runtime/arms/maker_values.h"

namespace fulcrum::runtime {
namespace {

constexpr unsigned char kDhdOff = 0;
constexpr unsigned char kDhdOn = 1;

Vector3 to_D(const Vector3& v_A) noexcept {
    return {v_A.y(), v_A.z(), v_A.x()};
}

Vector3 to_A(const Vector3& v_D) noexcept {
    return {v_D.z(), v_D.x(), v_D.y()};
}

}  // namespace

bool DhdArm::begin() noexcept {
    bool went_well = use_.enable_expert_mode() >= 0;
    // An arm whose firmware is older than 3.0 has no watchdog: where the library hangs, nothing takes its force away.
    is_watched_ = use_.set_watchdog != nullptr && use_.set_watchdog(kDhdWatchdogTicks, id_) >= 0;
    if (!is_watched_) {
        traits_.max_force_N = std::min(traits_.max_force_N, kDhdUnwatched_N);
    }
    if (use_.set_max_force != nullptr) {
        went_well = use_.set_max_force(traits_.max_force_N, id_) >= 0 && went_well;
    }
    if (use_.set_max_torque != nullptr && traits_.max_torque_Nm > 0.0) {
        went_well = use_.set_max_torque(traits_.max_torque_Nm, id_) >= 0 && went_well;
    }
    went_well = use_.set_gravity_compensation(kDhdOn, id_) >= 0 && went_well;
    went_well = use_.set_force(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, id_) >= 0 && went_well;
    return use_.enable_force(kDhdOn, id_) >= 0 && went_well;
}

ArmSample DhdArm::read(double now_s) noexcept {
    ArmSample sample;
    if (is_open_) {
        round_ = read_pose(sample);
        round_ = is_deaf_ ? DhdTrouble::call_failed : round_;
        if (rounds_++ % kDhdStatusEvery == 0 && round_ != DhdTrouble::call_failed) {
            look_at_status(now_s);
        }
    }
    if (round_ != DhdTrouble::call_failed && is_open_) {
        failed_since_s_ = 0.0;
    } else if (failed_since_s_ == 0.0) {
        failed_since_s_ = now_s;
    } else if (now_s - failed_since_s_ > kDhdLost_s && now_s - opened_s_ > kDhdRest_s) {
        open_again(now_s);
    }
    // Before the call: one that hung may tell where the handle was then.
    sample.stamp_s = now_s;
    sample.is_there = trouble() == DhdTrouble::none;
    return sample;
}

DhdTrouble DhdArm::read_pose(ArmSample& sample) noexcept {
    Vector3 position_A = Vector3::Zero();
    double rows[3][3] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
    if (use_.get_position_and_orientation(&position_A.x(), &position_A.y(), &position_A.z(), rows,
                                          id_) < 0) {
        return DhdTrouble::call_failed;
    }
    Matrix3 R_A;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            R_A(row, column) = rows[row][column];
        }
    }
    const auto turn_A = turn_of(R_A);
    if (!is_place(position_A) || !turn_A) {
        return DhdTrouble::no_number;
    }
    const Vector3 axis_D = to_D(turn_A->vec());
    sample.pose_D = {to_D(position_A), {turn_A->w(), axis_D.x(), axis_D.y(), axis_D.z()}};
    sample.buttons = use_.get_button_mask(id_);
    return DhdTrouble::none;
}

void DhdArm::look_at_status(double now_s) noexcept {
    DhdStatus status{};
    if (use_.get_status(status.data(), id_) < 0) {
        round_ = DhdTrouble::call_failed;
        return;
    }
    const bool is_off = status[kDhdForceOn] == 0 || status[kDhdBrake] != 0;
    const bool was_off = status_ != DhdTrouble::none;
    status_ = status[kDhdError] != 0 ? DhdTrouble::fault
              : is_off               ? trouble_of_cause(status[kDhdOffCause])
                                     : DhdTrouble::none;
    if (!was_off || status_ == DhdTrouble::none) {
        off_since_s_ = now_s;
    } else if (goes_by_itself(status_) && now_s - off_since_s_ > kDhdRest_s) {
        off_since_s_ = now_s;
        if (use_.enable_force(kDhdOn, id_) < 0) {
            round_ = DhdTrouble::call_failed;
        }
    }
}

// The same arm with its zero, as it was opened at first; or another try later.
void DhdArm::open_again(double now_s) noexcept {
    opened_s_ = now_s;
    if (is_open_) {
        (void)use_.close(id_);
        is_open_ = false;
    }
    const int opened = use_.open();
    if (opened < 0) {
        round_ = DhdTrouble::call_failed;
        return;
    }
    id_ = static_cast<char>(opened);
    const unsigned short serial = ask_dhd_serial(use_, id_);
    round_ = serial != serial_           ? DhdTrouble::another_arm
             : !use_.is_initialized(id_) ? DhdTrouble::not_initialised
             : begin()                   ? DhdTrouble::none
                                         : DhdTrouble::call_failed;
    is_open_ = round_ == DhdTrouble::none;
    is_deaf_ = false;
    if (!is_open_) {
        (void)use_.close(id_);
    }
}

void DhdArm::feel(const Wrench& wrench_D) noexcept {
    if (!is_open_) {
        return;
    }
    const Wrench given = trouble() == DhdTrouble::none ? bounded(wrench_D, traits_) : Wrench{};
    const Vector3 force_A = to_A(given.force);
    const Vector3 torque_A = to_A(given.torque);
    is_deaf_ = use_.set_force(force_A.x(), force_A.y(), force_A.z(), torque_A.x(), torque_A.y(),
                              torque_A.z(), 0.0, id_) < 0;
}

void DhdArm::end() noexcept {
    if (is_open_) {
        (void)use_.set_force(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, id_);
        (void)use_.enable_force(kDhdOff, id_);
        (void)use_.close(id_);
        is_open_ = false;
    }
}

}  // namespace fulcrum::runtime
