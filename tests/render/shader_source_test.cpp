// The assembled shader text and the compilers' messages about it; no context needed.
#include "core/base/text.h"
#include "core/reflectance/catalogue.h"
#include "core/render/gl/shader_source.h"

#include <gtest/gtest.h>

namespace reflectance::test {
namespace {

const ShaderSource twoFiles = assembled({"A", "B"}, {{"first.glsl", "one\ntwo"}, {"second.glsl", "three\nfour"}});

TEST(ShaderSource, StartsWithTheVersionAndNumbersItsFiles)
{
    EXPECT_EQ(twoFiles.text, "#version 330 core\n#define A\n#define B\n#line 100001\none\ntwo\n#line 200001\nthree\nfour\n");
    EXPECT_EQ(twoFiles.files, (std::vector<std::string>{"first.glsl", "second.glsl"}));
}

TEST(ShaderSource, UnderstandsMesasMessages)
{
    const Error error = compilerError("0:200002(5): error: syntax error, unexpected IDENTIFIER\n0:200009(1): error: more\n", twoFiles);
    EXPECT_EQ(error.file, "second.glsl");
    EXPECT_EQ(error.line, 2);
    EXPECT_EQ(error.message, "the shader does not compile: error: syntax error, unexpected IDENTIFIER");
}

TEST(ShaderSource, PassesOverWarnings)
{
    EXPECT_EQ(compilerError("0:100001(1): warning: unused\n0:100007(1): error: bad\n", twoFiles).line, 7);
}

TEST(ShaderSource, UnderstandsNvidiasMessages)
{
    const Error error = compilerError("0(100012) : error C1503: undefined variable \"gait\"\n", twoFiles);
    EXPECT_EQ(error.file, "first.glsl");
    EXPECT_EQ(error.line, 12);
}

TEST(ShaderSource, KeepsAMessageInAnotherForm)
{
    const Error error = compilerError("ERROR: something\n", twoFiles);
    EXPECT_EQ(error.message, "the shader does not compile: ERROR: something");
    EXPECT_EQ(error.line, 0);
    EXPECT_EQ(compilerError("0:700001(1): error: no such file\n", twoFiles).line, 0);
}

TEST(ShaderSource, DeclaresEveryParameterOnce)
{
    const ModelText& hybrid = (*findModel("hybrid"))->text;
    EXPECT_EQ(parameterDeclarations(hybrid).text, "uniform mat3 K;\nuniform vec3 ks;\nuniform float n;\n");
}

/// A compiler's line is the file's line: the code keeps an empty line for each that the parser took out.
TEST(ShaderSource, ModelCodeKeepsItsLines)
{
    for (const Model& model : catalogue()) {
        const ShaderPiece given = modelCode(model.text);
        const ShaderPiece written = shaderFile("reflectance/" + model.id() + ".glsl");
        const auto code = split(given.text, '\n');
        const auto file = split(written.text, '\n');
        EXPECT_EQ(given.file, written.file);
        for (std::size_t i = 0; i < file.size() && i < code.size(); ++i)
            EXPECT_TRUE(code[i].empty() || code[i] == file[i]) << model.id() << " line " << i + 1;
    }
}

} // namespace
} // namespace reflectance::test
