// What a user did that cannot work: what, where, and what to do about it.
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <utility>

namespace fulcrum {

/// An error a user can make. Each part is a clause without a full stop; `where` is "file:line" or empty.
struct Error {
    std::string message;     ///< what is wrong, e.g. "the accessor 3 reads past its buffer"
    std::string where;       ///< "path:line" or "path", empty when there is no place
    std::string what_to_do;  ///< the mend, e.g. "export the model again"
};

template <class T>
using Expected = tl::expected<T, Error>;

/// Makes the failed side of an `Expected`.
[[nodiscard]] inline tl::unexpected<Error> fail(std::string message, std::string where = {},
                                                std::string what_to_do = {}) {
    return tl::unexpected<Error>(
        Error{std::move(message), std::move(where), std::move(what_to_do)});
}

/// One sentence: "where: message; what_to_do." No full stop is put behind a ?, a ! or another full stop.
[[nodiscard]] std::string to_sentence(const Error& error);

}  // namespace fulcrum
