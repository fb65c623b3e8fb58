// What is known about the picture at rest: whether GL is within its bound of double on this driver, and how many digits
// an arithmetic keeps, pixel by pixel. On other threads, and given up at once when the hand moves.
#pragma once

#include "app/explorer/measured_prices.h"
#include "app/explorer/screen_texture.h"
#include "app/explorer/worker.h"
#include "core/study/lens/gl_check.h"
#include "core/study/lens/term.h"

#include <memory>

namespace reflectance::explorer {

struct Session;

/// The picture at rest, as GL drew it.
struct Rested {
    Scene scene;
    DrawnByGl drawn;
};

/// The lens over the picture at rest: of every stride-th pixel at first, of all of them soon after.
struct LensLaid {
    LensKind kind = LensKind::Float;
    int stride = 1;
    Image image; ///< the view in that arithmetic
    LensMap map;
};

/// A pixel that the mouse has been on.
struct PixelRead {
    int x = -1, y = -1;
    LensReading reading;
};

struct Trust {
    Trust(GetProcAddress load, const std::function<void()>& wake)
        : check(wake), lens(wake), overlay(load, Enlarged::Squares)
    {
    }

    std::shared_ptr<const Rested> rested; ///< none while the picture moves
    Worker<GlCheck> check;
    Worker<LensLaid> lens;
    LensKind asked = LensKind::Float; ///< what `lens` works on
    std::optional<LensLaid> laid;
    std::optional<PixelRead> read; ///< of `laid`
    ScreenTexture overlay;         ///< `laid`, painted
};

/// The picture changed: nothing is known about it any more.
void dropTrust(Session& session);

/// The picture rests.
void restTrust(Session& session, std::shared_ptr<const Rested> rested);

/// Takes over what has been found, and starts what is wanted next. With every frame.
void pollTrust(Session& session);

/// True while its threads work: what is measured now would be measured too slow.
[[nodiscard]] bool trustIsBusy(const Session& session);

/// The reading of the pixel under the lens; null where the lens is not there, or not yet in full.
[[nodiscard]] const LensReading* readPixel(Session& session, int x, int y);

} // namespace reflectance::explorer
