// A maker's library, opened while the program runs: nothing of it is needed to build, and where it is not installed none of it is run.
//
// It is looked for by the names that it is known by, or at the one place that the user gave, and must have each function of a table
// that is not optional. It stays loaded until the program ends: such libraries keep threads of their own, and do not bear being opened a
// second time.
//
// Thread: who opens an arm. Cost: loads a file and runs what its maker has it do then.
// Source: dlopen(3), dlsym(3).
#pragma once

#include "haptics/base/error.h"

#include <span>
#include <string>
#include <vector>

namespace fulcrum::runtime {

/// Which library it is, and how people come by it.
struct MakerLibrary {
    std::string called;               ///< for people: "the library of …"
    std::vector<std::string> names;   ///< as dlopen takes them, the best first
    std::string path;                 ///< of the user's own choice; empty: none, the names count
    std::string how_to_get;           ///< a clause: "install …"
    std::vector<std::string> before;  ///< libraries that it uses without saying so: opened first
    /// It is opened lazily, with names that all may use, as one must be that has names which nobody defines.
    bool is_lazy_and_global = false;
};

/// A function that a table wants, and where its address goes. Made by `required` and `if_there`.
struct MakerFunction {
    const char* name = "";
    bool is_optional = false;
    void* slot = nullptr;  ///< a pointer to a function, null before
    void (*put)(void* slot, void* address) = nullptr;
};

/// A function without which the library is of no use.
template <class Function>
[[nodiscard]] MakerFunction required(const char* name, Function*& slot) noexcept {
    return {name, false, &slot, [](void* to, void* address) {
                *static_cast<Function**>(to) = reinterpret_cast<Function*>(address);
            }};
}
/// One that older libraries lack: the slot stays null then.
template <class Function>
[[nodiscard]] MakerFunction if_there(const char* name, Function*& slot) noexcept {
    MakerFunction function = required(name, slot);
    function.is_optional = true;
    return function;
}

/// Fills the slots of `table`, and gives the name by which the library was found. Refuses one that is not there, does not load or
/// lacks a function, in one sentence that says which and what to install; no slot is of use then.
[[nodiscard]] Expected<std::string> open_maker_library(const MakerLibrary& library,
                                                       std::span<const MakerFunction> table);

}  // namespace fulcrum::runtime
