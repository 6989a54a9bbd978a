// One play of one lesson with everything it needs, built from its plan and nothing more:
//
//   lesson's process -> description -> plan -> device, haptic loop, world loop, session, recorder
//
// It owns no thread and no clock: a driver (headless.h, live.h) calls the loops. `frame` halves belong to the lesson
// loop, `haptic_loop` and `world_loop` to their threads or to the same virtual clock.
#pragma once

#include "dialogue/catalogue.h"
#include "haptics/base/error.h"
#include "haptics/device/mouse/pointer_device.h"
#include "haptics/device/replay/replay_device.h"
#include "haptics/device/simulated/simulated_hand.h"
#include "haptics/dynamics/world_loop.h"
#include "haptics/handover/channels.h"
#include "haptics/loop/haptic_loop.h"
#include "haptics/record/record_writer.h"
#include "runtime/app/places.h"
#include "runtime/lesson/session.h"
#include "runtime/lesson/simulated_pupil.h"
#include "runtime/lua/lesson_process.h"
#include "runtime/progress/store.h"
#include "runtime/scene/plan.h"
#include "runtime/scene/view.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace fulcrum::runtime {

enum class HandKind : std::uint8_t { scripted, mouse, replay };

/// What is to be played, how and by whom.
struct RunRequest {
    std::filesystem::path folder;  ///< of the lesson
    PlanOptions plan{};
    HandKind hand = HandKind::scripted;
    std::filesystem::path
        hand_file;  ///< scripted: a Lua file, empty for the lesson's own test; replay: a record
    std::vector<std::string> say;  ///< answers of a simulated pupil; empty: somebody types
    bool own_test = false;         ///< use the hand and the answers of the lesson's first L:test
    std::string record_file;       ///< empty: nothing is recorded
    std::string learner;           ///< nickname; empty: "guest"
};

/// What came in since the last frame besides the hand.
struct FrameInput {
    double time_s = 0.0;
    std::vector<std::string> keys;
    std::optional<std::string> typed;
};

/// What a frame asks of the driver.
struct FrameReport {
    std::vector<std::string> sounds;
    std::vector<std::string> printed;
};

class LessonRun {
  public:
    /// Starts the lesson's process, compiles the plan and builds its parts. Everything given outlives the run.
    [[nodiscard]] static Expected<std::unique_ptr<LessonRun>> create(
        const Places& places, const RunRequest& request, ProgressStore& store,
        const dialogue::Catalogue& catalogue);
    LessonRun(const LessonRun&) = delete;
    LessonRun& operator=(const LessonRun&) = delete;
    ~LessonRun();

    [[nodiscard]] const Plan& plan() const { return plan_; }
    [[nodiscard]] const LessonDescription& description() const { return session_->description(); }
    [[nodiscard]] LessonSession& session() { return *session_; }
    [[nodiscard]] HapticLoop& haptic_loop() { return *haptic_loop_; }
    [[nodiscard]] WorldLoop* world_loop() {
        return world_loop_.get();
    }  ///< null when the plan has none
    [[nodiscard]] HapticChannels& channels() { return channels_; }
    [[nodiscard]] const LessonProcess& process() const { return *process_; }
    [[nodiscard]] const Device& device() const { return *device_; }

    /// One frame, waiting for the lesson's answer. An error means that the lesson has failed.
    [[nodiscard]] Expected<FrameReport> exchange_frame(const FrameInput& input);
    /// The same in two halves that do not wait. `begin_frame` may be called when no answer is outstanding.
    [[nodiscard]] Expected<void> begin_frame(const FrameInput& input);
    [[nodiscard]] std::optional<Expected<FrameReport>> poll_frame();

    /// Where the mouse points, in the world; for HandKind::mouse.
    void point_at(const Vector3& position_W, std::uint32_t buttons);
    /// Makes the force fade at once and stay away: the lesson has failed with this sentence.
    void fail_softly(const std::string& sentence);
    /// Closes the record.
    [[nodiscard]] Expected<void> finish_record();
    /// The picture as things stand.
    [[nodiscard]] View view(const dialogue::Catalogue& catalogue) const;

  private:
    LessonRun() = default;
    Expected<void> build(const Places& places, const RunRequest& request, ProgressStore& store,
                         const dialogue::Catalogue& catalogue);
    Expected<void> open_record(const std::string& file, const std::string& lesson);
    Expected<void> open_device(const RunRequest& request);
    void place_visible_bodies();
    SessionInput gather(const FrameInput& input);
    Expected<FrameReport> conclude(const LessonReply& reply);
    [[nodiscard]] const WorldSnapshot* newest_world() const;
    void record_events(const SessionInput& input);

    std::unique_ptr<LessonProcess> process_;
    Plan plan_{};
    HapticChannels channels_{};
    std::unique_ptr<WorldChannels> world_channels_;
    std::unique_ptr<RecordRing> record_ring_;

    // Exactly one device; its target, when somebody moves it.
    LatestValue<HandTarget> hand_target_{};
    LatestValue<PointerTarget> pointer_target_{};
    HandTarget last_hand_target_{};
    Pose pointer_W_{};
    std::unique_ptr<Device> device_;

    std::unique_ptr<HapticLoop> haptic_loop_;
    std::unique_ptr<WorldLoop> world_loop_;
    std::unique_ptr<LessonSession> session_;
    std::optional<SimulatedPupil> pupil_;
    std::optional<RecordWriter> record_;
    double last_frame_s_ = 0.0;
    std::string trouble_;
};

/// What a lesson's print() said, on the terminal, at once.
void print_lines(const std::vector<std::string>& lines);

/// Writes into the plan's stages how much memory the loop that was built from it uses for each.
void fill_in_memory(Plan& plan, const HapticLoop& loop);

}  // namespace fulcrum::runtime
