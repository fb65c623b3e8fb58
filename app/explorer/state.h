// What the explorer knows: the scene being edited and how it is being looked at. Panels and gestures change it, the
// frame loop draws it. No GL and no ImGui in here.
#pragma once

#include "app/explorer/comparison.h"
#include "app/explorer/exhibition.h"
#include "app/explorer/extremes_study.h"
#include "app/explorer/fit_study.h"
#include "app/explorer/grab_tool.h"
#include "app/explorer/guide.h"
#include "app/explorer/history.h"
#include "app/explorer/lab_study.h"
#include "app/explorer/object_price.h"
#include "app/explorer/plot_study.h"
#include "app/explorer/probe_study.h"
#include "app/explorer/sensor_study.h"
#include "app/explorer/stand_in.h"
#include "app/explorer/surface_shelf.h"
#include "app/explorer/table_study.h"
#include "app/explorer/trade_study.h"
#include "app/explorer/ui/panel_memory.h"
#include "core/scene/scene.h"
#include "core/sensor/sensor.h"
#include "core/spectra/color_study.h"
#include "core/study/lens/gl_check.h"
#include "core/study/lens/term.h"
#include "core/study/price_tag.h"
#include "core/study/trade/rung.h"

#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace reflectance::explorer {

/// Things a panel, a key or a menu asks the frame loop to do.
struct Request {
    enum class Kind {
        OpenFile,
        OpenDialog,
        SaveView,
        SaveWindow,
        SaveScene,
        Frame,
        ResetView,
        ResetScene,
        SaveText,
        SaveRegion,
        OpenText,
        FitText,
        CancelLoading,
        LeaveCase,
        TogglePage,
        Undo,
        Redo,
        GoToStep,
        ShowTour,
        Dismiss,
        Quit
    };
    Kind kind;
    /// OpenFile: a mesh, scene, environment or measurement, told apart by its ending. SaveView, SaveWindow and SaveScene: empty
    /// chooses a name in the pictures folder (a scene goes back to the file that it came from). Dismiss: an earlier
    /// session; OpenFile restores it. SaveText: a name such as "curves.svg", made unique in the pictures folder.
    /// SaveRegion: the same of a part of the window as the next frame shows it, a name such as "curves.png"; `text` holds its
    /// left, top, width and height in pixels of the interface. OpenText, FitText: the same as SaveText, and the file is opened, or Oren-Nayar is fitted to it.
    /// TogglePage: the number of a page of the workbench, from 0. GoToStep: an index into the history's
    /// steps. ShowTour: the number of a step of the tour; empty for the last one seen.
    std::string path;
    std::string text = {}; ///< SaveText, OpenText, FitText: what is written
};

/// Kept between sessions where the desktop's conventions put settings.
struct Preferences {
    std::deque<std::string> recentFiles; ///< newest first, at most 10
    int windowWidth = 1280, windowHeight = 800;
    float panelWidth = 360.0F;      ///< of the panels, in points
    float interfaceScale = 0.0F;    ///< 0: from the monitor
    float workbenchHeight = 280.0F; ///< while a page is open, in points
    std::string workbenchPage;      ///< id of the open page; empty while the workbench is closed
    int samplesPerAxis = 2;
    bool showLightHandles = true;
    int tourStep = 1; ///< the last one seen
};

/// A mesh being read on another thread.
struct Loading {
    std::string file;
    double done = 0.0; ///< 0 .. 1
};

/// A sentence for the status line; errors stay until dismissed or replaced.
struct Message {
    std::string text;
    bool isError = false;
};

/// What a program that did not end left behind.
struct EarlierSession {
    std::string file;
    std::string content;    ///< "mug, hybrid, 2 lights"; empty where the file cannot be read
    std::string when;       ///< "5 minutes ago"
    bool dismissed = false; ///< no longer offered; the Open menu has it until the program ends
};

/// The workbench's page of colour: the question, and what was found for it.
struct ColourPage {
    ColorQuestion question;
    Cheat cheat = Cheat::ColorUnderWhite;
    Convention convention = Convention::Primary;
    std::size_t patch = 14;             ///< of the chart: red
    std::optional<ColorQuestion> asked; ///< the question that was answered last
    std::optional<ColorAnswer> answer;  ///< the last good one
    std::string problem;                ///< why there is none for `asked`
    bool showsPair = false;             ///< a metameric pair in the chart's place
    ObjectStudy object;
};

struct ExplorerState {
    Scene scene;
    CompareView compare;
    std::vector<SkippedRung> idleRungsA, idleRungsB; ///< that change nothing here, and why
    GrabTool grab;
    History history;
    SurfaceShelf shelf;
    int selectedLight = 0; ///< index into scene.lights, -1 for none
    int soloLight = -1;    ///< only this light shines; -1 for all
    std::string soloPart;  ///< of the sensor: only this part works, beside exposure and encoding; empty for all
    bool turntable = false;
    bool showHelp = false;
    bool showFileBrowser = false;
    Preferences preferences;

    std::vector<Request> requests;
    std::optional<Loading> loading;
    std::optional<Message> message;
    std::vector<EarlierSession> earlierSessions; ///< newest first

    // What the status line reports.
    double frameMilliseconds = 0.0;
    StandInFacts standIn;
    std::string firstPicture;        ///< "First picture after 0.61 s."
    std::string renderer;            ///< "llvmpipe (LLVM 15.0.6, 256 bits)"
    std::vector<PriceTag> priceTags; ///< of the current scene; empty while being measured
    bool measuringPrices = false;
    std::optional<SensorCounts> sensorCounts; ///< of the last picture; none where they were not counted
    std::optional<PixelReading> pixel;        ///< under the mouse, of the picture at rest
    SensorStudy sensorStudy;

    // What is known of the picture at rest.
    std::optional<GlCheck> glCheck;  ///< GL against double; none while it is being looked at
    bool markWorstPixel = false;     ///< also where it is within its bound
    bool worstPixelSelected = false; ///< its values stand beside it
    std::optional<LensKind> lens;    ///< the arithmetic whose digits lie over the picture
    std::optional<LensFigures> lensFigures;

    ExtremesStudy extremes;
    ExtremesPage extremesPage;
    std::optional<PutAside> putAside; ///< a hazard's case or the tour is shown, and the user's scene waits here
    Guide guide;
    CurvesPage curves;
    ColourPage colour;
    FitStudy fit;
    LabStudy lab;
    TablePage tablePage;
    TradeStudy trade;
    ProbeStudy probe;

    // Between the panels and the frame loop.
    PanelMemory panels;
    bool takingPicture = false; ///< this frame is kept as the picture of a plot: no button in it
    bool drawSoon = false;      ///< a panel waits for time to pass (tooltip, text cursor): draw again within 0.1 s
};

/// The earlier session that is offered now: the newest that has not been dismissed; null if there is none.
[[nodiscard]] const EarlierSession* offeredSession(const ExplorerState& state);

/// The scene as it is drawn: solo leaves one light on, and holes of a measured table are seen.
[[nodiscard]] Scene shownScene(const ExplorerState& state);

} // namespace reflectance::explorer
