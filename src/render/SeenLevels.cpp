#include <lodsmith/render/SeenLevels.h>

#include <lodsmith/render/LevelRenderer.h>

#include <algorithm>
#include <cmath>

namespace lodsmith {

namespace {

constexpr auto kDirections = static_cast<double>(kViewDirections);

/// Takes the differences of one direction after the other together.
class Gathered {
public:
    void add(const Image& original, const Image& other)
    {
        const ImageDifference one = compareImages(original, other);
        mSum.largest = std::max(mSum.largest, one.largest);
        mSum.mean += one.mean / kDirections;
        mSum.ssim -= (1 - one.ssim) / kDirections;
        mSum.leastSsim = std::min(mSum.leastSsim, one.ssim);
        mSum.silhouetteShare += one.silhouette.share / kDirections;
        mSum.silhouetteDistance = std::max(mSum.silhouetteDistance, one.silhouette.distance);
        mSum.leastCoverage = std::min(mSum.leastCoverage, one.coverage);
        mOriginalPixels += coveredPixels(original);
        mOtherPixels += coveredPixels(other);
    }

    SeenDifference result() const
    {
        SeenDifference result = mSum;
        if (mOtherPixels != mOriginalPixels)
            result.coverage = mOtherPixels / std::max(mOriginalPixels, 1.0);
        return result;
    }

private:
    SeenDifference mSum;
    double mOriginalPixels = 0;
    double mOtherPixels = 0;
};

/// What is gathered about a level in a paint.
struct LevelGathered {
    Gathered atSwitch;
    Gathered popping;
    Gathered closeUp;
};

/// Compares the levels in one paint, one direction after the other.
class PaintComparison {
public:
    PaintComparison(LevelRenderer& renderer, Paint paint, const SeenOptions& options)
        : mRenderer(renderer), mPaint(paint), mOptions(options), mLevels(renderer.levels())
    {
    }

    Result<Done> look(const Ogre::Vector3& direction, const std::vector<SeenLevel>& seen)
    {
        const Viewpoint near = mRenderer.closeUp(direction, mOptions.closeUpSize);
        const Result<Image> original = mRenderer.picture(0, mPaint, near);
        if (!original)
            return original.error();
        for (unsigned level = 1; level < mLevels.size(); ++level) {
            const Result<Image> closeUp = mRenderer.picture(level, mPaint, near);
            if (!closeUp)
                return closeUp.error();
            mLevels[level].closeUp.add(original.value(), closeUp.value());
            if (!seen[level].appears())
                continue;
            if (auto compared = compareAtSwitch(level, direction); !compared)
                return compared;
        }
        return Done{};
    }

    void store(std::vector<SeenLevel>& levels, SeenDifference PaintedDifference::*paint) const
    {
        for (std::size_t i = 0; i < levels.size(); ++i) {
            levels[i].atSwitch.*paint = mLevels[i].atSwitch.result();
            levels[i].popping.*paint = mLevels[i].popping.result();
            levels[i].closeUp.*paint = mLevels[i].closeUp.result();
        }
    }

private:
    Result<Done> compareAtSwitch(unsigned level, const Ogre::Vector3& direction)
    {
        const Result<Viewpoint> place = mRenderer.atSwitch(level, direction, mOptions.screen);
        if (!place)
            return place.error();
        const Result<Image> original = mRenderer.picture(0, mPaint, place.value());
        if (!original)
            return original.error();
        const Result<Image> before = level == 1 ? original : mRenderer.picture(level - 1, mPaint, place.value());
        if (!before)
            return before.error();
        const Result<Image> after = mRenderer.picture(level, mPaint, place.value());
        if (!after)
            return after.error();
        mLevels[level].atSwitch.add(original.value(), after.value());
        mLevels[level].popping.add(before.value(), after.value());
        return Done{};
    }

    LevelRenderer& mRenderer;
    Paint mPaint;
    const SeenOptions& mOptions;
    std::vector<LevelGathered> mLevels;
};

/// Triangles and where the levels switch.
Result<std::vector<SeenLevel>> levelsOf(const LevelRenderer& renderer, const Screen& screen)
{
    std::vector<SeenLevel> levels(renderer.levels());
    const auto radius = static_cast<double>(renderer.mesh()->getBoundingSphereRadius());
    for (unsigned i = 0; i < levels.size(); ++i) {
        SeenLevel& level = levels[i];
        level.triangles = renderer.triangles(i);
        for (const Ogre::Vector3& direction : viewDirections()) {
            if (i == 0)
                break;
            const Result<double> distance = switchDistance(*renderer.mesh(), i, direction, screen);
            if (!distance)
                return distance.error();
            if (!std::isfinite(distance.value()))
                break;
            const bool isFirst = level.switchDistance == 0;
            level.switchDistance = isFirst ? distance.value() : std::min(level.switchDistance, distance.value());
            level.switchRadius = pixelsOf(radius, level.switchDistance, screen);
        }
    }
    return levels;
}

} // namespace

Result<std::vector<SeenLevel>> measureSeenLevels(LevelRenderer& renderer, const SeenOptions& options,
                                                 Progress* progress)
{
    Result<std::vector<SeenLevel>> levels = levelsOf(renderer, options.screen);
    if (!levels)
        return levels;
    PaintComparison lit(renderer, Paint::Own, options), checker(renderer, Paint::Checker, options);
    float done = 0;
    for (const Ogre::Vector3& direction : viewDirections())
        for (PaintComparison* paint : {&lit, &checker}) {
            if (progress && progress->cancelled())
                return Error{ErrorCode::Cancelled, "cancelled"};
            if (const Result<Done> looked = paint->look(direction, levels.value()); !looked)
                return looked.error();
            if (progress)
                progress->report(++done / static_cast<float>(2 * kDirections));
        }
    lit.store(levels.value(), &PaintedDifference::lit);
    checker.store(levels.value(), &PaintedDifference::checker);
    return levels;
}

} // namespace lodsmith
