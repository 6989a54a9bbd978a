// A sound that is made while it is heard, as a short queue of buffers on one OpenAL source.
//
//   render -> [queue: n_buffers x n_samples] -> source
// What is heard is at most as old as the queue is long. A queue that ran empty (a machine that was busy) starts again by itself.
// On a sound card the stream has a thread of its own, so that the queue may be far shorter than a picture takes; a player whose
// sound is taken out by hand fills it when it is updated, the same bytes each time.
//
// Thread: made and ended by the player's, with its context current; filled by its own or by `update`, never by both.
// Cost: what has been heard since the last time is rendered; the thread looks every 2 ms.
#pragma once

#include "runtime/audio/sound_player.h"

#include <AL/al.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <thread>
#include <vector>

namespace fulcrum::runtime {

struct StreamQueue {
    std::size_t n_buffers = 0;
    std::size_t n_samples = 0;  ///< in each
    bool own_thread = false;
};
/// Filled by the picture's thread, 60 times a second: 50 ms.
inline constexpr StreamQueue kUpdatedQueue{5, 480, false};
/// Filled by a thread of its own: 16 ms.
inline constexpr StreamQueue kThreadedQueue{6, 128, true};

class OpenalStream {
  public:
    /// Makes the source and its buffers; `stream` outlives this.
    OpenalStream(SoundStream& stream, const StreamQueue& queue);
    OpenalStream(const OpenalStream&) = delete;
    OpenalStream& operator=(const OpenalStream&) = delete;
    ~OpenalStream();

    /// Fills what has been heard anew, unless a thread does.
    void update();

  private:
    void fill(ALuint buffer);
    void refill();

    SoundStream& stream_;
    ALuint source_ = 0;
    std::vector<ALuint> buffers_;
    std::vector<float> samples_;
    std::vector<std::int16_t> pcm_;
    std::atomic<bool> ends_{false};
    std::thread thread_;
};

}  // namespace fulcrum::runtime
