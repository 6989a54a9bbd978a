#include "runtime/arms/haply/haply_message.h"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

namespace fulcrum::runtime {
namespace {

using HaplyJson = nlohmann::json;

// No Haply arm reaches further from its base, moves faster, or gives more: beyond that a number is garbled.
constexpr double kFarthest_m = 2.0;
constexpr double kFastest_m_per_s = 100.0;
constexpr double kStrongest_N = 1000.0;
constexpr double kLargestScale = 1.0e6;
constexpr double kTurnTolerance = 0.01;  // of a quaternion's length: figures are printed short
constexpr double kSameWithin = 1.0e-6;

// Reads the members of one object; the first that is not as it should be is kept as the reason.
class HaplyFields {
  public:
    HaplyFields(const HaplyJson& object, std::string& why) : object_(object), why_(why) {
        if (!object.is_object()) {
            complain("what should have members");
        }
    }

    [[nodiscard]] const HaplyJson* find(const char* name) const {
        const auto found = object_.is_object() ? object_.find(name) : object_.end();
        return object_.is_object() && found != object_.end() ? &*found : nullptr;
    }
    [[nodiscard]] std::optional<double> number(const char* name, double most) const {
        const HaplyJson* value = find(name);
        if (value == nullptr) {
            return std::nullopt;
        }
        if (value->is_number()) {
            const double number = value->get<double>();
            if (std::isfinite(number) && std::abs(number) <= most) {
                return number;
            }
        }
        complain(name);
        return std::nullopt;
    }
    [[nodiscard]] std::optional<bool> flag(const char* name) const {
        const HaplyJson* value = find(name);
        if (value != nullptr && !value->is_boolean()) {
            complain(name);
            return std::nullopt;
        }
        return value != nullptr ? std::optional(value->get<bool>()) : std::nullopt;
    }
    void word(const char* name, std::string& to) const {
        const HaplyJson* value = find(name);
        if (value == nullptr) {
            return;
        }
        if (value->is_string()) {
            to = value->get<std::string>();
        } else {
            complain(name);
        }
    }
    // What is left out is `rest`.
    [[nodiscard]] Vector3 vector(const char* name, double most, double rest = 0.0) const {
        const HaplyJson* value = find(name);
        if (value == nullptr) {
            return Vector3::Constant(rest);
        }
        const HaplyFields parts(*value, why_);
        return {parts.number("x", most).value_or(rest), parts.number("y", most).value_or(rest),
                parts.number("z", most).value_or(rest)};
    }
    [[nodiscard]] std::optional<Quaternion> turn(const char* name) const {
        const HaplyJson* value = find(name);
        if (value == nullptr) {
            return std::nullopt;
        }
        const HaplyFields parts(*value, why_);
        const auto part = [&](const char* one, double rest) {
            return parts.number(one, 1.0 + kTurnTolerance).value_or(rest);
        };
        const Quaternion turn(part("w", 1.0), part("x", 0.0), part("y", 0.0), part("z", 0.0));
        if (std::abs(turn.norm() - 1.0) > kTurnTolerance) {
            complain(name);
            return std::nullopt;
        }
        return turn.normalized();
    }
    [[nodiscard]] HaplyTransform transform(const char* name) const {
        HaplyTransform made;
        if (const HaplyJson* value = find(name)) {
            const HaplyFields parts(*value, why_);
            made.pose = {parts.vector("position", kFarthest_m * kLargestScale),
                         parts.turn("rotation").value_or(Quaternion::Identity())};
            made.scale = parts.vector("scale", kLargestScale, 1.0);
        }
        return made;
    }
    void complain(const char* name) const {
        if (why_.empty()) {
            why_ = name;
        }
    }

  private:
    const HaplyJson& object_;
    std::string& why_;
};

HaplyConfig read_haply_config(const HaplyJson& object, std::string& why) {
    HaplyConfig config;
    const HaplyFields fields(object, why);
    fields.word("type", config.type);
    fields.word("handedness", config.handedness);
    fields.word("preset", config.preset);
    config.mount = fields.transform("mount");
    if (const HaplyJson* basis = fields.find("basis")) {
        HaplyFields(*basis, why).word("permutation", config.basis);
    }
    if (const HaplyJson* filters = fields.find("filters")) {
        const HaplyFields both(*filters, why);
        if (const HaplyJson* gate = both.find("force_gate")) {
            config.gate_gain = HaplyFields(*gate, why).number("gain", kLargestScale);
        }
        if (const HaplyJson* damping = both.find("damping")) {
            config.damping_Ns_per_m = HaplyFields(*damping, why).number("scalar", kLargestScale);
        }
    }
    if (const HaplyJson* gravity = fields.find("gravity_compensation")) {
        const HaplyFields both(*gravity, why);
        config.compensates_gravity = both.flag("enabled");
        config.gravity_scale = both.number("scaling_factor", kLargestScale);
    }
    if (const HaplyJson* torque = fields.find("torque_scaling")) {
        config.scales_torque = HaplyFields(*torque, why).flag("enabled");
    }
    return config;
}

HaplyArm read_haply_arm(const HaplyJson& object, std::string& why) {
    HaplyArm arm;
    const HaplyFields fields(object, why);
    fields.word("device_id", arm.id);
    if (const HaplyJson* config = fields.find("config")) {
        arm.config = read_haply_config(*config, why);
    }
    const HaplyJson* state = fields.find("state");
    if (state == nullptr) {
        fields.complain("state");
        return arm;
    }
    const HaplyFields parts(*state, why);
    // It may be left out where it is zero, but zero lies inside the base.
    if (parts.find("cursor_position") == nullptr) {
        parts.complain("cursor_position");
    }
    arm.position_A = parts.vector("cursor_position", kFarthest_m);
    arm.velocity_A = parts.vector("cursor_velocity", kFastest_m_per_s);
    arm.echo_A = parts.vector("current_cursor_force", kStrongest_N);
    arm.transform = parts.transform("transform");
    if (const HaplyJson* status = fields.find("status")) {
        const HaplyFields said(*status, why);
        arm.status = {.is_calibrated = said.flag("calibrated"),
                      .is_in_use = said.flag("in_use"),
                      .has_power = said.flag("power_supply")};
    }
    return arm;
}

// Wired grips have one button; wireless ones a, b, c, or button_0 to 3, as their clients have them.
std::uint32_t read_haply_buttons(const HaplyFields& state, std::string& why) {
    struct Named {
        const char* name;
        unsigned bit;
    };
    static constexpr std::array kNames{
        Named{"a", 0},        Named{"b", 1},        Named{"c", 2},        Named{"home", 3},
        Named{"button_0", 0}, Named{"button_1", 1}, Named{"button_2", 2}, Named{"button_3", 3}};
    std::uint32_t pressed = state.flag("button").value_or(false) ? 1U : 0U;
    if (const HaplyJson* buttons = state.find("buttons")) {
        const HaplyFields each(*buttons, why);
        for (const Named& named : kNames) {
            pressed |= (each.flag(named.name).value_or(false) ? 1U : 0U) << named.bit;
        }
    }
    return pressed;
}

HaplyGrip read_haply_grip(const HaplyJson& object, std::string& why) {
    HaplyGrip grip;
    const HaplyFields fields(object, why);
    fields.word("device_id", grip.id);
    if (const HaplyJson* state = fields.find("state")) {
        const HaplyFields parts(*state, why);
        grip.orientation_A = parts.turn("orientation");
        grip.buttons = read_haply_buttons(parts, why);
    }
    if (const HaplyJson* status = fields.find("status")) {
        const HaplyFields said(*status, why);
        grip.is_awake = said.flag("awake").value_or(true) && said.flag("connected").value_or(true);
    }
    return grip;
}

template <class Item>
void read_haply_list(const HaplyJson& message, const char* name, std::string& why,
                     Item (*read)(const HaplyJson&, std::string&), std::vector<Item>& to) {
    const auto list = message.find(name);
    if (list == message.end()) {
        return;
    }
    if (!list->is_array()) {
        why = name;
        return;
    }
    for (const HaplyJson& item : *list) {
        to.push_back(read(item, why));
    }
}

// Where a scale of forces may stand, the nearest to its name first: alone or among all settings, in the envelope or without.
std::optional<double> find_haply_scale(const HaplyJson& json) {
    for (const char* name : {"/devices~1force_scale", "/devices/force_scale", "/force_scale", ""}) {
        for (const char* outer : {"/data", "/data/settings", "/settings", ""}) {
            for (const char* inner : {"/value", ""}) {
                const HaplyJson::json_pointer place(std::string(outer) + name + inner);
                if (json.contains(place) && json.at(place).is_number()) {
                    return json.at(place).get<double>();
                }
            }
        }
    }
    return std::nullopt;
}

// Never throws what is in the text; memory may still run out.
HaplyJson parse_haply_json(std::string_view text) {
    return HaplyJson::parse(text, nullptr, false);
}

}  // namespace

bool is_same(const HaplyTransform& a, const HaplyTransform& b) noexcept {
    const double turned = std::abs(a.pose.orientation.dot(b.pose.orientation));
    return (a.pose.position - b.pose.position).norm() <= kSameWithin &&
           (a.scale - b.scale).norm() <= kSameWithin && turned >= 1.0 - kSameWithin;
}

bool is_identity(const HaplyTransform& transform) noexcept {
    return is_same(transform, HaplyTransform{});
}

Expected<HaplyMessage> parse_haply_message(std::string_view text) {
    try {
        const HaplyJson json = parse_haply_json(text);
        if (!json.is_object()) {
            return fail("it sends text that is no message");
        }
        HaplyMessage message;
        std::string why;
        read_haply_list(json, "inverse3", why, read_haply_arm, message.arms);
        read_haply_list(json, "verse_grip", why, read_haply_grip, message.grips);
        read_haply_list(json, "wireless_verse_grip", why, read_haply_grip, message.grips);
        read_haply_list(json, "custom_verse_grip", why, read_haply_grip, message.grips);
        if (!why.empty()) {
            return fail("it sends a message whose " + why + " makes no sense");
        }
        return message;
    } catch (...) {
        return fail("it sends a message that cannot be read");
    }
}

std::string parse_haply_version(std::string_view text) {
    try {
        const HaplyJson json = parse_haply_json(text);
        // From 3.5 on answers may come in an envelope {ok, data}.
        const HaplyJson* object = &json;
        if (json.is_object() && json.contains("data")) {
            object = &json.at("data");
        }
        std::string why;
        std::string version;
        if (object->is_object()) {
            const HaplyFields fields(*object, why);
            fields.word("project_version", version);
            std::string tag;
            fields.word("git_tag", tag);
            version = tag.empty() ? version : tag;
        }
        return why.empty() ? version : std::string();
    } catch (...) {
        return {};
    }
}

std::optional<double> parse_haply_force_scale(std::string_view text) {
    try {
        const auto scale = find_haply_scale(parse_haply_json(text));
        return scale && std::isfinite(*scale) ? scale : std::nullopt;
    } catch (...) {
        return std::nullopt;
    }
}

}  // namespace fulcrum::runtime
