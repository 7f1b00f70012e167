#include "EdgePaths.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace lodsmith::analysis {

EdgePaths::EdgePaths(const std::vector<bool>& kept) : mKept(kept), mParents(kept.size()), mRanks(kept.size(), 0)
{
    std::iota(mParents.begin(), mParents.end(), 0u);
}

void EdgePaths::add(std::uint32_t a, std::uint32_t b, std::uint32_t rank)
{
    if (mKept[a] && mKept[b]) {
        mDirect.push_back({std::min(a, b), std::max(a, b), rank});
        return;
    }
    if (!mKept[a] && !mKept[b])
        mParents[clusterOf(a)] = clusterOf(b);
    mEdges.push_back({a, b, rank});
}

void EdgePaths::seal()
{
    for (const Edge& edge : mEdges) {
        const std::uint32_t cluster = clusterOf(mKept[edge.a] ? edge.b : edge.a);
        mRanks[cluster] = std::max(mRanks[cluster], edge.rank);
        if (mKept[edge.a] || mKept[edge.b])
            mTouched.emplace_back(mKept[edge.a] ? edge.a : edge.b, cluster);
    }
    mEdges.clear();
    std::sort(mTouched.begin(), mTouched.end());
    std::sort(mDirect.begin(), mDirect.end(), precedes);
}

bool EdgePaths::precedes(const Edge& x, const Edge& y)
{
    return std::tie(x.a, x.b) < std::tie(y.a, y.b);
}

bool EdgePaths::join(std::uint32_t a, std::uint32_t b, std::uint32_t rank) const
{
    const Edge wanted{std::min(a, b), std::max(a, b), rank};
    const auto direct = std::lower_bound(mDirect.begin(), mDirect.end(), wanted, precedes);
    if (direct != mDirect.end() && direct->a == wanted.a && direct->b == wanted.b && direct->rank >= rank)
        return true;
    auto link = std::lower_bound(mTouched.begin(), mTouched.end(), Link{a, 0});
    for (; link != mTouched.end() && link->first == a; ++link)
        if (mRanks[link->second] >= rank && std::binary_search(mTouched.begin(), mTouched.end(), Link{b, link->second}))
            return true;
    return false;
}

std::uint32_t EdgePaths::clusterOf(std::uint32_t vertex)
{
    while (mParents[vertex] != vertex)
        vertex = mParents[vertex] = mParents[mParents[vertex]];
    return vertex;
}

} // namespace lodsmith::analysis
