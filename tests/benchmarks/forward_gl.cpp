#include "tests/benchmarks/forward_gl.h"

#include "core/geometry/camera.h"
#include "core/render/gl/model_uniforms.h"
#include "core/render/gl/shader_source.h"
#include "core/scene/requirements.h"

#include <cstdlib>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>
#include <iostream>

namespace reflectance::bench {
namespace {

template <class T> T orStop(Result<T> result)
{
    if (!result) {
        std::cerr << result.error().sentence() << '\n';
        std::exit(2);
    }
    return *std::move(result);
}

constexpr const char* meshVertex = R"(
uniform mat4 clipFromWorld;
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
out vec3 P;
out vec3 N0;
void main()
{
    P = position;
    N0 = normal;
    gl_Position = clipFromWorld * vec4(position, 1.0);
}
)";

constexpr const char* common = R"(
uniform int lightCount;
uniform vec3 eye;
layout(location = 0) out vec4 radiance;
vec3 shadeAll(vec3 N, vec3 P)
{
    vec3 V = normalize(eye - P);
    if (dot(N, V) < 0.0)
        N = -N;
    vec3 sum = vec3(0.0);
    for (int light = 0; light < lightCount; ++light) {
        arrive(light, P);
        sum += shade(N, L, V, I);
    }
    return sum;
}
)";

constexpr const char* meshFragment = R"(
in vec3 P;
in vec3 N0;
void main()
{
    radiance = vec4(shadeAll(normalize(N0), P), 1.0);
}
)";

constexpr const char* sphereFragment = R"(
uniform float size;
void main()
{
    vec2 p = (2.0 * gl_FragCoord.xy / size - 1.0) / 0.757; // pi r^2 / 4 = 0.45
    float square = dot(p, p);
    if (square > 1.0) {
        radiance = vec4(0.0);
        return;
    }
    vec3 N = vec3(p, sqrt(1.0 - square));
    radiance = vec4(shadeAll(N, N), 1.0);
}
)";

GlProgram linked(const Gl& gl, const Scene& scene, const ShaderSource& vertex, const char* main)
{
    const Requirements requirements = requirementsOf(scene);
    std::vector<std::string> defines;
    if (requirements.directionalLights)
        defines.emplace_back("DIRECTIONAL_LIGHTS");
    if (requirements.pointLights)
        defines.emplace_back("POINT_LIGHTS");
    std::vector<ShaderPiece> pieces = modelPieces(modelOf(scene).text, false);
    pieces.push_back(shaderFile("gl/no_surroundings.glsl"));
    pieces.push_back(shaderFile("gl/arrival.glsl"));
    pieces.push_back({"forward", std::string(common) + main});
    ProgramLinker linker(gl);
    return orStop(GlProgram::link(linker, vertex, assembled(defines, std::move(pieces))));
}

std::vector<float> interleaved(const Mesh& mesh)
{
    std::vector<float> numbers;
    numbers.reserve(6 * mesh.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        for (const Vec3d& v : {mesh.positions[i], mesh.normals[i]})
            for (const double c : {v.x, v.y, v.z})
                numbers.push_back(static_cast<float>(c));
    return numbers;
}

} // namespace

ForwardGl::ForwardGl(GetProcAddress load, const Scene& scene, int size)
    : functions_(orStop(GlFunctions::load(load))), scene_(scene),
      target_(functions_->gl(), {GL_RGBA32F}, WithDepth::Yes), layout_(functions_->gl()), noVertices_(functions_->gl()),
      vertices_(functions_->gl()), indices_(functions_->gl()), lights_(functions_->gl())
{
    const Gl& gl = functions_->gl();
    programs_.push_back(linked(gl, scene, assembled({}, {{"forward", meshVertex}}), meshFragment));
    programs_.push_back(linked(gl, scene, assembled({}, {shaderFile("gl/fullscreen.vert")}), sphereFragment));
    target_.resize(size, size);
    lights_.upload(lightTexels(scene.lights));
    const Mesh& mesh = *scene.mesh;
    const std::vector<float> numbers = interleaved(mesh);
    constexpr GLsizei stride = 6 * sizeof(float);
    gl.BindVertexArray(layout_.id());
    gl.BindBuffer(GL_ARRAY_BUFFER, vertices_.id());
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(numbers.size() * sizeof(float)), numbers.data(),
                  GL_STATIC_DRAW);
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
    gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.triangles.size() * sizeof(Mesh::Triangle)),
                  mesh.triangles.data(), GL_STATIC_DRAW);
    gl.EnableVertexAttribArray(0);
    gl.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, stride, nullptr);
    gl.EnableVertexAttribArray(1);
    gl.VertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, stride, reinterpret_cast<const void*>(3 * sizeof(float)));
    gl.BindVertexArray(0);
    indexCount_ = static_cast<GLsizei>(3 * mesh.triangles.size());
}

void ForwardGl::prepare(const GlProgram& program, const Camera& camera) const
{
    program.use();
    program.set("eye", camera.eye);
    lights_.bindAsInput(0);
    program.set("lightTexels", 0);
    program.set("lightCount", static_cast<int>(scene_.lights.size()));
    program.set("size", static_cast<float>(target_.width()));
    uploadParameters(program, modelOf(scene_).text, valuesOf(scene_));
    target_.bind();
}

void ForwardGl::drawMesh(const Camera& camera)
{
    const Gl& gl = functions_->gl();
    constexpr float black[] = {0.0F, 0.0F, 0.0F, 0.0F};
    constexpr float farthest = 1.0F;
    prepare(programs_[0], camera);
    const glm::mat4 clipFromWorld(clipFromView(camera, 1.0) * viewFromWorld(camera));
    programs_[0].setColumns("clipFromWorld", glm::value_ptr(clipFromWorld));
    gl.DepthMask(GL_TRUE);
    gl.ClearBufferfv(GL_COLOR, 0, black);
    gl.ClearBufferfv(GL_DEPTH, 0, &farthest);
    gl.Enable(GL_DEPTH_TEST);
    gl.DepthFunc(GL_LESS);
    gl.BindVertexArray(layout_.id());
    gl.DrawElements(GL_TRIANGLES, indexCount_, GL_UNSIGNED_INT, nullptr);
    gl.Disable(GL_DEPTH_TEST);
}

void ForwardGl::drawFullScreen()
{
    const Gl& gl = functions_->gl();
    prepare(programs_[1], scene_.camera);
    gl.BindVertexArray(noVertices_.id());
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
}

} // namespace reflectance::bench
