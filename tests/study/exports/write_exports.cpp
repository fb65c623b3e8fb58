// Writes what the tests of exported C++ compile: a header and a translation unit for each id that is named.
#include "core/reflectance/own_model.h"
#include "tests/study/exports/subjects.h"

#include <fstream>
#include <iostream>

namespace {

using namespace reflectance;

/// The model that "planted_..." was made from; else the id itself.
std::string modelOf(const std::string& id)
{
    return id == "planted_constant" ? "oren_nayar" : id == "planted_parameter" ? "ggx" : id;
}

/// With a fault planted, in a namespace of its own, since the good header has the model's.
std::string headerFor(const std::string& id)
{
    const auto text = exported(test::subjectFor(modelOf(id)), ExportForm::Cpp);
    if (!text || modelOf(id) == id)
        return text ? *text : std::string();
    std::string planted = id == "planted_constant"
                              ? test::replaced(*text, "lit<T>(0.45)", "lit<T>(0.4501)")
                              : test::replaced(*text, "T alpha = lit<T>(", "T alpha = lit<T>(1.001) * lit<T>(");
    const std::string space = "reflectance_" + modelOf(id);
    for (std::size_t at = planted.find(space); at != std::string::npos; at = planted.find(space, at))
        planted.replace(at, space.size(), "reflectance_" + id);
    return planted;
}

std::string unitFor(const std::string& id)
{
    const std::string selfTest = "reflectance_" + id + "::selfTest";
    return "#include \"" + id + ".h\"\nint failures_" + id + "(bool single);\nint failures_" + id +
           "(bool single) { return single ? " + selfTest + "<float>() : " + selfTest + "<double>(); }\n";
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
