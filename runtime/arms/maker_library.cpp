#include "runtime/arms/maker_library.h"

#include <dlfcn.h>
#include <string_view>

namespace fulcrum::runtime {
namespace {

struct OpenedLibrary {
    void* handle = nullptr;
    std::string name;
};

std::string tell_load_error() {
    const char* said = ::dlerror();
    return said != nullptr ? said : "nobody says why";
}

// What the system says of a file that is not there begins with its name; of one that lacks another file, with that one's.
bool is_absent(const std::string& said, const std::string& name) {
    return said.starts_with(name + ": cannot open shared object file: No such file");
}

std::string list_names(const std::vector<std::string>& names) {
    std::string all;
    for (const std::string& name : names) {
        all += (all.empty() ? "" : ", ") + name;
    }
    return all;
}

Expected<OpenedLibrary> open_first(const MakerLibrary& library) {
    const bool is_chosen = !library.path.empty();
    const std::vector<std::string> names =
        is_chosen ? std::vector<std::string>{library.path} : library.names;
    const int mode = library.is_lazy_and_global ? RTLD_LAZY | RTLD_GLOBAL : RTLD_NOW | RTLD_LOCAL;
    for (const std::string& name : names) {
        (void)::dlerror();
        if (void* handle = ::dlopen(name.c_str(), mode)) {
            return OpenedLibrary{handle, name};
        }
        const std::string why = tell_load_error();
        if (!is_absent(why, name)) {
            return fail(library.called + " does not load: " + why, is_chosen ? library.path : "",
                        library.how_to_get);
        }
    }
    if (is_chosen) {
        return fail("no library lies there", library.path,
                    "give the file that is " + library.called + ", or " + library.how_to_get);
    }
    return fail(library.called + " is not installed: there is no " + list_names(names), {},
                library.how_to_get);
}

}  // namespace

Expected<std::string> open_maker_library(const MakerLibrary& library,
                                         std::span<const MakerFunction> table) {
    for (const std::string& name : library.before) {
        // Where it is missing the library itself says so, if it needs it at all.
        (void)::dlopen(name.c_str(), RTLD_LAZY | RTLD_GLOBAL);
    }
    const auto opened = open_first(library);
    if (!opened) {
        return tl::unexpected(opened.error());
    }
    for (const MakerFunction& function : table) {
        void* address = ::dlsym(opened->handle, function.name);
        if (address == nullptr && !function.is_optional) {
            return fail(library.called + " has no function " + function.name +
                            ": it is too old, or another library",
                        opened->name, library.how_to_get);
        }
        function.put(function.slot, address);
    }
    return opened->name;
}

}  // namespace fulcrum::runtime
