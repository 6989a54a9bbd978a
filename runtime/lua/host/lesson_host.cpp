#include "runtime/lua/host/lesson_host.h"

#include "runtime/lua/api/needs.h"
#include "runtime/lua/api/sound_names.h"

#include <algorithm>
#include <utility>

namespace fulcrum::runtime {
namespace {

constexpr int kLessonSlot = 0;
constexpr int kFirstHandSlot = 1;

/// Pushes the lesson's function `name` and the lesson itself; false, and nothing pushed, when there is none.
bool push_callback(lua_State* lua, const LessonContext& context, const char* name) {
    lua_rawgeti(lua, LUA_REGISTRYINDEX, context.lesson_ref);
    lua_pushstring(lua, name);
    const int kind = lua_rawget(lua, -2);
    if (kind == LUA_TFUNCTION) {
        lua_insert(lua, -2);
        return true;
    }
    lua_pop(lua, 2);
    if (kind != LUA_TNIL) {
        raise_in_lesson(lua, std::string("L.") + name +
                                 " is no function; write function L:" + name + "(…) … end");
    }
    return false;
}

/// The number of the last line with anything on it.
int last_line(const std::string& text) {
    const std::size_t end = text.find_last_not_of(" \t\r\n");
    const auto begin = text.begin();
    return 1 +
           static_cast<int>(std::count(
               begin, end == std::string::npos ? begin : begin + static_cast<std::ptrdiff_t>(end),
               '\n'));
}

/// The file must end with `return L`.
void check_returned_lesson(lua_State* lua, const LessonContext& context, const LuaSource& source) {
    if (context.lesson_ref == LUA_NOREF) {
        raise_at(lua, source.name, 1,
                 "this file makes no lesson; begin with local L = lesson { id = …, title = … }");
    }
    lua_rawgeti(lua, LUA_REGISTRYINDEX, context.lesson_ref);
    if (lua_rawequal(lua, -1, -2) == 0) {
        raise_at(lua, source.name, last_line(source.text),
                 "the file must end with return L, the lesson that lesson { … } gave");
    }
    lua_pop(lua, 1);
}

/// Sounds that the text names are checked before the first of them is played.
void check_sounds(lua_State* lua, const LuaSource& source) {
    for (const SoundUse& use : find_sounds(source.text)) {
        if (const std::string problem = sound_problem(use.name); !problem.empty()) {
            raise_at(lua, source.name, use.line, problem);
        }
    }
}

}  // namespace

LessonHost::LessonHost(const LoadMessage& message, HostServices services)
    : message_(message), services_(std::move(services)) {
    lesson_script_ = std::make_unique<ScriptState>(settings_for(kLessonSlot, lesson_));
    lesson_script_->context = &lesson_;
    for (std::size_t i = 0; i < hands_.size(); ++i) {
        if (source_of_hand(message_, i).name.empty()) {
            continue;
        }
        LessonContext& context = hands_[i].context;
        context.is_hand = true;
        context.generation = 2;
        hands_[i].script = std::make_unique<ScriptState>(
            settings_for(kFirstHandSlot + static_cast<int>(i), context));
        hands_[i].script->context = &context;
    }
}

ScriptSettings LessonHost::settings_for(int slot, LessonContext& context) {
    ScriptSettings settings;
    settings.slot = slot;
    settings.memory_bytes = message_.memory_bytes;
    settings.seed = message_.seed;
    settings.running_line = services_.running_line;
    settings.find_module = [this](const std::string& name) {
        return loaded_ ? ModuleAnswer{false,
                                      {},
                                      "modules are loaded with the lesson; write this at the top "
                                      "of the file"}
                       : services_.find_module(name);
    };
    settings.print = [this, &context](std::string text) { print(context, std::move(text)); };
    return settings;
}

void LessonHost::print(LessonContext& context, std::string text) {
    if (++context.n_prints > kMaxPrintsAFrame) {
        return;
    }
    if (context.n_prints == kMaxPrintsAFrame) {
        text = "… (this prints too much; the rest of this frame is left out)";
    }
    if (!loaded_) {
        services_.print_while_loading(text);
    } else if (lesson_.reply.commands.size() + 2 < kMaxCommands) {
        lesson_.reply.commands.emplace_back(PrintCommand{std::move(text)});
    }
}

// ---- loading ------------------------------------------------------------------------------------------------------

std::optional<ScriptError> LessonHost::load() {
    if (auto error = load_lesson()) {
        return error;
    }
    for (std::size_t i = 0; i < hands_.size(); ++i) {
        if (hands_[i].script == nullptr) {
            continue;
        }
        if (auto error = load_hand(i)) {
            return error;
        }
    }
    loaded_ = true;
    lesson_.phase = LessonPhase::running;
    return std::nullopt;
}

std::optional<ScriptError> LessonHost::load_lesson() {
    ScriptState& script = *lesson_script_;
    script.begin_budget(message_.load_instructions);
    return script.protect([&](lua_State* lua) {
        register_api(lua);
        script.load_text(lua, message_.lesson);
        script.call(lua, 0, 1);
        check_returned_lesson(lua, lesson_, message_.lesson);
        check_sounds(lua, message_.lesson);
        lesson_.phase = LessonPhase::starting;
        if (push_callback(lua, lesson_, "start")) {
            push_handle(lua, Handle::Kind::world, 0);
            script.call(lua, 2, 0);
        }
        if (const auto unmet = find_unmet(lua, lesson_)) {
            raise_at(lua, unmet->file, unmet->line, unmet->message);
        }
    });
}

// ---- a frame ------------------------------------------------------------------------------------------------------

bool LessonHost::frame_fits(const LessonFrame& frame) const {
    const auto n_bodies = static_cast<std::int32_t>(description().bodies.size());
    for (const LessonEvent& event : frame.events) {
        const auto* about_body = std::get_if<BodyEvent>(&event);
        if (about_body != nullptr && (about_body->body < 0 || about_body->body >= n_bodies)) {
            return false;
        }
    }
    return std::cmp_equal(frame.bodies.size(), n_bodies);
}

std::optional<ScriptError> LessonHost::run_frame(const LessonFrame& frame, LessonReply& reply) {
    if (!frame_fits(frame)) {
        return ScriptError{"the program sent a frame of another scene", "", 0};
    }
    lesson_.frame = frame;
    lesson_.n_prints = 0;
    lesson_script_->begin_budget(message_.frame_instructions);
    if (auto error = lesson_script_->protect([&](lua_State* lua) { run_callbacks(lua); })) {
        return error;
    }
    reply = std::exchange(lesson_.reply, {});  // what start() asked for goes out with the first
    for (std::size_t i = 0; i < hands_.size() && !frame.only_asks; ++i) {
        if (hands_[i].script == nullptr) {
            continue;
        }
        if (auto error = run_hand(i, frame, reply)) {
            return error;
        }
    }
    return std::nullopt;
}

void LessonHost::run_callbacks(lua_State* lua) {
    ScriptState& script = *lesson_script_;
    for (const LessonEvent& event : lesson_.frame.events) {
        deliver(lua, event);
    }
    if (lesson_.frame.only_asks) {
        return;
    }
    if (push_callback(lua, lesson_, "update")) {
        push_handle(lua, Handle::Kind::world, 0);
        lua_pushnumber(lua, lesson_.frame.dt_s);
        script.call(lua, 3, 0);
    }
    for (std::size_t i = 0; i < lesson_.listeners.size(); ++i) {
        lua_rawgeti(lua, LUA_REGISTRYINDEX, lesson_.listeners[i]);
        lua_newtable(lua);
        lua_pushstring(lua, "update");
        lua_setfield(lua, -2, "name");
        lua_pushnumber(lua, lesson_.frame.dt_s);
        lua_setfield(lua, -2, "dt");
        script.call(lua, 1, 0);
    }
    if (lesson_.force_function_ref != LUA_NOREF) {
        lesson_.reply.commands.emplace_back(
            LessonForceCommand{linearise_force(lua, lesson_, lesson_.force_function_ref)});
    }
}

void LessonHost::judge_answer(lua_State* lua, const std::string& asked, const LessonEvent& event) {
    for (const auto& [question, right_ref] : lesson_.judges) {
        if (question == asked) {
            lua_rawgeti(lua, LUA_REGISTRYINDEX, right_ref);
            push_event(lua, lesson_, event);
            lesson_script_->call(lua, 1, 1);
            const bool right = lua_toboolean(lua, -1) != 0;
            lua_pop(lua, 1);
            add_command(lua, VerdictCommand{question, right});
        }
    }
}

// What a learner asks for, by the lesson's own function.
void LessonHost::tell(lua_State* lua, const AskedEvent& asked) {
    for (const auto& [knowledge, answer_ref] : lesson_.tellers) {
        if (knowledge != asked.knowledge) {
            continue;
        }
        lua_rawgeti(lua, LUA_REGISTRYINDEX, answer_ref);
        push_event(lua, lesson_, asked);
        push_handle(lua, Handle::Kind::world, 0);
        lesson_script_->call(lua, 2, 1);
        std::string text;
        if (lua_type(lua, -1) == LUA_TSTRING) {
            text = clean_text(lua_tostring(lua, -1), kMaxTextBytes);
        } else if (!lua_isnil(lua, -1)) {
            raise_in_lesson(lua, "what the lesson knows as \"" + knowledge +
                                     "\" is answered with a text, or nil; got " +
                                     given_text(lua, -1));
        }
        lua_pop(lua, 1);
        add_command(lua, TellCommand{knowledge, std::move(text)});
    }
}

void LessonHost::deliver(lua_State* lua, const LessonEvent& event) {
    ScriptState& script = *lesson_script_;
    if (const auto* ready = std::get_if<ReadyEvent>(&event)) {
        lesson_.felt_weight_N = ready->felt_weight_N;
        lesson_.felt_weight_N.resize(description().bodies.size(), 0.0);
        lesson_.day = ready->day;
        lesson_.past = ready->past;
        lesson_.lessons = ready->lessons;
        lesson_.grades = ready->materials;
        lesson_.grades.resize(description().materials.size());
        return;
    }
    if (const auto* judge = std::get_if<JudgeEvent>(&event)) {
        judge_answer(lua, judge->question, event);
        return;
    }
    if (const auto* asked = std::get_if<AskedEvent>(&event)) {
        tell(lua, *asked);
        return;
    }
    if (const auto* about = std::get_if<BodyEvent>(&event);
        about != nullptr && about->kind == BodyEvent::Kind::touched) {
        lesson_.touched = about->body;
    }
    // The lesson's own function first, in its own words; then whoever listens.
    push_event(lua, lesson_, event);
    lua_getfield(lua, -1, "name");
    const std::string name = lua_tostring(lua, -1);
    lua_pop(lua, 1);
    if (push_callback(lua, lesson_, name.c_str())) {
        int n_arguments = 2;
        if (name == "key" || name == "answered") {
            lua_pushvalue(lua, -3);
            if (name == "key") {
                lua_getfield(lua, -1, "key");
                lua_remove(lua, -2);
            }
        } else {
            lua_getfield(lua, -3, "body");
            lua_getfield(lua, -4, "speed");
            ++n_arguments;
        }
        script.call(lua, n_arguments, 0);
    }
    for (std::size_t i = 0; i < lesson_.listeners.size(); ++i) {
        lua_rawgeti(lua, LUA_REGISTRYINDEX, lesson_.listeners[i]);
        lua_pushvalue(lua, -2);
        script.call(lua, 1, 0);
    }
    lua_pop(lua, 1);
}

}  // namespace fulcrum::runtime
