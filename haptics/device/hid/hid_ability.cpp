#include "haptics/device/hid/hid_ability.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace fulcrum::hid {
namespace {

constexpr std::array<Usage, 2> kSticks{usage_of(0x01, 0x04), usage_of(0x01, 0x05)};

void find_cap(HidAbility& ability) {
    auto cap = Cap::find(ability.descriptor);
    if (!cap) {
        ability.missing = cap.error().message;
        return;
    }
    ability.form = HandForm::space_mouse;
    ability.n_axes = cap->n_axes();
    ability.n_buttons = cap->n_buttons();
    ability.cap = std::move(*cap);
}

void find_stick(HidAbility& ability) {
    auto stick = Stick::find(ability.descriptor);
    if (!stick) {
        ability.missing = stick.error().message;
        return;
    }
    ability.form = HandForm::stick;
    ability.n_axes = stick->n_axes();
    ability.n_buttons = stick->n_buttons();
    ability.stick = std::move(*stick);
    if (!mentions_force(ability.descriptor)) {
        return;
    }
    if (const auto force = ForceLayout::find(ability.descriptor)) {
        ability.force = *force;
        ability.n_force_axes = (force->has_x ? 1 : 0) + (force->has_y ? 1 : 0);
    } else {
        ability.missing = force.error().message;
    }
}

// What is better comes first.
int rank(const HidAbility& ability) {
    return ability.n_force_axes > 0                ? 3
           : ability.form == HandForm::space_mouse ? 2
           : ability.form == HandForm::stick       ? 1
                                                   : 0;
}

std::string hexadecimal(std::uint16_t number) {
    std::array<char, 8> text{};
    std::snprintf(text.data(), text.size(), "%04x", number);
    return text.data();
}

// As the kernel writes it in a HID device's name: bus:vendor:product.number.
std::string in_capitals(std::uint16_t number) {
    std::array<char, 8> text{};
    std::snprintf(text.data(), text.size(), "%04X", number);
    return text.data();
}

tl::unexpected<Error> no_permission(const HidNode& node) {
    return fail(call(node) + " is there, but this user may not open it", node.path,
                "add the line " + udev_rule(node) + " to " + kUdevRules +
                    ", then unplug it and plug it in again");
}

}  // namespace

HidAbility find_ability(const HidNode& node) {
    HidAbility ability;
    auto descriptor = ReportDescriptor::parse(node.descriptor);
    if (!descriptor) {
        ability.missing = node.descriptor.empty() ? "its report descriptor cannot be read"
                                                  : to_sentence(descriptor.error());
    } else {
        ability.descriptor = std::move(*descriptor);
    }
    const auto& collections = ability.descriptor.collections();
    const auto has = [&](Usage usage) {
        return std::any_of(collections.begin(), collections.end(),
                           [&](const Collection& c) { return c.usage == usage; });
    };
    if (has(kMultiAxis)) {
        find_cap(ability);
    } else if (std::any_of(kSticks.begin(), kSticks.end(), has)) {
        find_stick(ability);
    }
    return ability;
}

std::string call(const HidNode& node) {
    return node.name.empty()
               ? "the device " + hexadecimal(node.vendor) + ":" + hexadecimal(node.product)
               : node.name;
}

Expected<HidNode> choose_hand(HidBus& bus, const std::string& path) {
    if (auto why = bus.why_never()) {
        return tl::unexpected(std::move(*why));
    }
    if (!path.empty()) {
        return bus.look(path).and_then([](HidNode&& node) -> Expected<HidNode> {
            if (!node.may_open) {
                return no_permission(node);
            }
            const HidAbility ability = find_ability(node);
            if (ability.form == HandForm::none) {
                return fail(call(node) + " is no hand" +
                                (ability.missing.empty() ? "" : ": " + ability.missing),
                            node.path, "fulcrum devices lists what can be used");
            }
            return std::move(node);
        });
    }
    std::vector<HidNode> nodes = bus.list();
    const auto by_rank = [](const HidNode& a, const HidNode& b) {
        return rank(find_ability(a)) < rank(find_ability(b));
    };
    std::vector<HidNode> open;
    std::copy_if(nodes.begin(), nodes.end(), std::back_inserter(open),
                 [](const HidNode& node) { return node.may_open; });
    const auto best = std::max_element(open.begin(), open.end(), by_rank);
    if (best != open.end() && rank(find_ability(*best)) > 0) {
        // As it is told when it is opened, so that it is known again.
        return bus.look(best->path);
    }
    const auto closed = std::max_element(nodes.begin(), nodes.end(), by_rank);
    if (closed != nodes.end() && rank(find_ability(*closed)) > 0) {
        return no_permission(*closed);
    }
    return fail("no SpaceMouse and no joystick is plugged in", {},
                "plug one in; fulcrum devices lists what is there");
}

std::string udev_rule(const HidNode& node) {
    return R"(KERNEL=="hidraw*", KERNELS=="*:)" + in_capitals(node.vendor) + ":" +
           in_capitals(node.product) + R"(.*", TAG+="uaccess")";
}

}  // namespace fulcrum::hid
