#include "FrameFigures.h"
#include "LibraryLods.h"
#include "Options.h"
#include "Overlay.h"
#include "Scene.h"
#include "Window.h"

#include <CLI/CLI.hpp>

#include <chrono>
#include <cmath>
#include <exception>
#include <iostream>
#include <memory>

namespace lodsmith::samples {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kRoundSeconds = 60.0;
constexpr double kNewsSeconds = 1.0;

double secondsSince(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Draws frame after frame until the user, or the number of frames, ends it.
class Show {
public:
    Show(Engine& engine, const Options& options)
        : mOptions(options), mWindow(engine, options),
          mLods(options.levels == Levels::Library ? std::make_unique<LibraryLods>() : nullptr),
          mScene(engine, mWindow.target(), options.objects), mOverlay(*mWindow.target().getViewport(0))
    {
        mScene.manager().addLodListener(&mFigures);
        if (mLods)
            report(mLods->queue.signals());
    }

    void run()
    {
        const auto start = Clock::now();
        while (secondsSince(start) < mOptions.warmUpSeconds && draw(0.0)) {
        }
        mFigures.restart();
        const auto round = Clock::now();
        for (unsigned frame = 0; mOptions.frames == 0 || frame < mOptions.frames; ++frame) {
            const double share =
                mOptions.frames ? double(frame) / mOptions.frames : secondsSince(round) / kRoundSeconds;
            if (!draw(share - std::floor(share)))
                return;
        }
        if (!mOptions.screenshot.empty())
            mWindow.target().writeContentsToFile(mOptions.screenshot);
        std::cout << mFigures.summary() << std::endl;
    }

private:
    static void report(PMInjectorSignaler& signals)
    {
        signals.injected.connect([](const Ogre::MeshPtr& mesh, const LodReport& lods) {
            std::cout << mesh->getName() << ": " << lods.triangles;
            for (const LodLevelReport& level : lods.levels)
                if (!level.skipped)
                    std::cout << ", " << level.triangles;
            std::cout << " triangles" << std::endl;
        });
        signals.failed.connect(
            [](const Ogre::MeshPtr&, const Error& error) { std::cerr << describe(error) << std::endl; });
    }

    /// False once the window is closed.
    bool draw(double share)
    {
        const auto start = Clock::now();
        mScene.update(share, mLastSeconds);
        mFigures.beginFrame();
        const bool isOpen = mWindow.draw();
        mLastSeconds = secondsSince(start);
        mFigures.endFrame(mWindow.target().getStatistics(), 1000.0 * mLastSeconds);
        if (secondsSince(mLastNews) > kNewsSeconds) {
            mLastNews = Clock::now();
            mOverlay.show(mFigures.news());
        }
        return isOpen;
    }

    Options mOptions;
    Window mWindow;
    std::unique_ptr<LibraryLods> mLods;
    Scene mScene;
    Overlay mOverlay;
    FrameFigures mFigures;
    double mLastSeconds = 0.0;
    Clock::time_point mLastNews;
};

int say(const std::exception& exception)
{
    std::cerr << "lodsmith_sample: " << exception.what() << std::endl;
    return 1;
}

int show(const Options& options)
{
    Engine engine;
    try {
        engine.start(options.levels == Levels::Plugin ? LODSMITH_PLUGINS_DIR "/plugins-lodsmith.cfg"
                                                      : LODSMITH_PLUGINS_DIR "/plugins.cfg");
        Show(engine, options).run();
        return 0;
    } catch (const std::exception& exception) {
        return say(exception);
    }
}

int run(int argc, char** argv)
{
    Options options;
    bool noLods = false, plugin = false;
    CLI::App app{"Shows levels of detail at work: a valley of models and a camera that goes round in it"};
    app.add_flag("--no-lods", noLods, "Show the models as they are");
    app.add_flag("--plugin", plugin, "Leave the levels to Plugin_Lodsmith and plugins.cfg")->excludes("--no-lods");
    app.add_option("--objects", options.objects, "How many models")->check(CLI::Range(1, 100000));
    app.add_option("--width", options.width, "Of the window, in pixels")->check(CLI::Range(64, 8192));
    app.add_option("--height", options.height, "Of the window, in pixels")->check(CLI::Range(64, 8192));
    app.add_option("--frames", options.frames, "Draw one round in so many frames, say what they cost, and end");
    app.add_option("--warm-up", options.warmUpSeconds, "Seconds of drawing beforehand")->check(CLI::Range(0.0, 3600.0));
    app.add_option("--screenshot", options.screenshot, "File for the last of --frames")->needs("--frames");
    CLI11_PARSE(app, argc, argv);
    options.levels = noLods ? Levels::None : plugin ? Levels::Plugin : Levels::Library;
    return show(options);
}

} // namespace

} // namespace lodsmith::samples

int main(int argc, char** argv)
{
    try {
        return lodsmith::samples::run(argc, argv);
    } catch (const std::exception& exception) {
        return lodsmith::samples::say(exception);
    }
}
