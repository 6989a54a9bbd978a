#include "haptics/link/memory_channel.h"

#include <algorithm>
#include <array>
#include <vector>

namespace fulcrum {

// A ring of packets that the other end reads.
class MemoryChannel::End final : public Datagrams {
  public:
    explicit End(std::uint8_t number) : ring_(kMostWaiting) {
        address_.size = 1;
        address_.bytes[0] = number;
    }
    void join(End& other) noexcept { other_ = &other; }

    bool send(double /*now_s*/, const PeerAddress& /*to*/,
              std::span<const std::byte> packet) noexcept override {
        return other_->put(packet);
    }
    [[nodiscard]] std::size_t receive(double /*now_s*/, std::span<std::byte> packet,
                                      PeerAddress& from) noexcept override {
        if (read_ == written_) {
            return 0;
        }
        const Slot& slot = ring_[read_++ % ring_.size()];
        std::copy_n(slot.bytes.begin(), std::min(slot.size, packet.size()), packet.begin());
        from = other_->address_;
        return slot.size;
    }

  private:
    struct Slot {
        std::size_t size = 0;
        std::array<std::byte, kMostBytes> bytes{};
    };
    bool put(std::span<const std::byte> packet) noexcept {
        if (written_ - read_ == ring_.size() || packet.size() > kMostBytes) {
            return false;
        }
        Slot& slot = ring_[written_++ % ring_.size()];
        slot.size = packet.size();
        std::copy(packet.begin(), packet.end(), slot.bytes.begin());
        return true;
    }

    PeerAddress address_{};
    End* other_ = nullptr;
    std::vector<Slot> ring_;
    std::size_t read_ = 0;
    std::size_t written_ = 0;
};

MemoryChannel::MemoryChannel() : ends_{std::make_unique<End>(1), std::make_unique<End>(2)} {
    ends_[0]->join(*ends_[1]);
    ends_[1]->join(*ends_[0]);
}

MemoryChannel::~MemoryChannel() = default;

Datagrams& MemoryChannel::end(int which) noexcept {
    return *ends_[which == 0 ? 0 : 1];
}

}  // namespace fulcrum
