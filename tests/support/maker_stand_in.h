// A copy of a library that stands in for a maker's (tests/support/maker_libraries), and what a test does with the arm in it.
#pragma once

#include "tests/support/scratch_folder.h"

#include <dlfcn.h>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace fulcrum::test_support {

/// A copy of its own has an arm of its own, however many tests run in one program. Nothing closes it: a port's thread may still be in it.
class MakerStandIn {
  public:
    explicit MakerStandIn(const char* built) : path_(folder_.file("library.so")) {
        std::filesystem::copy_file(built, path_);
        void* library = ::dlopen(path_.c_str(), RTLD_LAZY | RTLD_LOCAL);
        if (library == nullptr) {
            throw std::runtime_error(::dlerror());
        }
        set_ = reinterpret_cast<Set*>(::dlsym(library, "stand_in_set"));
        get_ = reinterpret_cast<Get*>(::dlsym(library, "stand_in_get"));
    }

    [[nodiscard]] const std::string& path() const { return path_; }
    void set(const char* what, double value) const { set_(what, value); }
    [[nodiscard]] double get(const char* what) const { return get_(what); }
    /// Of the axis "x", "y" or "z" of frame D.
    [[nodiscard]] double get(const char* what, const char* axis) const {
        return get_((std::string(what) + " " + axis).c_str());
    }

  private:
    using Set = void(const char*, double);
    using Get = double(const char*);

    ScratchFolder folder_;
    std::string path_;
    Set* set_ = nullptr;
    Get* get_ = nullptr;
};

}  // namespace fulcrum::test_support
