#include "PoseChoice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace lodsmith {

namespace {

constexpr std::size_t kMostMoments = 128; // looked at: each costs a step of the animation
constexpr double kLeastNews = 1e-3;       // of the radius, root mean square over all vertices

/// Sums over the vertices that two bones share (or over those of one): of the squares and products of x, y, z and 1.
struct Moments {
    std::array<std::array<double, 4>, 4> sums{};

    void add(const double* point, double weight)
    {
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t k = 0; k < 4; ++k)
                sums[i][k] += weight * point[i] * point[k];
    }
};

using BonePair = std::pair<std::uint16_t, std::uint16_t>;

/// How one bone of a pair moves the vertices, seen from the other: a row for each of x, y and z. Zero at rest.
using Motion = std::array<std::array<double, 4>, 3>;

/// Sum of the squared distances between where two motions take a pair's vertices.
double squaredDifference(const Motion& a, const Motion& b, const Moments& moments)
{
    double sum = 0.0;
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t k = 0; k < 4; ++k)
                sum += (a[row][i] - b[row][i]) * moments.sums[i][k] * (a[row][k] - b[row][k]);
    return std::max(0.0, sum);
}

class Choice {
public:
    explicit Choice(const MeshView& mesh)
    {
        for (const VertexBufferView& buffer : mesh.vertexBuffers)
            readBuffer(buffer);
    }

    std::vector<PoseMoment> choose(SkeletonMoments& skeleton, std::size_t most)
    {
        if (mPairs.empty())
            return {};
        SkeletonMoments::Bones bones;
        for (const PoseMoment& moment : skeleton.all(kMostMoments))
            if (skeleton.at(moment, bones) && hasAllBones(bones))
                addCandidate(moment, bones);
        std::vector<PoseMoment> chosen;
        while (chosen.size() < most) {
            const std::size_t next = mostNews();
            if (next == mCandidates.size())
                break;
            chosen.push_back(mCandidates[next].moment);
            show(next);
        }
        return chosen;
    }

private:
    struct Candidate {
        PoseMoment moment;
        std::vector<Motion> motions; ///< of each pair
        std::vector<double> news;    ///< of each pair: squared difference from the nearest that is shown
    };

    void readBuffer(const VertexBufferView& buffer)
    {
        for (std::uint32_t v = 0; v < buffer.vertexCount; ++v) {
            float position[3];
            buffer.positions.read(v, 3, position);
            if (!std::isfinite(position[0] + position[1] + position[2]))
                continue;
            for (std::size_t i = 0; i < 3; ++i) {
                mLow[i] = std::min(mLow[i], position[i]);
                mHigh[i] = std::max(mHigh[i], position[i]);
            }
            ++mVertices;
            if (buffer.bones)
                addVertex(position, buffer.bones[v]);
        }
    }

    void addVertex(const float* position, const BoneInfluences& influences)
    {
        const double point[4] = {position[0], position[1], position[2], 1.0};
        for (int i = 0; i < 4; ++i)
            for (int k = 0; k < 4; ++k) {
                const double weight = double{influences.weight[i]} * influences.weight[k];
                if (weight > 0.0 && influences.bone[i] <= influences.bone[k])
                    mPairs[{influences.bone[i], influences.bone[k]}].add(point, weight);
            }
    }

    bool hasAllBones(const SkeletonMoments::Bones& bones) const
    {
        return std::all_of(mPairs.begin(), mPairs.end(),
                           [&](const auto& pair) { return pair.first.second < bones.transforms.size(); });
    }

    static Motion seenFrom(const Ogre::Quaternion& turn, const Ogre::Affine3& difference)
    {
        Motion motion;
        for (std::size_t column = 0; column < 4; ++column) {
            const Ogre::Vector3 seen =
                turn.Inverse() * Ogre::Vector3(difference[0][column], difference[1][column], difference[2][column]);
            for (std::size_t row = 0; row < 3; ++row)
                motion[row][column] = seen[row];
        }
        return motion;
    }

    /// What a bone does to its vertices besides turning them and taking them elsewhere.
    static Motion stretch(const Ogre::Quaternion& turn, const Ogre::Affine3& transform, const Moments& moments)
    {
        Motion motion = seenFrom(turn, transform);
        for (std::size_t row = 0; row < 3; ++row) {
            motion[row][row] -= 1.0;
            motion[row][3] = 0.0;
            for (std::size_t i = 0; i < 3; ++i)
                motion[row][3] -= motion[row][i] * moments.sums[i][3] / moments.sums[3][3];
        }
        return motion;
    }

    static Motion motionOf(const BonePair& pair, const Moments& moments, const SkeletonMoments::Bones& bones)
    {
        const Ogre::Affine3 &first = bones.transforms[pair.first], &second = bones.transforms[pair.second];
        const Ogre::Quaternion& turn = bones.turns[pair.first];
        if (pair.first == pair.second)
            return stretch(turn, first, moments);
        Ogre::Affine3 difference;
        for (std::size_t row = 0; row < 3; ++row)
            for (std::size_t column = 0; column < 4; ++column)
                difference[row][column] = second[row][column] - first[row][column];
        return seenFrom(turn, difference);
    }

    void addCandidate(const PoseMoment& moment, const SkeletonMoments::Bones& bones)
    {
        Candidate candidate{moment, {}, {}};
        for (const auto& [pair, moments] : mPairs) {
            candidate.motions.push_back(motionOf(pair, moments, bones));
            candidate.news.push_back(squaredDifference(candidate.motions.back(), Motion{}, moments));
        }
        mCandidates.push_back(std::move(candidate));
    }

    /// The first of equal ones; the number of candidates when none tells anything new.
    std::size_t mostNews() const
    {
        const double squaredRadius = 0.25
                                     * (square(double{mHigh[0]} - mLow[0]) + square(double{mHigh[1]} - mLow[1])
                                        + square(double{mHigh[2]} - mLow[2]));
        double most = static_cast<double>(mVertices) * square(kLeastNews) * squaredRadius;
        std::size_t best = mCandidates.size();
        for (std::size_t i = 0; i < mCandidates.size(); ++i) {
            double sum = 0.0;
            for (const double news : mCandidates[i].news)
                sum += news;
            if (sum > most) {
                most = sum;
                best = i;
            }
        }
        return best;
    }

    void show(std::size_t shown)
    {
        const std::vector<Motion> motions = mCandidates[shown].motions;
        for (Candidate& candidate : mCandidates) {
            std::size_t i = 0;
            for (const auto& [pair, moments] : mPairs) {
                candidate.news[i] =
                    std::min(candidate.news[i], squaredDifference(candidate.motions[i], motions[i], moments));
                ++i;
            }
        }
    }

    static double square(double x) { return x * x; }

    std::map<BonePair, Moments> mPairs;
    std::vector<Candidate> mCandidates;
    std::size_t mVertices = 0;
    std::array<float, 3> mLow{std::numeric_limits<float>::max(), std::numeric_limits<float>::max(),
                              std::numeric_limits<float>::max()};
    std::array<float, 3> mHigh{std::numeric_limits<float>::lowest(), std::numeric_limits<float>::lowest(),
                               std::numeric_limits<float>::lowest()};
};

} // namespace

std::vector<PoseMoment> choosePoses(const MeshView& mesh, SkeletonMoments& skeleton, std::size_t most)
{
    return Choice(mesh).choose(skeleton, most);
}

} // namespace lodsmith
