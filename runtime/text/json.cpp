#include "runtime/text/json.h"

#include <cassert>
#include <nlohmann/json.hpp>

namespace fulcrum::runtime {

Json Json::array(std::initializer_list<Json> items) {
    Json json;
    json.value_ = Array{};
    json.items_ = items;
    return json;
}

Json Json::object(std::initializer_list<Member> members) {
    Json json;
    json.value_ = Object{};
    for (const Member& member : members) {
        json.add(member.first, member.second);
    }
    return json;
}

void Json::push_back(Json item) {
    assert(std::holds_alternative<Array>(value_));
    items_.push_back(std::move(item));
}

void Json::add(const char* name, Json value) {
    assert(std::holds_alternative<Object>(value_));
    names_.emplace_back(name);
    items_.push_back(std::move(value));
}

// As deep as what is told, which this program's own sources decide.
// NOLINTBEGIN(misc-no-recursion)
struct JsonWriter {
    using Written = nlohmann::ordered_json;

    const Json& json;

    Written operator()(std::monostate) const { return nullptr; }
    Written operator()(bool value) const { return value; }
    Written operator()(double value) const { return value; }
    Written operator()(std::int64_t value) const { return value; }
    Written operator()(const std::string& value) const { return value; }
    Written operator()(Json::Array) const {
        Written written = Written::array();
        for (const Json& item : json.items_) {
            written.push_back(write(item));
        }
        return written;
    }
    Written operator()(Json::Object) const {
        Written written = Written::object();
        for (std::size_t i = 0; i < json.items_.size(); ++i) {
            written[json.names_[i]] = write(json.items_[i]);
        }
        return written;
    }
    static Written write(const Json& json) { return std::visit(JsonWriter{json}, json.value_); }
};
// NOLINTEND(misc-no-recursion)

std::string Json::to_text() const {
    return JsonWriter::write(*this).dump(2, ' ', false,
                                         JsonWriter::Written::error_handler_t::replace) +
           "\n";
}

}  // namespace fulcrum::runtime
