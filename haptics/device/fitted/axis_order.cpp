#include "haptics/device/fitted/axis_order.h"

#include <cmath>

namespace fulcrum {

Expected<AxisOrder> AxisOrder::read(std::string_view text) {
    const auto refuse = [&] {
        return fail("\"" + std::string(text) + "\" is no order of axes", {},
                    "name x, y and z once each, with - where one runs the other way: -x,y,z");
    };
    Matrix3 axes = Matrix3::Zero();
    std::string_view rest = text;
    for (int row = 0; row < 3; ++row) {
        const std::size_t comma = rest.find(',');
        const bool is_last = comma == std::string_view::npos;
        std::string_view word = rest.substr(0, comma);
        rest = is_last ? std::string_view{} : rest.substr(comma + 1);
        const bool runs_back = word.starts_with('-');
        word.remove_prefix(runs_back || word.starts_with('+') ? 1 : 0);
        if (is_last != (row == 2) || word.size() != 1 || word[0] < 'x' || word[0] > 'z') {
            return refuse();
        }
        axes(row, word[0] - 'x') = runs_back ? -1.0 : 1.0;
    }
    const auto order = of(axes);
    return order ? Expected<AxisOrder>(*order) : refuse();
}

std::optional<AxisOrder> AxisOrder::of(const Matrix3& axes) noexcept {
    // One entry of size 1 in each row; a determinant that is not zero says that each column has one too.
    const Matrix3 sizes = axes.cwiseAbs();
    const bool is_signed =
        sizes.cwiseProduct(sizes) == sizes && sizes * Vector3::Ones() == Vector3::Ones();
    return is_signed && axes.determinant() != 0.0 ? std::optional(AxisOrder(axes)) : std::nullopt;
}

std::string AxisOrder::text() const {
    std::string words;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            if (axes_(row, column) != 0.0) {
                words += words.empty() ? "" : ",";
                words += axes_(row, column) < 0.0 ? "-" : "";
                words += static_cast<char>('x' + column);
            }
        }
    }
    return words;
}

}  // namespace fulcrum
