#include "runtime/lua/sandbox/script_state.h"

#include "runtime/lua/sandbox/lua_seed.h"
#include "runtime/lua/sandbox/plain_words.h"
#include "runtime/lua/sandbox/safe_library.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <new>

namespace fulcrum::runtime {
namespace {

constexpr int kHookEvery = 1000;                  // instructions between two looks
constexpr std::size_t kBytesAnInstruction = 128;  // what filling memory counts as
constexpr std::size_t kLargeBlockBytes = 16U << 10U;
constexpr int kDeepestCalls =
    20'000;  // calls within calls; Lua's own limit is ten times as far and takes 0.1 s to reach

std::size_t sane_memory(std::size_t bytes) {
    return std::clamp<std::size_t>(bytes, 1U << 20U, 256U << 20U);
}

void note_place(RunningLine& noted, std::string_view file, std::int32_t line) {
    const std::size_t n = std::min(file.size(), noted.file.size() - 1);
    std::copy_n(file.begin(), n, noted.file.begin());
    noted.file[n] = '\0';
    noted.line.store(line, std::memory_order_release);
}

}  // namespace

// ---- making and unmaking
// ------------------------------------------------------------------------------------------

ScriptState::ScriptState(ScriptSettings settings)
    : settings_(std::move(settings)), arena_(sane_memory(settings_.memory_bytes), settings_.slot) {
    lua_ = lua_newstate(&ScriptState::allocate, this);
    if (lua_ == nullptr) {
        throw std::bad_alloc();
    }
    *static_cast<ScriptState**>(lua_getextraspace(lua_)) = this;
    running = lua_;
    if (protect([](lua_State* lua) { open_safe_library(lua); })) {
        lua_close(lua_);
        throw std::bad_alloc();
    }
    lua_sethook(lua_, &ScriptState::on_count, LUA_MASKCOUNT, kHookEvery);
}

ScriptState::~ScriptState() {
    lua_close(lua_);
}

ScriptState& ScriptState::of(lua_State* lua) noexcept {
    return **static_cast<ScriptState**>(lua_getextraspace(lua));
}

void* ScriptState::allocate(void* self, void* block, std::size_t old_bytes,
                            std::size_t new_bytes) noexcept {
    auto& state = *static_cast<ScriptState*>(self);
    if (state.first_block_ != nullptr && !state.seed_tried_) {
        state.seed_tried_ = true;
        state.seed_fixed_ = fix_string_seed(state.first_block_, state.first_block_bytes_,
                                            &ScriptState::allocate, self);
    }
    if (block == nullptr) {
        old_bytes = 0;  // Lua passes a kind of object here
    }
    void* result = state.arena_.reallocate(block, old_bytes, new_bytes);
    if (state.first_block_ == nullptr) {
        state.first_block_ = static_cast<std::byte*>(result);
        state.first_block_bytes_ = new_bytes;
    }
    if (result == nullptr && new_bytes != 0 && state.running != nullptr) {
        state.note_memory_error();
    } else if (new_bytes > old_bytes && new_bytes >= kLargeBlockBytes) {
        state.count_large_block(new_bytes);
    }
    return result;
}

// ---- budget
// -------------------------------------------------------------------------------------------------------

void ScriptState::count_large_block(std::size_t bytes) noexcept {
    if (running == nullptr) {
        return;
    }
    lua_Debug activation{};
    for (int level = 0; level < 2 && lua_getstack(running, level, &activation) != 0; ++level) {
        note_line(running, &activation);
    }
    // An allocator may not raise errors; the hook does, at the next instruction.
    used_ += bytes / kBytesAnInstruction;
    if (limit_ != 0 && used_ > limit_) {
        lua_sethook(running, &ScriptState::on_count, LUA_MASKCOUNT, 1);
    }
}

void ScriptState::note_memory_error() {
    memory_error_ = place_of(running, 0);
    if (memory_error_.line == 0) {
        memory_error_ = place_of(running, 1);
    }
    lua_Debug activation{};
    memory_error_.message = lua_getstack(running, kDeepestCalls, &activation) != 0
                                ? in_plain_words("stack overflow")
                                : "this needs more memory than the " +
                                      std::to_string(arena_.capacity_bytes() >> 20U) +
                                      " MB that a lesson may have";
}

void ScriptState::begin_budget(std::uint64_t instructions) noexcept {
    used_ = 0;
    limit_ = instructions;
}

void ScriptState::charge(lua_State* lua, std::uint64_t work) {
    used_ += work;
    if (spent_ || (limit_ != 0 && used_ > limit_)) {
        raise_spent(lua);
    }
}

void ScriptState::check_spent(lua_State* lua) {
    if (spent_) {
        raise_spent(lua);
    }
}

void ScriptState::raise_spent(lua_State* lua) {
    if (!spent_) {
        spent_ = true;
        spent_error_ = place_in_lesson(lua);
        spent_error_.message = kTooLong;
    }
    lua_sethook(lua, &ScriptState::on_count, LUA_MASKCOUNT, 1);
    lua_sethook(lua_, &ScriptState::on_count, LUA_MASKCOUNT, 1);
    lua_pushstring(lua, kTooLong);
    lua_error(lua);
    std::abort();  // lua_error does not return
}

void ScriptState::on_count(lua_State* lua, lua_Debug* activation) {
    ScriptState& state = of(lua);
    state.note_line(lua, activation);
    state.charge(lua, static_cast<std::uint64_t>(lua_gethookcount(lua)));
    lua_Debug deepest{};
    if (lua_getstack(lua, kDeepestCalls, &deepest) != 0) {
        lua_getinfo(lua, "Sl", activation);
        lua_pushfstring(lua, "%s:%d: stack overflow", activation->short_src,
                        activation->currentline);
        lua_error(lua);
    }
}

void ScriptState::note_line(lua_State* lua, lua_Debug* activation) noexcept {
    RunningLine* noted = settings_.running_line;
    if (noted == nullptr || lua_getinfo(lua, "Sl", activation) == 0 ||
        activation->currentline <= 0 ||
        std::string_view(activation->short_src).starts_with(kLibraryFolder)) {
        return;
    }
    note_place(*noted, activation->short_src, activation->currentline);
}

// ---- running
// ------------------------------------------------------------------------------------------------------

namespace {
struct ProtectedCall {
    void (*body)(lua_State*, void*);
    void* self;
};
int run_body(lua_State* lua) {
    const auto* call = static_cast<const ProtectedCall*>(lua_touserdata(lua, 1));
    lua_settop(lua, 0);
    call->body(lua, call->self);
    return 0;
}
}  // namespace

std::optional<ScriptError> ScriptState::run_protected(RawBody body, void* self) {
    ProtectedCall call{body, self};
    lua_settop(lua_, 0);
    lua_pushcfunction(lua_, &ScriptState::on_error);
    lua_pushcfunction(lua_, &run_body);
    lua_pushlightuserdata(lua_, &call);
    raised_ = {};
    told_place_ = {};
    running = lua_;
    const int status = lua_pcall(lua_, 1, 0, 1);
    running = lua_;
    std::optional<ScriptError> failure;
    if (status != LUA_OK) {
        failure = describe_failure(status);
    }
    lua_settop(lua_, 0);
    return failure;
}

int ScriptState::on_error(lua_State* lua) {
    ScriptState& state = of(lua);
    ScriptError error = place_in_lesson(lua);
    if (error.line == 0) {
        error = state.called_;
    }
    if (lua_type(lua, 1) == LUA_TSTRING) {
        std::size_t n = 0;
        const char* text = lua_tolstring(lua, 1, &n);
        error.message.assign(text, n);
        // A place in front of it counts where it is true; whatever else stands there is a part of the text.
        ScriptError told;
        if (split_place(std::string_view(text, n), told) &&
            (are_same_place(told, state.told_place_) || runs_at(lua, told))) {
            error = told;
        }
        if (in_one_line(error.message).empty()) {
            error.message = "the script raised an error without a text";
        }
    } else {
        error.message = std::string("the script raised an error that is a ") +
                        luaL_typename(lua, 1) + ", not a text";
    }
    state.raised_ = error;
    return 1;
}

void ScriptState::note_failure(lua_State* coroutine) {
    std::size_t n = 0;
    const char* text =
        lua_type(coroutine, -1) == LUA_TSTRING ? lua_tolstring(coroutine, -1, &n) : nullptr;
    ScriptError told;
    if (text != nullptr && split_place({text, n}, told) && runs_at(coroutine, told)) {
        told_place_ = told;
    }
}

ScriptError ScriptState::describe_failure(int status) {
    ScriptError error = raised_;
    if (spent_) {
        error = spent_error_;
    } else if (status == LUA_ERRMEM) {
        error = memory_error_;
    } else if (error.message.empty()) {
        const char* text = lua_type(lua_, -1) == LUA_TSTRING ? lua_tostring(lua_, -1) : nullptr;
        error.message = text != nullptr ? text : "the script failed";
    }
    if (error.message == "not enough memory") {  // caught by the script and raised again
        error.message = memory_error_.message;
    }
    error.message = in_one_line(clean_text(in_plain_words(error.message), 400));
    return error;
}

void ScriptState::load_text(lua_State* lua, const LuaSource& source) {
    // Compiling is work too: about an instruction a byte.
    charge(lua, source.text.size());
    const std::string chunk_name = "@" + source.name;
    const int status =
        luaL_loadbufferx(lua, source.text.data(), source.text.size(), chunk_name.c_str(), "t");
    if (status == LUA_OK) {
        return;
    }
    ScriptError placed;
    std::size_t n = 0;
    const char* message = lua_tolstring(lua, -1, &n);
    // Where the compiler itself gave up, it names no place.
    if (message != nullptr && !split_place({message, n}, placed)) {
        raise_at(lua, source.name, 1, message);
    } else if (const auto brace = find_missing_brace(source.text, placed.line)) {
        raise_at(lua, source.name, brace->line,
                 "the { behind " + clean_text(brace->call, kMaxNameBytes) + " is missing");
    }
    told_place_ = placed;
    lua_error(lua);
}

void ScriptState::call(lua_State* lua, int n_arguments, int n_results) {
    // Until the hook first looks, the script is where the function begins.
    lua_Debug activation{};
    lua_pushvalue(lua, -(n_arguments + 1));
    if (lua_getinfo(lua, ">S", &activation) != 0 && activation.linedefined >= 0) {
        called_.file = activation.short_src;
        called_.line = std::max(activation.linedefined, 1);
        if (settings_.running_line != nullptr) {
            note_place(*settings_.running_line, called_.file, called_.line);
        }
    }
    lua_call(lua, n_arguments, n_results);
}

void raise_in_lesson(lua_State* lua, const std::string& message) {
    const ScriptError place = place_in_lesson(lua);
    if (place.line > 0) {
        raise_at(lua, place.file, place.line, message);
    }
    lua_pushlstring(lua, message.data(), message.size());
    lua_error(lua);
    std::abort();  // lua_error does not return
}

void raise_at(lua_State* lua, const std::string& file, int line, const std::string& message) {
    ScriptState::of(lua).note_true_place({{}, clean_text(file, kMaxNameBytes), line});
    lua_pushfstring(lua, "%s:%d: %s", file.c_str(), line, message.c_str());
    lua_error(lua);
    std::abort();  // lua_error does not return
}

}  // namespace fulcrum::runtime
