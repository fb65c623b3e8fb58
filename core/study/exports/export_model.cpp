#include "core/study/exports/export_model.h"

#include "core/base/check.h"
#include "core/base/text.h"
#include "core/study/exports/forms.h"

#include <array>
#include <cmath>

namespace reflectance {
namespace {

constexpr std::array<ExportFormFacts, 3> facts = {{
    {ExportForm::Glsl, "glsl", ".glsl", "a GLSL 3.30 function whose names all begin with the model's id"},
    {ExportForm::Cpp, "cpp", ".h", "a C++17 header that includes nothing but the standard library"},
    {ExportForm::Csv, "csv", ".csv", "rows for 'reflectance eval', with what double gives and the tolerances"},
}};

} // namespace

std::span<const ExportFormFacts> exportForms()
{
    return facts;
}

std::optional<ExportForm> formForFile(std::string_view path)
{
    const std::string low = lowered(path);
    for (const std::string_view ending : {".glsl", ".frag", ".vert", ".fs"})
        if (low.ends_with(ending))
            return ExportForm::Glsl;
    for (const std::string_view ending : {".h", ".hpp", ".hh", ".hxx"})
        if (low.ends_with(ending))
            return ExportForm::Cpp;
    return low.ends_with(".csv") ? std::optional(ExportForm::Csv) : std::nullopt;
}

Result<std::string> exported(const ExportSubject& subject, ExportForm form)
{
    const ModelText& text = subject.model->text;
    CHECK_EQ(subject.values.size(), text.valueCount());
    for (const Parameter& parameter : text.parameters)
        for (std::size_t i = parameter.offset; i < parameter.offset + parameter.size; ++i)
            if (!std::isfinite(subject.values[i]))
                return Error{"parameter " + parameter.name + " of " + text.id +
                             " is not finite and cannot be written as code; give it a finite value"};
    if (form == ExportForm::Csv)
        return exports::csvForm(subject);
    if (text.usesTable)
        return Error{"the model " + text.id +
                     " is a measurement and no formula; export it as csv, or bring it to another format with "
                     "'reflectance table convert'"};
    return form == ExportForm::Glsl ? exports::glslForm(subject) : exports::cppForm(subject);
}

} // namespace reflectance
