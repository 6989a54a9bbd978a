// An arm at this computer, in a process of its own: `fulcrum arm`, started, watched, started again and ended by a run.
//
//   start      the process tells where it waits ("at PORT"), or why it cannot ("error SENTENCE")
//   watch      it says "." every kArmBeat_s and "told SENTENCE" where something has happened; one that ends, or says nothing for
//              kArmPatience_s, is ended and started again at the same port, every kArmAgain_s
//   end        its input ends: it takes the force away, lets go of the arm and ends; kArmFarewell_s later it is killed
// What a maker's library does, it does to that process: the link between the two fades by itself (haptics/link/PROTOCOL.md).
//
// Thread: made, asked and destroyed by the lesson loop; a thread of its own watches. Cost: a process and a sleeping thread.
#pragma once

#include "haptics/base/error.h"
#include "runtime/app/arm_kind.h"
#include "runtime/files/line_program.h"

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace fulcrum::runtime {

inline constexpr double kArmBeat_s = 0.2;
inline constexpr double kArmPatience_s = 1.0;
inline constexpr double kArmAgain_s = 1.0;
inline constexpr double kArmFarewell_s = 2.0;
inline constexpr double kArmFrozen_s = 0.3;  ///< the same of one that says nothing
inline constexpr double kArmBegin_s =
    20.0;  ///< how long a process may take until it waits: a Haply arm waits 10 s for its handle to rest

// What the process says, a line each, before the rest of it.
inline constexpr std::string_view kArmBeat = ".";
inline constexpr std::string_view kArmNamed = "named ";  ///< model and serial, before the next
inline constexpr std::string_view kArmSame =
    "same ";  ///< words by which it is the same when it begins again
inline constexpr std::string_view kArmAt = "at ";
inline constexpr std::string_view kArmTold = "told ";
inline constexpr std::string_view kArmError = "error ";

/// What a maker's library may read of the environment, beside what any program gets.
extern const std::vector<std::string> kArmEnvironment;
/// The program and its words for an arm of this kind, but for the port.
[[nodiscard]] std::vector<std::string> arm_words(const OwnArmKind& kind);

/// What the process says up to the line that says that it waits, or cannot; less where it ends, or says neither until then (monotonic clock).
[[nodiscard]] std::vector<std::string> hear_beginning(LineProgram& program, double until_s);

class OwnArm {
  public:
    /// `words`: as arm_words gives them, and what else is said to it; `name`: of the arm, for people, "Haply's arm". Waits until it waits;
    /// refuses what the process refuses, by its own sentence. --initialise among the words is said the first time alone.
    [[nodiscard]] static Expected<std::unique_ptr<OwnArm>> start(std::vector<std::string> words,
                                                                 std::string name);
    OwnArm(const OwnArm&) = delete;
    OwnArm& operator=(const OwnArm&) = delete;
    ~OwnArm();

    /// "127.0.0.1:PORT", for as long as this lives.
    [[nodiscard]] std::string address() const;
    /// What has happened since the last call that people should know, sentences; empty when nothing has.
    [[nodiscard]] std::string take_notice();
    /// How often it was started again.
    [[nodiscard]] int n_restarts();

  private:
    OwnArm(std::vector<std::string> words, std::string name)
        : words_(std::move(words)), name_(std::move(name)) {}
    [[nodiscard]] Expected<void> begin();
    void watch(const std::stop_token& ends);
    void hear(double now_s);
    void tell(std::string_view sentence);

    std::vector<std::string> words_;
    std::vector<std::string> words_again_;  // as the process told the first time
    std::string name_;
    std::uint16_t port_ = 0;  // fixed once it is known
    // The watching thread's.
    std::unique_ptr<LineProgram> program_;
    double heard_s_ = 0.0;
    bool is_gone_ = false;
    std::string why_gone_;  // as it was told last
    std::mutex mutex_;      // of what follows
    std::string notice_;
    int n_restarts_ = 0;
    std::jthread watcher_;
};

}  // namespace fulcrum::runtime
