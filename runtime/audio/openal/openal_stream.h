// A sound that is made while it is heard, as a short queue of buffers on one OpenAL source.
//
//   render -> [kStreamBuffers x kStreamBuffer samples] -> source
// What is heard is at most 50 ms old. A queue that ran empty (a picture that took long) starts again by itself.
//
// Thread: the player's, with its context current. Cost: `update` renders what has been heard since the last one.
#pragma once

#include "runtime/audio/sound_player.h"

#include <AL/al.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace fulcrum::runtime {

inline constexpr std::size_t kStreamBuffers = 5;
inline constexpr std::size_t kStreamBuffer = 480;  ///< samples: 10 ms

class OpenalStream {
  public:
    /// Makes the source and its buffers; `stream` outlives this.
    explicit OpenalStream(SoundStream& stream);
    OpenalStream(const OpenalStream&) = delete;
    OpenalStream& operator=(const OpenalStream&) = delete;
    ~OpenalStream();

    /// Fills what has been heard anew.
    void update();

  private:
    void fill(ALuint buffer);

    SoundStream& stream_;
    ALuint source_ = 0;
    std::array<ALuint, kStreamBuffers> buffers_{};
    std::vector<float> samples_;
    std::vector<std::int16_t> pcm_;
};

}  // namespace fulcrum::runtime
