#include "core/base/text.h"
#include "core/reflectance/lists.h"
#include "core/study/exports/forms.h"
#include "core/study/exports/test_vectors.h"

namespace reflectance::exports {
namespace {

std::string cell(const Vec3d& v)
{
    return general(v.x, 17) + ' ' + general(v.y, 17) + ' ' + general(v.z, 17);
}

/// "ks=0.5 0.5 0.5;n=40", as `eval` reads it.
std::string paramsOf(const ExportSubject& subject)
{
    std::vector<std::string> parts;
    if (!subject.tableFile.empty())
        parts.push_back("file=" + subject.tableFile);
    for (const auto& [name, numbers] : valuesByName(subject.model->text, subject.values)) {
        std::string list;
        for (const double number : numbers)
            list += (list.empty() ? "" : " ") + shortest(number);
        parts.push_back(name + "=" + list);
    }
    return joined(parts, ";");
}

void append(std::string& out, const ExportSubject& subject, const std::string& kind, const std::string& params,
            const std::vector<TestVector>& vectors)
{
    for (std::size_t i = 0; i < vectors.size(); ++i) {
        const TestVector& v = vectors[i];
        out += kind + std::to_string(i) + ',' + subject.model->id() + ',' + params + ',' + cell(v.N) + ',' + cell(v.L) +
               ',' + cell(v.V) + ',' + cell(v.I) + ',' + general(v.lightRadius, 17) + ',' + cell(v.expected) + ',' +
               cell(toleranceOf(v, 0x1p-53)) + ',' + cell(toleranceOf(v, 0x1p-24)) + '\n';
    }
}

} // namespace

std::string csvForm(const ExportSubject& subject)
{
    const std::string params = paramsOf(subject);
    std::string out = "id,model,params,N,L,V,light_rgb,light_radius,expected,tolerance_double,tolerance_float\n";
    append(out, subject, "test", params, testVectors(*subject.model, subject.values, subject.measured));
    append(out, subject, "grid", params, gridVectors(*subject.model, subject.values, subject.measured));
    return out;
}

} // namespace reflectance::exports
