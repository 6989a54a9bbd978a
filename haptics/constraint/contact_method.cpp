#include "haptics/constraint/contact_method.h"

#include "haptics/base/range.h"

#include <string>

namespace fulcrum {

std::string_view to_string(ContactMethod method) noexcept {
    constexpr std::array<std::string_view, 3> kNames{"newton", "dantzig", "iterative"};
    return kNames[static_cast<std::size_t>(method)];
}

Expected<ContactMethod> find_contact_method(std::string_view name) {
    std::string names;
    for (const ContactMethod method : kContactMethods) {
        if (to_string(method) == name) {
            return method;
        }
        names += (names.empty() ? "" : ", ") + std::string(to_string(method));
    }
    return fail("there is no contact solver \"" + std::string(name) + "\"", {},
                "name one of " + names);
}

Expected<void> validate(const ContactSolverSettings& settings) {
    const Range ranges[] = {
        {"tolerance_m_per_s", settings.tolerance_m_per_s, 1.0e-12, 1.0},
        {"max_iterations", static_cast<double>(settings.max_iterations), 1.0, 10000.0},
        {"friction_rounds", static_cast<double>(settings.friction_rounds), 1.0, 100.0},
        {"most_exact_contacts", static_cast<double>(settings.most_exact_contacts), 1.0, 1.0e6},
        {"relaxation", settings.relaxation, 0.1, 1.9},
        {"stiffening", settings.stiffening, 1.0e-9, 1.0},
    };
    return check_ranges("the contact solver's setting", ranges);
}

}  // namespace fulcrum
