// OSMesa: Mesa's software rasteriser drawing into memory. Mesa 25.1 removed it; EGL stands beside it.
#include "core/render/headless/driver_ahead.h"
#include "core/render/headless/makers.h"
#include "core/base/shared_library.h"

#include <GL/osmesa.h>
#include <array>

namespace reflectance {
namespace {

struct OsMesa {
    decltype(&OSMesaCreateContextAttribs) create;
    decltype(&OSMesaMakeCurrent) makeCurrent;
    decltype(&OSMesaDestroyContext) destroy;
    GetProcAddress load;
};

Result<SharedLibrary> openLibrary()
{
    return SharedLibrary::open({"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"});
}

Result<OsMesa> loadOsMesa()
{
    auto library = openLibrary();
    if (!library)
        return Error{"OSMesa is not there (" + library.error().message + ")"};
    const OsMesa functions{library->find<decltype(&OSMesaCreateContextAttribs)>("OSMesaCreateContextAttribs"),
                           library->find<decltype(&OSMesaMakeCurrent)>("OSMesaMakeCurrent"),
                           library->find<decltype(&OSMesaDestroyContext)>("OSMesaDestroyContext"),
                           library->find<GetProcAddress>("OSMesaGetProcAddress")};
    if (!functions.create || !functions.makeCurrent || !functions.destroy || !functions.load)
        return Error{"OSMesa is too old: OSMesaCreateContextAttribs is missing"};
    return functions;
}

class OsMesaHeadless final : public HeadlessContext {
public:
    OsMesaHeadless(const OsMesa& functions, OSMesaContext context) : osmesa_(functions), context_(context) {}
    OsMesaHeadless(const OsMesaHeadless&) = delete;
    OsMesaHeadless& operator=(const OsMesaHeadless&) = delete;
    ~OsMesaHeadless() override { osmesa_.destroy(context_); }

    [[nodiscard]] std::string_view name() const override { return "osmesa"; }
    [[nodiscard]] GetProcAddress loader() const override { return osmesa_.load; }
    void makeCurrent() override { (void)tryMakeCurrent(); }

    /// OSMesa wants a picture of its own, which nobody looks at: the renderer draws into framebuffer objects.
    [[nodiscard]] bool tryMakeCurrent()
    {
        return osmesa_.makeCurrent(context_, pixel_.data(), GL_UNSIGNED_BYTE, 1, 1) == GL_TRUE;
    }

private:
    OsMesa osmesa_;
    OSMesaContext context_;
    std::array<unsigned char, 4> pixel_{};
};

} // namespace

std::jthread openDriverAhead(ContextKind kind)
{
    return kind == ContextKind::Egl ? std::jthread() : std::jthread([] { (void)openLibrary(); });
}

Result<std::unique_ptr<HeadlessContext>> openOsMesa()
{
    const auto functions = loadOsMesa();
    if (!functions)
        return functions.error();
    constexpr int attributes[] = {OSMESA_FORMAT,
                                  OSMESA_RGBA,
                                  OSMESA_PROFILE,
                                  OSMESA_CORE_PROFILE,
                                  OSMESA_CONTEXT_MAJOR_VERSION,
                                  3,
                                  OSMESA_CONTEXT_MINOR_VERSION,
                                  3,
                                  0};
    OSMesaContext context = (*functions).create(attributes, nullptr);
    if (!context)
        return Error{"OSMesa offers no OpenGL 3.3 core profile"};
    auto headless = std::make_unique<OsMesaHeadless>(*functions, context);
    if (!headless->tryMakeCurrent())
        return Error{"OSMesa could not make its context current"};
    return std::unique_ptr<HeadlessContext>(std::move(headless));
}

} // namespace reflectance
