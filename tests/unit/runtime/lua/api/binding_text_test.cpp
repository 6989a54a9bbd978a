#include "runtime/lua/api/binding_table.h"
#include "tests/unit/runtime/lua/library_texts.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>

namespace fulcrum::runtime {
namespace {

std::string read_text(const std::string& path) {
    std::ifstream file(std::string(FULCRUM_SOURCE_DIR) + path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

TEST_CASE(
    "bindings: annotations and reference are up to date (lesson_process_helper --write-meta "
    "scripts/meta writes them)") {
    CHECK(read_text("/scripts/meta/fulcrum.lua") == make_annotations(api_table()));
    CHECK(read_text("/scripts/meta/reference.md") ==
          make_reference(api_table(), test::read_library(FULCRUM_SOURCE_DIR "/scripts/lib")));
}

TEST_CASE("bindings: every function and field stands in both texts") {
    const std::string annotations = make_annotations(api_table());
    const std::string reference =
        make_reference(api_table(), test::read_library(FULCRUM_SOURCE_DIR "/scripts/lib"));
    std::set<std::string> names;
    for (const Binding& binding : api_table().functions) {
        CHECK(names.insert(std::string(binding.owner) + ':' + binding.name).second);
        CHECK_THAT(annotations, Catch::Contains(std::string(binding.name) + "("));
        CHECK_THAT(reference, Catch::Contains(binding.text));
        CHECK(binding.call != nullptr);
        for (const Parameter& parameter : binding.parameters) {
            CHECK(parameter.low <= parameter.high);
        }
    }
    for (const Property& property : api_table().properties) {
        CHECK(names.insert(std::string(property.owner) + ':' + property.name).second);
        CHECK_THAT(annotations, Catch::Contains(std::string("---@field ") + property.name + ' '));
    }
}

}  // namespace
}  // namespace fulcrum::runtime
