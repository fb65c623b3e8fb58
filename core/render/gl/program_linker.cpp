#include "core/render/gl/program_linker.h"

#include "core/base/digest.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/base/version.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <vector>

namespace reflectance {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t largestFile = std::uintmax_t{16} << 20U;

template <class Shader> std::string shaderLog(const Gl& gl, const Shader& shader)
{
    GLint length = 0;
    gl.GetShaderiv(shader.id(), GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length), '\0');
    gl.GetShaderInfoLog(shader.id(), length, nullptr, log.data());
    return log;
}

template <class Shader> Result<Shader> compiled(const Gl& gl, const ShaderSource& source)
{
    Shader shader(gl);
    const char* text = source.text.data();
    const auto length = static_cast<GLint>(source.text.size());
    gl.ShaderSource(shader.id(), 1, &text, &length);
    gl.CompileShader(shader.id());
    GLint success = GL_FALSE;
    gl.GetShaderiv(shader.id(), GL_COMPILE_STATUS, &success);
    if (success != GL_TRUE)
        return compilerError(shaderLog(gl, shader), source);
    return shader;
}

std::string linkLog(const Gl& gl, GLuint program)
{
    GLint length = 0;
    gl.GetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length), '\0');
    gl.GetProgramInfoLog(program, length, nullptr, log.data());
    return std::string(trimmed(log.c_str()));
}

bool isLinked(const Gl& gl, GLuint program)
{
    GLint success = GL_FALSE;
    gl.GetProgramiv(program, GL_LINK_STATUS, &success);
    return success == GL_TRUE;
}

bool takesBinaries(const Gl& gl)
{
    GLint formats = 0;
    if (gl.ARB_get_program_binary)
        gl.GetIntegerv(GL_NUM_PROGRAM_BINARY_FORMATS, &formats);
    return formats > 0;
}

struct Binary {
    GLenum format = 0;
    std::string bytes;
};

constexpr std::string_view firstWords = "reflectance program 1\n";

/// A line of two numbers and a word - format, length of the key, digest of the binary - then the key, then the binary.
std::string packed(const std::string& key, const Binary& binary)
{
    return std::string(firstWords) + std::to_string(binary.format) + " " + std::to_string(key.size()) + " " +
           digestOf(binary.bytes) + "\n" + key + binary.bytes;
}

std::optional<std::uint64_t> takeNumber(std::string_view& text)
{
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end == text.data() + text.size())
        return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()) + 1);
    return number;
}

/// Nothing if the file is damaged or of another key.
std::optional<Binary> unpacked(std::string_view file, const std::string& key)
{
    if (!file.starts_with(firstWords))
        return std::nullopt;
    file.remove_prefix(firstWords.size());
    const auto format = takeNumber(file);
    const auto length = takeNumber(file);
    const std::size_t end = file.find('\n');
    if (!format || !length || *length != key.size() || end == std::string_view::npos)
        return std::nullopt;
    const std::string_view digest = file.substr(0, end);
    file.remove_prefix(end + 1);
    if (!file.starts_with(key))
        return std::nullopt;
    file.remove_prefix(key.size());
    if (digestOf(file) != digest)
        return std::nullopt;
    return Binary{static_cast<GLenum>(*format), std::string(file)};
}

/// Removes the oldest files until there is room for one more.
void makeRoom(const fs::path& folder)
{
    std::error_code ignored;
    std::vector<std::pair<fs::file_time_type, fs::path>> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
        files.emplace_back(entry.last_write_time(ignored), entry.path());
    std::sort(files.begin(), files.end());
    for (std::size_t i = 0; i + ProgramLinker::largestNumberOfFiles <= files.size(); ++i)
        fs::remove(files[i].second, ignored);
}

} // namespace

ProgramLinker::ProgramLinker(const Gl& gl, fs::path folder)
    : gl_(&gl), folder_(takesBinaries(gl) ? std::move(folder) : fs::path())
{
}

std::string ProgramLinker::keyOf(const ShaderSource& vertex, const ShaderSource& fragment) const
{
    std::string key(programVersion());
    for (const GLenum name : std::initializer_list<GLenum>{GL_VENDOR, GL_RENDERER, GL_VERSION})
        key += std::string("\n") + reinterpret_cast<const char*>(gl_->GetString(name));
    return key + "\n" + vertex.text + "\n" + fragment.text + "\n";
}

fs::path ProgramLinker::fileOf(const std::string& key) const
{
    return folder_ / (digestOf(key) + ".bin");
}

bool ProgramLinker::load(const GlProgramObject& program, const std::string& key) const
{
    std::error_code ignored;
    const fs::path path = fileOf(key);
    if (!fs::exists(path, ignored))
        return false;
    const auto file = readWholeFile(path.string(), largestFile);
    const auto binary = file ? unpacked(*file, key) : std::nullopt;
    if (!binary)
        return false;
    gl_->ProgramBinary(program.id(), binary->format, binary->bytes.data(), static_cast<GLsizei>(binary->bytes.size()));
    return isLinked(*gl_, program.id());
}

void ProgramLinker::keep(const GlProgramObject& program, const std::string& key) const
{
    GLint length = 0;
    gl_->GetProgramiv(program.id(), GL_PROGRAM_BINARY_LENGTH, &length);
    if (length <= 0)
        return;
    Binary binary{0, std::string(static_cast<std::size_t>(length), '\0')};
    GLsizei written = 0;
    gl_->GetProgramBinary(program.id(), length, &written, &binary.format, binary.bytes.data());
    binary.bytes.resize(static_cast<std::size_t>(written));
    std::error_code ignored;
    fs::create_directories(folder_, ignored);
    makeRoom(folder_);
    (void)writeAtomically(fileOf(key).string(), packed(key, binary)); // a full disk costs the next start some time
}

Result<GlProgramObject> ProgramLinker::link(const ShaderSource& vertex, const ShaderSource& fragment)
{
    GlProgramObject program(*gl_);
    const std::string key = folder_.empty() ? std::string() : keyOf(vertex, fragment);
    if (!key.empty() && load(program, key)) {
        ++loaded_;
        return program;
    }
    const auto vertexShader = compiled<GlVertexShader>(*gl_, vertex);
    if (!vertexShader)
        return vertexShader.error();
    const auto fragmentShader = compiled<GlFragmentShader>(*gl_, fragment);
    if (!fragmentShader)
        return fragmentShader.error();
    gl_->AttachShader(program.id(), vertexShader.value().id());
    gl_->AttachShader(program.id(), fragmentShader.value().id());
    if (!key.empty())
        gl_->ProgramParameteri(program.id(), GL_PROGRAM_BINARY_RETRIEVABLE_HINT, GL_TRUE);
    gl_->LinkProgram(program.id());
    if (!isLinked(*gl_, program.id()))
        return Error{"the shader does not link: " + linkLog(*gl_, program.id()), fragment.files.back()};
    gl_->DetachShader(program.id(), vertexShader.value().id());
    gl_->DetachShader(program.id(), fragmentShader.value().id());
    if (!key.empty())
        keep(program, key);
    return program;
}

} // namespace reflectance
