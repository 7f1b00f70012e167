#include <lodsmith/panel/Graph.h>

#include "Canvas.h"
#include "CeguiImage.h"

#include <CEGUI/System.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace lodsmith {

namespace {

constexpr unsigned kMaxSize = 4096;
constexpr Rgba kBackground = {28, 31, 36, 255};
constexpr Rgba kTick = {62, 68, 78, 255};
constexpr Rgba kAxis = {132, 140, 152, 255};
constexpr Rgba kCurve = {96, 178, 255, 255};
constexpr Rgba kMarker = {236, 240, 245, 255};
constexpr Rgba kSelected = {255, 160, 40, 255};

} // namespace

Result<std::unique_ptr<Graph>> Graph::create(const std::string& name)
{
    if (!CEGUI::System::getSingletonPtr())
        return Error{ErrorCode::NotFound, "a graph needs CEGUI, which does not run"};
    if (!CeguiImage::isFree(name))
        return Error{ErrorCode::InvalidSetting, "CEGUI has an image of this name already", name};
    return std::unique_ptr<Graph>(new Graph(name));
}

Graph::Graph(const std::string& name) : mImage(std::make_unique<CeguiImage>(name)) {}

Graph::~Graph() = default;

const std::string& Graph::image() const
{
    return mImage->name();
}

void Graph::resize(unsigned width, unsigned height)
{
    mWidth = std::clamp(width, 1u, kMaxSize);
    mHeight = std::clamp(height, 1u, kMaxSize);
}

void Graph::setTicks(std::vector<float> upright, std::vector<float> level)
{
    mUpright = std::move(upright);
    mLevel = std::move(level);
}

Result<Done> Graph::draw()
{
    if (!mImage->isAlive())
        return Error{ErrorCode::NotFound, "CEGUI, which the graph belongs to, is gone", image()};
    Canvas canvas(mWidth, mHeight);
    canvas.fill(kBackground);
    paintTicks(canvas);
    paintCurve(canvas);
    paintMarkers(canvas);
    mImage->show(canvas);
    return Done{};
}

GraphPoint Graph::onCanvas(const GraphPoint& point) const
{
    const float margin = kMargin;
    const float x = std::clamp(point.x, 0.0f, 1.0f), y = std::clamp(point.y, 0.0f, 1.0f);
    return {margin + x * std::max(static_cast<float>(mWidth) - 2 * margin, 0.0f),
            static_cast<float>(mHeight) - margin - y * std::max(static_cast<float>(mHeight) - 2 * margin, 0.0f)};
}

void Graph::paintTicks(Canvas& canvas) const
{
    // On the middle of pixels, so that they are sharp.
    const auto across = [&](GraphPoint from, GraphPoint to, const Rgba& colour) {
        from = onCanvas(from);
        to = onCanvas(to);
        canvas.line(std::floor(from.x) + 0.5f, std::floor(from.y) + 0.5f, std::floor(to.x) + 0.5f,
                    std::floor(to.y) + 0.5f, 1, colour);
    };
    for (const float x : mUpright)
        across({x, 0}, {x, 1}, kTick);
    for (const float y : mLevel)
        across({0, y}, {1, y}, kTick);
    across({0, 0}, {1, 0}, kAxis);
    across({0, 0}, {0, 1}, kAxis);
}

void Graph::paintCurve(Canvas& canvas) const
{
    const GraphPoint* before = nullptr;
    for (const GraphPoint& point : mCurve) {
        if (!std::isfinite(point.x) || !std::isfinite(point.y))
            continue;
        const GraphPoint from = onCanvas(before ? *before : point), to = onCanvas(point);
        canvas.line(from.x, from.y, to.x, to.y, 2, kCurve);
        before = &point;
    }
}

void Graph::paintMarkers(Canvas& canvas) const
{
    for (const bool selected : {false, true})
        for (const GraphMarker& marker : mMarkers) {
            if (marker.selected != selected || !std::isfinite(marker.at.x) || !std::isfinite(marker.at.y))
                continue;
            const GraphPoint at = onCanvas(marker.at);
            canvas.disc(at.x, at.y, selected ? 6.0f : 5.0f, kBackground);
            canvas.disc(at.x, at.y, selected ? 5.0f : 3.5f, selected ? kSelected : kMarker);
        }
}

} // namespace lodsmith
