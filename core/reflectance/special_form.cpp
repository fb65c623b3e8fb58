#include "core/reflectance/special_form.h"

#include <algorithm>

namespace reflectance {
namespace {

constexpr const char* matrixKeys[] = {"", "+diagonal", "+grey", "+black"};

MatrixForm matrixFormOf(std::span<const double> K)
{
    bool diagonal = true;
    for (std::size_t i = 0; i < 9; ++i)
        diagonal = diagonal && (i % 4 == 0 || K[i] == 0.0);
    if (!diagonal)
        return MatrixForm::Full;
    if (K[0] != K[4] || K[4] != K[8])
        return MatrixForm::Diagonal;
    return K[0] == 0.0 ? MatrixForm::Zero : MatrixForm::Grey;
}

} // namespace

std::string SpecialForm::key() const
{
    return std::string(matrixKeys[static_cast<std::size_t>(K)]) + (ks == ColorForm::One ? "+one" : "") +
           (facing ? "+facing" : "");
}

SpecialForm specialFormOf(const ModelText& model, std::span<const double> values)
{
    SpecialForm form;
    for (const Parameter& parameter : model.parameters) {
        const auto numbers = values.subspan(parameter.offset, parameter.size);
        if (parameter.kind == ParameterKind::Matrix && parameter.name == "K")
            form.K = matrixFormOf(numbers);
        if (parameter.kind == ParameterKind::Color && parameter.name == "ks" &&
            std::equal(numbers.begin() + 1, numbers.end(), numbers.begin()))
            form.ks = ColorForm::One;
    }
    return form;
}

std::vector<std::string> leftOutBy(const SpecialForm& form)
{
    std::vector<std::string> notes;
    if (form.K == MatrixForm::Diagonal)
        notes.emplace_back("K: nothing beside its diagonal, so 6 of its 9 products");
    if (form.K == MatrixForm::Grey)
        notes.emplace_back("K: grey, so 8 of its 9 products");
    if (form.K == MatrixForm::Zero)
        notes.emplace_back("K: all 0, so the matte term");
    if (form.ks == ColorForm::One)
        notes.emplace_back("ks: one number, so two thirds of the highlight's products");
    return notes;
}

} // namespace reflectance
