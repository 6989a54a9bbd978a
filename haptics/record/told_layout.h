// The bytes of what a loop was told, shared by writer and reader: each field once, in the order of the file. Private to haptics/record.
//
// Lists end with the last entry that is not as it was made, to the bit.
#pragma once

#include "haptics/handover/axle_messages.h"
#include "haptics/handover/line_state.h"
#include "haptics/handover/messages.h"
#include "haptics/handover/rigid_messages.h"
#include "haptics/handover/told.h"
#include "haptics/record/record_layout.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

namespace fulcrum::record_layout {

/// Takes fields off a span of any length: what is not there is 0, and `is_whole` says so.
class CheckedSource {
  public:
    explicit CheckedSource(std::span<const std::byte> bytes) : source_(bytes) {}
    template <class T>
    void field(T& value) {
        is_whole_ = is_whole_ && source_.has(sizeof(T));
        if (is_whole_) {
            source_.field(value);
        } else {
            value = {};
        }
    }
    void fail() { is_whole_ = false; }
    /// Every field was there, and none is left.
    [[nodiscard]] bool is_whole() const { return is_whole_ && !source_.has(1); }

  private:
    Source source_;
    bool is_whole_ = true;
};

/// A truth value, as 0 or 1.
inline void visit_flag(Sink& sink, const bool& flag) {
    sink.field(static_cast<std::uint32_t>(flag ? 1 : 0));
}
inline void visit_flag(CheckedSource& source, bool& flag) {
    std::uint32_t value = 0;
    source.field(value);
    flag = value == 1;
    if (value > 1) {
        source.fail();
    }
}

/// A list: how many entries, and those.
template <class List, class VisitEntry>
void visit_list(Sink& sink, const List& list, const VisitEntry& visit_entry) {
    const auto put = [&](const auto& entry) {
        std::vector<std::byte> bytes;
        Sink own(bytes);
        visit_entry(own, entry);
        return bytes;
    };
    const typename List::value_type untold{};
    std::size_t n = list.size();
    while (n > 0 && put(list[n - 1]) == put(untold)) {
        --n;
    }
    sink.field(static_cast<std::uint32_t>(n));
    for (std::size_t i = 0; i < n; ++i) {
        visit_entry(sink, list[i]);
    }
}
template <class List, class VisitEntry>
void visit_list(CheckedSource& source, List& list, const VisitEntry& visit_entry) {
    std::uint32_t n = 0;
    source.field(n);
    if (n > list.size()) {
        source.fail();
        return;
    }
    for (std::size_t i = 0; i < n; ++i) {
        visit_entry(source, list[i]);
    }
}

template <class Visitor, class Matrix>
void visit_matrix(Visitor& visitor, Matrix& m) {
    for (Index row = 0; row < 3; ++row) {
        for (Index column = 0; column < 3; ++column) {
            visitor.field(m(row, column));
        }
    }
}

template <class T, class Value>
concept Is = std::is_same_v<std::remove_const_t<T>, Value>;

template <class Visitor, Is<ForceCommand> Value>
void visit_told(Visitor& visitor, Value& command) {
    visitor.field(command.stamp_s);
    visit_flag(visitor, command.lesson_alive);
    visit_list(visitor, command.fields, [](auto& to, auto& field) {
        visit_flag(to, field.on);
        visit_vector(to, field.anchor_W);
        to.field(field.strength);
    });
    auto& linearised = command.linearised;
    visitor.field(linearised.stamp_s);
    visit_vector(visitor, linearised.force_W);
    visit_vector(visitor, linearised.torque_W);
    visit_vector(visitor, linearised.at_position_W);
    visit_vector(visitor, linearised.at_velocity_W);
    visit_matrix(visitor, linearised.stiffness_N_per_m);
    visit_matrix(visitor, linearised.damping_Ns_per_m);
    visit_matrix(visitor, linearised.torque_stiffness_Nm_per_m);
}

template <class Visitor, Is<WorldFrame> Value>
void visit_told(Visitor& visitor, Value& frame) {
    visitor.field(frame.stamp_s);
    visit_vector(visitor, frame.carried_force_W);
    visit_list(visitor, frame.solid_poses_W, [](auto& to, auto& pose) { visit_pose(to, pose); });
    visit_list(visitor, frame.solid_placements, [](auto& to, auto& placed) { to.field(placed); });
}

template <class Visitor, Is<AxleOrders> Value>
void visit_told(Visitor& visitor, Value& orders) {
    visit_list(visitor, orders.axles, [](auto& to, auto& order) {
        to.field(order.n_angles);
        to.field(order.angle_rad);
        to.field(order.n_spins);
        to.field(order.spin_rad_per_s);
        visit_flag(to, order.is_set);
        visit_vector(to, order.pivot_B);
        to.field(order.load_N);
    });
}

template <class Visitor, Is<RigidFrame> Value>
void visit_told(Visitor& visitor, Value& frame) {
    visitor.field(frame.stamp_s);
    visitor.field(frame.rate);
    visit_list(visitor, frame.solids, [](auto& to, auto& solid) {
        visit_pose(to, solid.pose_W);
        visit_vector(to, solid.velocity_W.linear);
        visit_vector(to, solid.velocity_W.angular);
        to.field(solid.behind_s);
        visit_flag(to, solid.is_present);
        to.field(solid.n_placements);
    });
}

template <class Visitor, Is<LineState> Value>
void visit_told(Visitor& visitor, Value& line) {
    visitor.field(line.stamp_s);
    visit_vector(visitor, line.hand_W);
    visit_vector(visitor, line.force_W);
    visitor.field(line.stiffness_N_per_m);
    visitor.field(line.length_m);
    visitor.field(line.n_launches);
}

inline void visit_told(Sink& sink, const ToldReading& reading) {
    sink.field(static_cast<std::uint32_t>(reading.faults));
    visit_flag(sink, reading.is_reading);
}
inline void visit_told(CheckedSource& source, ToldReading& reading) {
    std::uint32_t faults = 0;
    source.field(faults);
    reading.faults = static_cast<Fault>(faults);
    visit_flag(source, reading.is_reading);
}

}  // namespace fulcrum::record_layout
