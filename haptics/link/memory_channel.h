// Two ends in one program: what one sends, the other receives at once and in order. For tests and for runs under one clock.
//
// Thread: that of both ends. Cost: a copy of each packet on either side; allocates nothing after it was built.
#pragma once

#include "haptics/link/datagrams.h"

#include <cstddef>
#include <memory>

namespace fulcrum {

class MemoryChannel {
  public:
    static constexpr std::size_t kMostWaiting = 4096;  ///< each way; what comes then does not go
    static constexpr std::size_t kMostBytes = 512;     ///< a packet's; a longer one does not go

    MemoryChannel();
    ~MemoryChannel();
    MemoryChannel(const MemoryChannel&) = delete;
    MemoryChannel& operator=(const MemoryChannel&) = delete;

    /// End 0 or 1; their addresses differ.
    [[nodiscard]] Datagrams& end(int which) noexcept;

  private:
    class End;
    std::unique_ptr<End> ends_[2];
};

}  // namespace fulcrum
