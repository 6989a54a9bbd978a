#include "tests/support/haply_answers.h"

#include <nlohmann/json.hpp>
#include <sstream>

namespace fulcrum::test_support {
namespace {

using Text = nlohmann::json;

// {x, y, z}, without those that are `rest` where they are left out.
Text vector_of(const HaplyOptions& options, const Vector3& v, double rest = 0.0) {
    Text text = Text::object();
    const char* const names[] = {"x", "y", "z"};
    for (int i = 0; i < 3; ++i) {
        if (!options.leaves_out || v[i] != rest) {
            text[names[i]] = v[i];
        }
    }
    return text;
}

Text turn_of(const HaplyOptions& options, const Quaternion& q) {
    Text text = vector_of(options, q.vec());
    if (!options.leaves_out || q.w() != 1.0) {
        text["w"] = q.w();
    }
    return text;
}

Text transform_of(const HaplyOptions& options, double scale) {
    return {{"position", vector_of(options, Vector3::Zero())},
            {"rotation", turn_of(options, Quaternion::Identity())},
            {"scale", vector_of(options, Vector3::Constant(scale), 1.0)}};
}

Text config_of(const HaplyOptions& options, const std::string& id) {
    Text config = {
        {"type", options.type},
        {"port", "/dev/ttyACM0"},
        {"device_info", {{"id", id}, {"major_version", 7}, {"minor_version", 4}, {"uuid", "none"}}},
        {"gravity_compensation", {{"enabled", true}, {"scaling_factor", 1.0}}},
        {"handedness", options.handedness},
        {"streaming_mode", "USB"},
        {"torque_scaling", {{"enabled", true}}},
        {"home_return", {{"enabled", false}}},
        {"preset", options.preset},
        {"filters",
         {{"force_gate", {{"gain", options.gate_gain}}}, {"damping", {{"scalar", 0.0}}}}}};
    if (!options.leaves_out || options.basis != "XYZ") {
        config["basis"] = {{"permutation", options.basis}};
    }
    if (!options.leaves_out || options.mount_scale != 1.0) {
        config["mount"] = transform_of(options, options.mount_scale);
    }
    return config;
}

Text state_of(const HaplyOptions& options, const StandInState& state) {
    const Text angles = {{"a0", 0.0}, {"a1", 40.0}, {"a2", 120.0}};
    Text text = {{"cursor_position", vector_of(options, to_session(options, state.position_A))},
                 {"cursor_velocity", vector_of(options, to_session(options, state.velocity_A))},
                 {"body_orientation", turn_of(options, Quaternion::Identity())},
                 {"angular_position", angles},
                 {"angular_velocity", angles},
                 {"control_domain", "cartesian"},
                 {options.speaks_3_0 ? "mode" : "control_mode", "force"}};
    const Vector3 echo_A = options.echoes ? state.force_A : Vector3::Zero();
    if (!options.leaves_out || echo_A != Vector3::Zero()) {
        // A swap undoes itself.
        text["current_cursor_force"] = vector_of(options, turn_to_base(options, echo_A));
    }
    if (!options.speaks_3_0 && (!options.leaves_out || options.transform_scale != 1.0)) {
        text["transform"] = transform_of(options, options.transform_scale);
    }
    if (options.has_no_number) {
        text["cursor_position"]["y"] = nullptr;
    }
    return text;
}

void add_grip(const HaplyOptions& options, const StandInState& state, Text& message) {
    if (options.grip == StandInGrip::none) {
        return;
    }
    Text text = {{"device_id", "6123"},
                 {"state", {{"orientation", turn_of(options, state.grip_A)}, {"hall", 0}}}};
    if (options.grip == StandInGrip::wired) {
        text["state"]["button"] = options.grip_buttons == "a";
        message["verse_grip"] = Text::array({text});
        return;
    }
    Text buttons = {{"a", false}, {"b", false}, {"c", false}};
    std::istringstream names(options.grip_buttons);
    for (std::string name; std::getline(names, name, ',');) {
        buttons[name] = true;
    }
    text["state"]["buttons"] = buttons;
    text["state"]["battery_level"] = 0.8;
    text["status"] = {
        {"awake", options.grip != StandInGrip::asleep}, {"connected", true}, {"ready", true}};
    message["wireless_verse_grip"] = Text::array({text});
}

void add_force(const Text& command, const char* word, std::optional<Vector3>& force) {
    if (!command.contains(word)) {
        return;
    }
    const Text& v = command.at(word);
    force = force.value_or(Vector3::Zero()) +
            Vector3(v.value("x", 0.0), v.value("y", 0.0), v.value("z", 0.0));
}

}  // namespace

Vector3 to_session(const HaplyOptions& options, const Vector3& v_A) {
    return options.mount_scale * turn_to_base(options, v_A);
}

Vector3 turn_to_base(const HaplyOptions& options, const Vector3& force) {
    return options.basis == "XZY" ? Vector3(force.x(), force.z(), force.y()) : force;
}

std::string make_state_text(const HaplyOptions& options, const StandInState& state, bool is_full) {
    Text message = {{"session_id", 7}, {"inverse3", Text::array()}};
    for (const std::string& id : options.ids) {
        Text arm = {{"device_id", id}, {"state", state_of(options, state)}};
        if (is_full) {
            arm["config"] = config_of(options, id);
        }
        if (!options.speaks_3_0) {
            arm["status"] = {{"calibrated", options.is_calibrated},
                             {"in_use", options.is_in_use},
                             {"power_supply", options.has_power},
                             {"ready", true},
                             {"started", true}};
        }
        message["inverse3"].push_back(arm);
    }
    add_grip(options, state, message);
    const std::string text = message.dump();
    return options.is_malformed ? text.substr(0, text.size() / 2) : text;
}

StandInOrder read_order_text(const HaplyOptions& options, std::string_view text) {
    StandInOrder order;
    const Text message = Text::parse(text, nullptr, false);
    if (!message.is_object()) {
        return order;
    }
    order.is_message = true;
    order.wants_all =
        message.contains("session") && message["session"].contains("force_render_full_state");
    for (const Text& arm : message.value("inverse3", Text::array())) {
        const bool is_here = !options.ids.empty() && arm.value("device_id", "") == options.ids[0];
        if (!is_here || !arm.contains("commands") ||
            !arm["commands"].contains("set_cursor_force")) {
            continue;
        }
        const Text& command = arm["commands"]["set_cursor_force"];
        if (options.takes_vector) {
            add_force(command, "vector", order.force_A);
        }
        if (options.takes_values) {
            add_force(command, "values", order.force_A);
        }
    }
    return order;
}

std::string answer_get(const HaplyOptions& options, std::string_view path) {
    Text body;
    if (path == "/version") {
        body = {{"project_name", "haply-inverse-service"},
                {"project_version", options.version + ".0"},
                {"git_tag", options.version},
                {"git_describe", options.version + "-2-gce34c39e"}};
    } else if (path == "/settings/devices/force_scale" && options.force_scale) {
        body = {{"ok", true}, {"data", {{"value", *options.force_scale}, {"type_hint", "FLOAT"}}}};
    }
    const std::string text =
        body.is_null() ? R"({"ok":false,"error":"no such route"})" : body.dump();
    return std::string("HTTP/1.1 ") + (body.is_null() ? "404 Not Found" : "200 OK") +
           "\r\nContent-Type: application/json\r\nContent-Length: " + std::to_string(text.size()) +
           "\r\nConnection: close\r\n\r\n" + text;
}

}  // namespace fulcrum::test_support
