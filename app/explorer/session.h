// One run of the explorer: what it knows, and what works for it.
#pragma once

#include "app/explorer/autosave.h"
#include "app/explorer/file_loader.h"
#include "app/explorer/measured_prices.h"
#include "app/explorer/own_models.h"
#include "app/explorer/pictures.h"
#include "app/explorer/probes.h"
#include "app/explorer/screen_texture.h"
#include "app/explorer/second_view.h"
#include "app/explorer/stand_in.h"
#include "app/explorer/start_clock.h"
#include "app/explorer/state.h"
#include "app/explorer/tape.h"
#include "app/explorer/trades.h"
#include "app/explorer/trust.h"
#include "app/explorer/user_folders.h"
#include "app/explorer/viewport.h"
#include "app/explorer/window.h"
#include "app/explorer/worker.h"
#include "core/render/gl/gl_renderer.h"

#include <deque>
#include <map>
#include <string>

namespace reflectance::explorer {

struct Session {
    Session(Window& itsWindow, GlRenderer& itsRenderer) : window(itsWindow), renderer(itsRenderer) {}

    Window& window;
    GlRenderer& renderer;
    ExplorerState state;
    Viewport viewport;
    Tape tape;
    SecondView second{Window::loader(), Window::wake};
    StartClock start;
    StandIn standIn{Window::wake};
    FileLoader loader{Window::wake};
    Worker<Prices> prices{Window::wake};
    Trust trust{Window::loader(), Window::wake};
    Worker<FitOutcome> fit{Window::wake};
    Worker<Photograph> photograph{Window::wake};
    ScreenTexture photographTexture{Window::loader()};
    std::shared_ptr<LabLive> labLive = std::make_shared<LabLive>();
    Worker<LabOutcome> lab{Window::wake};
    Worker<std::vector<Thumbnail>> thumbnails{Window::wake};
    std::map<std::string, ScreenTexture> thumbnailTextures; ///< by surface id
    Scene thumbnailLight;                                   ///< under whose lights the thumbnails were made last
    Worker<PlotAnswer> plots{Window::wake};
    std::map<PlotTab, ScreenTexture> plotTextures;
    std::optional<WindowRegion> region; ///< of the window, to be saved as the next frame shows it
    Autosave autosave{stateFolder()};
    OwnModelWatch ownModels;
    Probes probes;

    Worker<Waterfall> waterfall{Window::wake};
    std::shared_ptr<const Rested> waterfallAsked; ///< the picture that it was last asked of
    Worker<ObjectPrices> objectPrices{Window::wake};

    Worker<TableFacts> tableFacts{Window::wake};
    std::shared_ptr<const MeasuredTable> tableAsked; ///< that the facts were last asked of

    std::deque<std::string> toOpen;           ///< files that wait for the one being read
    std::string sceneFile;                    ///< the scene file in use; empty where there is none
    std::optional<std::string> windowPicture; ///< where to save the frame being drawn; empty chooses a name
    std::optional<GlRenderer> bench; ///< draws for studies, so that the picture's own buffers stay; made when needed
    Trades trades{Window::loader(), Window::wake}; ///< after `bench`, which it draws with
    bool quit = false;
    bool quitsAfterFirst = false; ///< picture, and says what that took

    std::uint64_t pricedPicture = 0;  ///< Viewport::pictures when the prices were last asked for
    bool pricesWait = false;          ///< asked for, but something else is being measured
    std::uint64_t countedPicture = 0; ///< Viewport::pictures when lastChange was noted
    Clock::time_point lastChange{};   ///< when the picture last changed
};

} // namespace reflectance::explorer
