#include "haptics/link/link_post.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {

LinkPost::LinkPost(Datagrams& datagrams, const Seal& seal, SessionNumbers& numbers) noexcept
    : datagrams_(datagrams), seal_(seal), numbers_(numbers) {
    begin_session();
}

std::int64_t LinkPost::to_ns(double now_s) noexcept {
    // 0 stands for no time, and a run begins at 0.
    constexpr std::int64_t kZero_ns = 1'000'000'000;
    constexpr double kLongestRun_s = 1.0e9;
    return kZero_ns +
           (std::isfinite(now_s) ? std::llround(std::clamp(now_s, 0.0, kLongestRun_s) * 1.0e9) : 0);
}

void LinkPost::begin_session() noexcept {
    session_ = numbers_.draw();
    sequence_ = 0;
    set_partner(0, {});
}

void LinkPost::set_partner(std::uint64_t session, const PeerAddress& address) noexcept {
    partner_ = session;
    address_ = address;
    window_ = ReplayWindow{};
    clock_.reset();
    heard_sent_ns_ = 0;
    heard_arrived_ns_ = 0;
    missing_ = 0;
}

std::optional<OpenedPacket> LinkPost::open_next(double now_s) noexcept {
    OpenedPacket opened{};
    while (left_-- > 0) {
        const std::size_t size = datagrams_.receive(now_s, bytes_, opened.from);
        if (size == 0) {
            return std::nullopt;
        }
        const Refusal refusal =
            size > bytes_.size() ? Refusal::foreign
                                 : read_packet(std::span(bytes_).first(size), seal_, opened.packet);
        if (refusal == Refusal::none) {
            return opened;
        }
        ++counts_.received[static_cast<std::size_t>(refusal)];
    }
    return std::nullopt;
}

bool LinkPost::accept(double now_s, const OpenedPacket& opened) noexcept {
    const PacketHead& head = opened.packet.head;
    if (head.receiver != session_ || partner_ == 0 || head.sender != partner_) {
        refuse();
        return false;
    }
    const std::uint64_t newest = window_.newest();
    const bool is_newest = head.sequence > newest;
    if (!window_.take(head.sequence)) {
        ++counts_.received[static_cast<std::size_t>(Refusal::replayed)];
        return false;
    }
    ++counts_.received[static_cast<std::size_t>(Refusal::none)];
    const std::int64_t now_ns = to_ns(now_s);
    clock_.hear(head.sent_ns, head.echoed_ns, head.held_ns, now_ns);
    if (is_newest) {
        missing_ = head.sequence - newest - 1;
        address_ = opened.from;
        heard_sent_ns_ = head.sent_ns;
        heard_arrived_ns_ = now_ns;
    }
    return true;
}

void LinkPost::send(double now_s, LinkPacket& packet) noexcept {
    send_to(now_s, packet, partner_, address_);
}

void LinkPost::send_to(double now_s, LinkPacket& packet, std::uint64_t receiver,
                       const PeerAddress& to) noexcept {
    const std::int64_t now_ns = to_ns(now_s);
    packet.head.sender = session_;
    packet.head.receiver = receiver;
    packet.head.sequence = ++sequence_;
    packet.head.sent_ns = now_ns;
    const bool echoes = receiver == partner_ && heard_sent_ns_ != 0;
    packet.head.echoed_ns = echoes ? heard_sent_ns_ : 0;
    packet.head.held_ns = echoes ? std::max<std::int64_t>(now_ns - heard_arrived_ns_, 0) : 0;
    const std::size_t size = write_packet(packet, seal_, bytes_);
    if (size > 0 && datagrams_.send(now_s, to, std::span(bytes_).first(size))) {
        ++counts_.sent;
    } else {
        ++counts_.unsent;
    }
}

double LinkPost::compute_usual_arrival_s(double now_s, std::int64_t theirs_ns) const noexcept {
    if (!clock_.is_known()) {
        return now_s;
    }
    const std::int64_t later_ns = to_ns(now_s) - clock_.usual_arrival_ns(theirs_ns);
    return now_s - std::max(static_cast<double>(later_ns) * 1.0e-9, 0.0);
}

}  // namespace fulcrum
