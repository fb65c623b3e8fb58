// GL contexts without a window: OSMesa and EGL surfaceless, both opened with dlopen when first asked for.
#pragma once

#include "core/base/result.h"

#include <memory>
#include <string>
#include <string_view>

namespace reflectance {

/// Finds a GL function by name; what GLFW, OSMesa and EGL each call GetProcAddress.
using GlFunction = void (*)();
using GetProcAddress = GlFunction (*)(const char* name);

enum class ContextKind { Any, OsMesa, Egl };

/// Owns a GL 3.3 core (or later) context, current since it was opened. Several may live in one process, of either kind;
/// after using, opening or closing another one (or a window's), makeCurrent() comes first.
class HeadlessContext {
public:
    virtual ~HeadlessContext() = default;
    [[nodiscard]] virtual std::string_view name() const = 0; ///< "osmesa" or "egl"
    [[nodiscard]] virtual GetProcAddress loader() const = 0;
    virtual void makeCurrent() = 0;
};

/// Opens a context and makes it current. Any tries OSMesa, then EGL; the error says what each of them answered.
[[nodiscard]] Result<std::unique_ptr<HeadlessContext>> openHeadless(ContextKind kind);

} // namespace reflectance
