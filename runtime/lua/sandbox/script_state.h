// One Lua state that is fit for texts nobody has read: allow-listed library, capped memory, a
// budget of work that no pcall or coroutine escapes, texts only (no bytecode), and errors with
// their place.
//
// Budget: a hook counts instructions; library functions charge for the work they do in C++; large
// blocks of memory charge for filling them. Once spent it stays spent: the error is raised again
// after every instruction, pcall and resume.
//
// Thread: one. Cost: the hook about 0.1 us every 1000 instructions.
#pragma once

#include "runtime/lua/sandbox/arena.h"
#include "runtime/lua/sandbox/script_error.h"
#include "runtime/lua/wire/wire.h"

#include <lua5.4/lua.hpp>

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace fulcrum::runtime {

/// Where the script is, for whoever has to end it; shared between two processes.
struct RunningLine {
    std::atomic<std::int32_t> line{0};
    std::array<char, 60> file{};  ///< ends with a zero
};

struct ScriptSettings {
    int slot = 0;                           ///< which of the fixed places of memory, 0 to 2
    std::size_t memory_bytes = 64U << 20U;  ///< 1 MiB to 256 MiB
    std::uint64_t seed = 1;                 ///< of math.random
    RunningLine* running_line = nullptr;    ///< may be null
    std::function<ModuleAnswer(const std::string&)> find_module;  ///< answers `require`
    std::function<void(std::string)> print;  ///< takes what print() says, clean and short
};

/// The sentence when a script used up its budget.
inline constexpr const char* kTooLong = "this ran for too long (a loop that never ends?)";

class ScriptState {
  public:
    /// Throws std::bad_alloc when there is no memory for the state.
    explicit ScriptState(ScriptSettings settings);
    ScriptState(const ScriptState&) = delete;
    ScriptState& operator=(const ScriptState&) = delete;
    ~ScriptState();

    [[nodiscard]] lua_State* lua() const noexcept { return lua_; }
    [[nodiscard]] const ScriptSettings& settings() const noexcept { return settings_; }
    [[nodiscard]] const Arena& arena() const noexcept { return arena_; }
    /// True when the order of `pairs` is the same in every run.
    [[nodiscard]] bool is_repeatable() const noexcept {
        return seed_fixed_ && arena_.is_at_fixed_address();
    }
    /// The state that a Lua thread belongs to.
    [[nodiscard]] static ScriptState& of(lua_State* lua) noexcept;

    /// From now on `instructions` may be used.
    void begin_budget(std::uint64_t instructions) noexcept;
    /// Counts work done outside Lua, in instructions. Raises a Lua error when the budget is spent.
    void charge(lua_State* lua, std::uint64_t work);
    /// Raises the error again once the budget is spent; called after everything that swallows
    /// errors.
    void check_spent(lua_State* lua);
    [[nodiscard]] std::uint64_t used_instructions() const noexcept { return used_; }

    /// Runs `body(lua)` protected. The error, with its place, when Lua raised one.
    template <class Body>
    [[nodiscard]] std::optional<ScriptError> protect(Body body) {
        return run_protected([](lua_State* lua, void* self) { (*static_cast<Body*>(self))(lua); },
                             &body);
    }
    /// Inside `protect`: compiles `source` (text only) and leaves the function on the stack, or
    /// raises.
    void load_text(lua_State* lua, const LuaSource& source);
    /// Inside `protect`: calls what is on the stack, noting its first line as where the script is.
    void call(lua_State* lua, int n_arguments, int n_results);

    /// An error that is raised next and tells this place tells the truth, wherever the script is.
    void note_true_place(const ScriptError& place) { told_place_ = place; }
    /// The coroutine has failed, with an error on its top: the place that it tells is true, whoever raises it again.
    void note_failure(lua_State* coroutine);

    /// Which Lua thread runs now; kept by the coroutine functions.
    lua_State* running = nullptr;
    /// How deep coroutine.close has nested.
    int close_depth = 0;
    /// State of math.random: four words of xoshiro256**.
    std::array<std::uint64_t, 4> random{};
    /// What the bindings work on.
    void* context = nullptr;

  private:
    using RawBody = void (*)(lua_State*, void*);
    [[nodiscard]] std::optional<ScriptError> run_protected(RawBody body, void* self);
    [[nodiscard]] ScriptError describe_failure(int status);
    static void* allocate(void* self, void* block, std::size_t old_bytes,
                          std::size_t new_bytes) noexcept;
    void note_memory_error();
    void count_large_block(std::size_t bytes) noexcept;
    static void on_count(lua_State* lua, lua_Debug* activation);
    static int on_error(lua_State* lua);
    void note_line(lua_State* lua, lua_Debug* activation) noexcept;
    [[noreturn]] void raise_spent(lua_State* lua);

    ScriptSettings settings_;
    Arena arena_;
    std::byte* first_block_ = nullptr;
    std::size_t first_block_bytes_ = 0;
    bool seed_tried_ = false;
    bool seed_fixed_ = false;
    lua_State* lua_ = nullptr;
    std::uint64_t used_ = 0;
    std::uint64_t limit_ = 0;
    bool spent_ = false;
    ScriptError spent_error_{};
    ScriptError memory_error_{};  ///< where a block was last refused
    ScriptError called_{};        ///< where the function that the program called last begins
    ScriptError raised_{};        ///< filled by the message handler
    ScriptError
        told_place_{};  ///< of an error from elsewhere: a text that was compiled, a coroutine
};

/// Raises `message` at the teacher's line.
[[noreturn]] void raise_in_lesson(lua_State* lua, const std::string& message);
/// The same at another place of the lesson's text, where something was declared.
[[noreturn]] void raise_at(lua_State* lua, const std::string& file, int line,
                           const std::string& message);

}  // namespace fulcrum::runtime
