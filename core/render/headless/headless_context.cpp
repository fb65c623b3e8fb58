#include "core/render/headless/headless_context.h"

#include "core/render/headless/makers.h"

namespace reflectance {

Result<std::unique_ptr<HeadlessContext>> openHeadless(ContextKind kind)
{
    if (kind == ContextKind::OsMesa)
        return openOsMesa();
    if (kind == ContextKind::Egl)
        return openEgl();
    auto osmesa = openOsMesa();
    if (osmesa)
        return osmesa;
    auto egl = openEgl();
    if (egl)
        return egl;
    return Error{"no OpenGL 3.3 without a window: " + osmesa.error().message + "; " + egl.error().message +
                 "; use --backend cpu, or install libosmesa6 or libegl1 with libgl1-mesa-dri"};
}

} // namespace reflectance
