// EGL without a surface: Mesa's surfaceless platform, asked for by name (the default display fails where there is
// neither X nor an EGL_PLATFORM variable); other drivers, NVIDIA's among them, offer their devices instead.
#include "core/render/headless/makers.h"
#include "core/base/shared_library.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <array>
#include <string>

namespace reflectance {
namespace {

struct Egl {
    decltype(&eglGetProcAddress) getProcAddress;
    decltype(&eglQueryString) queryString;
    decltype(&eglInitialize) initialize;
    decltype(&eglBindAPI) bindApi;
    decltype(&eglChooseConfig) chooseConfig;
    decltype(&eglCreateContext) createContext;
    decltype(&eglDestroyContext) destroyContext;
    decltype(&eglMakeCurrent) makeCurrent;
    PFNEGLGETPLATFORMDISPLAYEXTPROC getPlatformDisplay;
    PFNEGLQUERYDEVICESEXTPROC queryDevices;
};

Result<Egl> loadEgl()
{
    auto library = SharedLibrary::open({"libEGL.so.1", "libEGL.so"});
    if (!library)
        return Error{"EGL is not there (" + library.error().message + ")"};
    const auto function = [&library](auto& pointer, const char* name) {
        pointer = library->find<std::remove_reference_t<decltype(pointer)>>(name);
        return pointer != nullptr;
    };
    Egl egl{};
    if (!function(egl.getProcAddress, "eglGetProcAddress") || !function(egl.queryString, "eglQueryString") ||
        !function(egl.initialize, "eglInitialize") || !function(egl.bindApi, "eglBindAPI") ||
        !function(egl.chooseConfig, "eglChooseConfig") || !function(egl.createContext, "eglCreateContext") ||
        !function(egl.destroyContext, "eglDestroyContext") || !function(egl.makeCurrent, "eglMakeCurrent"))
        return Error{"EGL is too old: it lacks functions of version 1.4"};
    egl.getPlatformDisplay =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(egl.getProcAddress("eglGetPlatformDisplayEXT"));
    egl.queryDevices = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(egl.getProcAddress("eglQueryDevicesEXT"));
    if (!egl.getPlatformDisplay)
        return Error{"EGL is too old: it lacks EGL_EXT_platform_base"};
    return egl;
}

/// The first display that opens: Mesa surfaceless, then each device; EGL_NO_DISPLAY if none does.
EGLDisplay openDisplay(const Egl& egl)
{
    const auto opened = [&egl](EGLDisplay display) {
        return display != EGL_NO_DISPLAY && egl.initialize(display, nullptr, nullptr) == EGL_TRUE;
    };
    EGLDisplay display = egl.getPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (opened(display))
        return display;
    std::array<EGLDeviceEXT, 16> devices{};
    EGLint count = 0;
    if (!egl.queryDevices || egl.queryDevices(static_cast<EGLint>(devices.size()), devices.data(), &count) != EGL_TRUE)
        return EGL_NO_DISPLAY;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        display = egl.getPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr);
        if (opened(display))
            return display;
    }
    return EGL_NO_DISPLAY;
}

/// A debug context where the driver makes one, else a plain one; EGL_NO_CONTEXT if there is no OpenGL 3.3 core.
EGLContext makeContext(const Egl& egl, EGLDisplay display)
{
    constexpr EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (egl.bindApi(EGL_OPENGL_API) != EGL_TRUE || egl.chooseConfig(display, wanted, &config, 1, &count) != EGL_TRUE ||
        count == 0)
        return EGL_NO_CONTEXT;
    for (const EGLint debug : {EGL_TRUE, EGL_FALSE}) {
        const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 3,
                                     EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                     EGL_CONTEXT_OPENGL_DEBUG, debug, EGL_NONE};
        EGLContext context = egl.createContext(display, config, EGL_NO_CONTEXT, attributes);
        if (context != EGL_NO_CONTEXT)
            return context;
    }
    return EGL_NO_CONTEXT;
}

class EglHeadless final : public HeadlessContext {
public:
    EglHeadless(const Egl& functions, EGLDisplay display, EGLContext context)
        : egl_(functions), display_(display), context_(context)
    {
    }
    EglHeadless(const EglHeadless&) = delete;
    EglHeadless& operator=(const EglHeadless&) = delete;

    /// The display stays open: the driver shares it between all contexts of the process.
    ~EglHeadless() override
    {
        release();
        egl_.destroyContext(display_, context_);
    }

    [[nodiscard]] std::string_view name() const override { return "egl"; }
    [[nodiscard]] GetProcAddress loader() const override { return egl_.getProcAddress; }
    void makeCurrent() override { (void)tryMakeCurrent(); }

    /// Released first: EGL does not see that OSMesa became current meanwhile and would take its context for bound.
    [[nodiscard]] bool tryMakeCurrent()
    {
        release();
        return egl_.makeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE;
    }

private:
    void release() { egl_.makeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT); }

    Egl egl_;
    EGLDisplay display_;
    EGLContext context_;
};

} // namespace

Result<std::unique_ptr<HeadlessContext>> openEgl()
{
    const auto egl = loadEgl();
    if (!egl)
        return egl.error();
    EGLDisplay display = openDisplay(*egl);
    if (display == EGL_NO_DISPLAY)
        return Error{"EGL has neither Mesa's surfaceless platform nor a device that opens"};
    EGLContext context = makeContext(*egl, display);
    if (context == EGL_NO_CONTEXT)
        return Error{"EGL offers no OpenGL 3.3 core profile"};
    auto headless = std::make_unique<EglHeadless>(*egl, display, context);
    if (!headless->tryMakeCurrent())
        return Error{"EGL could not make a context current without a surface"};
    return std::unique_ptr<HeadlessContext>(std::move(headless));
}

} // namespace reflectance
