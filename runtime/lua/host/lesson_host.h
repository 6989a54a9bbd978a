// A lesson as a running script: loads its file, calls its start, hands it frames, gathers what it wants. And the simulated
// hands, each a script of its own beside it. All run in the lesson's process; tests and the fuzzer run them in their own.
//
// A lesson's force function f(x, v) gives a force F or, with six numbers, a force and a torque T. It is handed over with
// its slopes by central differences,
//   dF/dx_j ~ (F(x + h e_j, v) - F(x - h e_j, v)) / 2h,   dT/dx_j likewise,   dF/dv_j likewise with k,
// exact for what is linear in x and v; every entry is limited (wire_limits.h), for a jump has no slope. There is no dT/dv:
// field/linearised_wrench.h says why.
//
// Thread: one. Cost: a frame of 8 bodies about 10 us, plus what the lesson does.
#pragma once

#include "runtime/lua/api/lesson_context.h"
#include "runtime/lua/sandbox/script_state.h"

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace fulcrum::runtime {

inline constexpr double kForceStep_m = 1e-4;        ///< h of the central difference
inline constexpr double kForceStep_m_per_s = 1e-3;  ///< k of the central difference
inline constexpr int kMaxPrintsAFrame = 50;

/// What a host asks of its surroundings.
struct HostServices {
    std::function<ModuleAnswer(const std::string&)> find_module;
    std::function<void(const std::string&)> print_while_loading;
    RunningLine* running_line = nullptr;  ///< may be null
};

class LessonHost {
  public:
    /// Throws std::bad_alloc when there is no memory for the scripts.
    LessonHost(const LoadMessage& message, HostServices services);
    LessonHost(const LessonHost&) = delete;
    LessonHost& operator=(const LessonHost&) = delete;

    /// Runs the lesson's file and its start, then the hand's file. The error, when one fails.
    [[nodiscard]] std::optional<ScriptError> load();
    /// What was declared; complete after `load`.
    [[nodiscard]] const LessonDescription& description() const noexcept {
        return lesson_.description;
    }
    /// One frame: events, update, force, hand. The error, when the lesson or the hand failed; then it must not go on.
    [[nodiscard]] std::optional<ScriptError> run_frame(const LessonFrame& frame,
                                                       LessonReply& reply);

  private:
    [[nodiscard]] ScriptSettings settings_for(int slot, LessonContext& context);
    void print(LessonContext& context, std::string text);
    [[nodiscard]] std::optional<ScriptError> load_lesson();
    [[nodiscard]] std::optional<ScriptError> load_hand(std::size_t index);
    void deliver(lua_State* lua, const LessonEvent& event);
    void judge_answer(lua_State* lua, const std::string& asked, const LessonEvent& event);
    void tell(lua_State* lua, const AskedEvent& asked);
    void run_callbacks(lua_State* lua);
    [[nodiscard]] std::optional<ScriptError> run_hand(std::size_t index, const LessonFrame& frame,
                                                      LessonReply& reply);
    void call_hand(lua_State* lua, std::size_t index, LessonReply& reply);
    [[nodiscard]] bool frame_fits(const LessonFrame& frame) const;

    LoadMessage message_;
    HostServices services_;
    LessonContext lesson_{};
    bool loaded_ = false;
    std::unique_ptr<ScriptState> lesson_script_;
    struct SimulatedHand {
        LessonContext context{};
        int ref = LUA_NOREF;
        std::unique_ptr<ScriptState> script;  // null where it is not simulated
    };
    std::array<SimulatedHand, kMostHands> hands_{};
};

/// The file of a simulated hand, counted from 0; without a name where that hand is none.
[[nodiscard]] const LuaSource& source_of_hand(const LoadMessage& message, std::size_t index);

/// Evaluates the function at registry reference `function_ref` and its slopes at the context's tool. Raises what it raises.
[[nodiscard]] LinearisedWrench linearise_force(lua_State* lua, LessonContext& context,
                                               int function_ref);
/// Pushes the table that tells a lesson of an event: name, and what belongs to it.
void push_event(lua_State* lua, const LessonContext& context, const LessonEvent& event);
/// Pushes `answer`: the slots as fields, and what answer_fields() lists.
void push_answer(lua_State* lua, const LessonContext& context, const AnsweredEvent& answer);

}  // namespace fulcrum::runtime
