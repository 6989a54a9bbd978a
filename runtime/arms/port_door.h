// Between a port and a thread that may be caught in a maker's library for ever: once the door is shut the thread touches the port no
// more, so that the port can go before the thread does.
//
//   thread   inside = 1;  if open: use the port;  inside = 0          never a maker's call inside
//   port     open = 0;  wait while inside                             as long as a few copies take
// Sequentially consistent: of the two stores one is seen by the other side (E. W. Dijkstra 1965, after Dekker).
//
// Thread: `pass` by one thread, `shut` by who stops the port. Cost of `pass`: two stores and a load; it never waits.
#pragma once

#include <atomic>
#include <thread>

namespace fulcrum::runtime {

class PortDoor {
  public:
    /// Calls `use`, which must neither wait nor throw, unless the door is shut; false where it is.
    template <class Use>
    bool pass(const Use& use) noexcept {
        inside_.store(true);
        const bool is_open = open_.load();
        if (is_open) {
            use();
        }
        inside_.store(false);
        return is_open;
    }

    /// Afterwards nobody is inside, nor comes in. Again: nothing.
    void shut() noexcept {
        open_.store(false);
        while (inside_.load()) {
            std::this_thread::yield();
        }
    }

    [[nodiscard]] bool is_open() const noexcept { return open_.load(); }

  private:
    std::atomic<bool> open_{true};
    std::atomic<bool> inside_{false};
};

}  // namespace fulcrum::runtime
