#include "LeafChoice.h"

#include <algorithm>
#include <queue>
#include <tuple>
#include <utility>

namespace lodsmith::generators {

namespace {

constexpr double kOne = 1 << 20; // gains are whole numbers: their sums are exact and fast

/// A way to keep a leaf.
struct Option {
    double gain = 0.0; ///< above 0 for something worth while
    ChosenLeaf choice;

    bool operator<(const Option& other) const
    {
        return std::tie(gain, other.choice.leaf) < std::tie(other.gain, choice.leaf);
    }
};

class Chooser {
public:
    Chooser(const ChoiceTask& task, const Progress* progress)
        : mTask(task), mProgress(progress), mLayers(task.wood.layers()), mGains(mLayers.size()), mLeft(task.triangles),
          mIsChosen(task.leaves.size(), false)
    {
        for (std::size_t pixel = 0; pixel < mLayers.size(); ++pixel)
            computeGain(pixel);
    }

    void choose()
    {
        addGreedily();
        reconsider();
        addGreedily();
    }

    LeafChoice result()
    {
        LeafChoice result;
        double whole = 0.0, outline = 0.0;
        for (std::size_t pixel = 0; pixel < mLayers.size(); ++pixel) {
            const std::uint32_t layers = mTask.original.layers()[pixel];
            whole += mTask.opacity.of(layers);
            outline += layers > 0 ? 1.0 : 0.0;
            result.kept += layers > 0 && mLayers[pixel] > 0 ? 1.0 : 0.0;
            result.value += value(pixel, mLayers[pixel]);
        }
        result.kept = outline > 0.0 ? result.kept / outline : 1.0;
        result.value = whole > 0.0 ? result.value / whole : 1.0;
        std::sort(mChosen.begin(), mChosen.end(),
                  [](const ChosenLeaf& a, const ChosenLeaf& b) { return a.leaf < b.leaf; });
        result.leaves = std::move(mChosen);
        return result;
    }

private:
    bool stopped() const { return mProgress && mProgress->cancelled(); }

    const std::vector<LeafTriangle>& form(const ChosenLeaf& choice) const
    {
        return mTask.leaves[choice.leaf].forms[choice.form];
    }

    std::uint32_t size(const ChosenLeaf& choice) const { return static_cast<std::uint32_t>(form(choice).size()); }

    /// The triangles of a leaf that is enlarged around its centre.
    template <class Visitor>
    void forEachTriangle(const ChosenLeaf& choice, Visitor&& visit) const
    {
        const Point& centre = mTask.leaves[choice.leaf].centre;
        const double scale = kLeafScales[choice.scale];
        for (const LeafTriangle& triangle : form(choice)) {
            std::array<Point, 3> corner = triangle.corner;
            for (Point& point : corner)
                for (std::size_t axis = 0; axis < 3; ++axis)
                    point[axis] = centre[axis] + scale * (point[axis] - centre[axis]);
            visit(project(mTask.frame, corner));
        }
    }

    /// How near so many layers in a pixel come to the original, less what is too much.
    double value(std::size_t pixel, std::uint32_t layers) const
    {
        const double wanted = mTask.opacity.of(mTask.original.layers()[pixel]), given = mTask.opacity.of(layers);
        return std::min(wanted, given) - mTask.excessWeight * std::max(0.0, given - wanted);
    }

    /// What one more layer would be worth.
    void computeGain(std::size_t pixel)
    {
        const std::uint32_t layers = mLayers[pixel];
        const double gain = value(pixel, layers + 1) - value(pixel, layers);
        mGains[pixel] = static_cast<std::int32_t>(gain * kOne);
    }

    double gain(const ChosenLeaf& choice) const
    {
        std::int64_t sum = 0;
        forEachTriangle(choice, [&](const PictureTriangle& triangle) {
            analysis::forEachRun(mTask.frame, triangle, [&](std::size_t first, std::size_t last) {
                for (std::size_t pixel = first; pixel < last; ++pixel)
                    sum += mGains[pixel];
            });
        });
        return static_cast<double>(sum);
    }

    void addLayers(const ChosenLeaf& choice, int count)
    {
        forEachTriangle(choice, [&](const PictureTriangle& triangle) {
            analysis::forEachRun(mTask.frame, triangle, [&](std::size_t first, std::size_t last) {
                for (std::size_t pixel = first; pixel < last; ++pixel) {
                    mLayers[pixel] += static_cast<std::uint32_t>(count); // of -1 the sum wraps around as it should
                    computeGain(pixel);
                }
            });
        });
    }

    void add(const ChosenLeaf& choice)
    {
        addLayers(choice, 1);
        mLeft -= size(choice);
    }

    void remove(const ChosenLeaf& choice)
    {
        addLayers(choice, -1);
        mLeft += size(choice);
    }

    /// The way to keep a leaf that gains most, by triangle or altogether, among those for which there is room.
    Option best(std::uint32_t leaf, bool byTriangle) const
    {
        Option best;
        best.choice.leaf = leaf;
        const std::size_t forms = mTask.leaves[leaf].forms.size();
        for (std::uint32_t form = 0; form < forms; ++form)
            for (std::uint32_t scale = 0; scale < kLeafScales.size(); ++scale) {
                const ChosenLeaf choice{leaf, form, scale};
                if (size(choice) > mLeft)
                    continue;
                const double gained = gain(choice) / (byTriangle ? double(size(choice)) : 1.0);
                if (gained > best.gain)
                    best = {gained, choice};
            }
        return best;
    }

    /// Gains fall as others are chosen, so that only what is on top has to be computed again.
    void addGreedily()
    {
        std::priority_queue<Option> queue;
        for (const std::uint32_t leaf : mTask.candidates)
            if (!mIsChosen[leaf] && mLeft > 0)
                queue.push(best(leaf, true));
        while (!queue.empty() && mLeft > 0 && !stopped()) {
            Option option = queue.top();
            queue.pop();
            option.gain = size(option.choice) <= mLeft ? gain(option.choice) / double(size(option.choice)) : 0.0;
            if (option.gain <= 0.0 || (!queue.empty() && option < queue.top())) {
                option = best(option.choice.leaf, true);
                if (option.gain > 0.0)
                    queue.push(option);
                continue;
            }
            add(option.choice);
            mIsChosen[option.choice.leaf] = true;
            mChosen.push_back(option.choice);
        }
    }

    /// Takes each leaf out and puts it back in the best way, which by now can be another one, or none.
    void reconsider()
    {
        std::vector<ChosenLeaf> kept;
        for (const ChosenLeaf& choice : mChosen) {
            remove(choice);
            const Option option = stopped() ? Option{1.0, choice} : best(choice.leaf, false);
            mIsChosen[choice.leaf] = option.gain > 0.0;
            if (option.gain <= 0.0)
                continue;
            add(option.choice);
            kept.push_back(option.choice);
        }
        mChosen = std::move(kept);
    }

    const ChoiceTask& mTask;
    const Progress* mProgress;
    std::vector<std::uint32_t> mLayers;
    std::vector<std::int32_t> mGains; // of one more layer in each pixel
    std::uint32_t mLeft;              // triangles
    std::vector<bool> mIsChosen;
    std::vector<ChosenLeaf> mChosen;
};

} // namespace

LeafChoice chooseLeaves(const ChoiceTask& task, const Progress* progress)
{
    Chooser chooser(task, progress);
    chooser.choose();
    return chooser.result();
}

} // namespace lodsmith::generators
