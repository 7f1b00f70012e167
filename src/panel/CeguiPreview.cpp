#include "CeguiPreview.h"

#include "Canvas.h"
#include "HeatMap.h"

#include <cmath>

namespace lodsmith {

namespace {

constexpr unsigned kLegendWidth = 128;
constexpr unsigned kLegendHeight = 8;

std::uint8_t byteFrom(float share)
{
    return static_cast<std::uint8_t>(std::lround(share * 255));
}

Canvas paintLegend()
{
    Canvas canvas(kLegendWidth, kLegendHeight);
    for (unsigned column = 0; column < kLegendWidth; ++column) {
        const Ogre::ColourValue colour = heatColour(static_cast<float>(column) / (kLegendWidth - 1));
        const float x = static_cast<float>(column) + 0.5f;
        canvas.line(x, 0, x, kLegendHeight, 1, {byteFrom(colour.r), byteFrom(colour.g), byteFrom(colour.b), 255});
    }
    return canvas;
}

} // namespace

CeguiPreview::CeguiPreview(LevelAnalyser& analyser)
    : preview(analyser), image(preview), legend(image.name() + " legend")
{
    legend.show(paintLegend());
}

} // namespace lodsmith
