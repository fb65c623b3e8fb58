// Writes what the tests of exported C++ compile: a header and a translation unit for each id that is named.
#include "core/reflectance/own_model.h"
#include "tests/study/exports/subjects.h"

#include <fstream>
#include <iostream>

namespace {

using namespace reflectance;

/// "planted_..." are exports into which a fault was planted; they keep the name of what they were made from.
std::string headerFor(const std::string& id)
{
    const bool constant = id == "planted_constant";
    const bool parameter = id == "planted_parameter";
    const auto text = exported(test::subjectFor(constant ? "oren_nayar" : parameter ? "ggx" : id), ExportForm::Cpp);
    if (!text)
        return {};
    if (constant)
        return test::replaced(*text, "lit<T>(0.45)", "lit<T>(0.4501)");
    return parameter ? test::replaced(*text, "T alpha = lit<T>(", "T alpha = lit<T>(1.001) * lit<T>(") : *text;
}

std::string spaceOf(const std::string& id)
{
    return "reflectance_" + (id == "planted_constant" ? "oren_nayar" : id == "planted_parameter" ? "ggx" : id);
}

/// The whole unit stands in a namespace of its own, since a planted header has the names of the good one.
std::string unitFor(const std::string& id)
{
    const bool planted = id.starts_with("planted");
    const std::string standard =
        "#include <algorithm>\n#include <array>\n#include <cmath>\n#include <cstdint>\n#include <limits>\n";
    return (planted ? standard + "namespace planted {\n" : "") + "#include \"" + id + ".h\"\n" +
           (planted ? "}\nusing namespace planted;\n" : "") + "int failures_" + id + "(bool single);\nint failures_" +
           id + "(bool single) { return single ? " + spaceOf(id) + "::selfTest<float>() : " + spaceOf(id) +
           "::selfTest<double>(); }\n";
}

bool write(const std::string& path, const std::string& text)
{
    std::ofstream file(path);
    file << text;
    return file.good() && !text.empty();
}

} // namespace

int main(int argc, char** argv)
{
    if (argc < 3) {
        std::cerr << "usage: write_exports FOLDER ID...\n";
        return 2;
    }
    const std::string folder = argv[1];
    std::string list = "#define FOR_EACH_EXPORTED(DO)";
    for (int i = 2; i < argc; ++i) {
        const std::string id = argv[i];
        if (!write(folder + "/" + id + ".h", headerFor(id)) || !write(folder + "/" + id + ".cpp", unitFor(id))) {
            std::cerr << "write_exports: " << id << " could not be written\n";
            return 1;
        }
        list += " DO(" + id + ")";
    }
    return write(folder + "/list.gen.h", list + "\n") ? 0 : 1;
}
