#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <utility>
#include <vector>

namespace lodsmith {

/// The collapse queue: a multiset of (cost, vertex), cheapest first, equal costs by vertex number.
///
/// An entry is one 64-bit key (the bits of a non-negative float order like the number), and keys are spread over buckets
/// by exponent and leading mantissa bits. Buckets are taken from the cheapest on; only the one in front is put in order,
/// when its turn comes, and what belongs at or before it after that goes to a heap beside it. The order is exactly that
/// of a tree, without its nodes and cache misses, and the next entries are known ahead, so that their vertices can be
/// prefetched (docs/simplifier.md has the figures).
class CostMultiset {
public:
    struct Entry {
        float cost;
        std::uint32_t vertex;
    };

    bool empty() { return !settleFront(); }

    /// @param cost >= 0, not a NaN
    void insert(float cost, std::uint32_t vertex)
    {
        const std::uint64_t key = keyOf(cost, vertex);
        const std::size_t bucket = key >> kBucketShift;
        if (bucket < mTaken) {
            mLate.push_back(key);
            std::push_heap(mLate.begin(), mLate.end(), std::greater<>());
        } else {
            mBuckets[bucket].push_back(key);
            mOccupied[bucket / 64] |= std::uint64_t{1} << (bucket % 64);
        }
    }

    /// The cheapest entry; not empty.
    Entry top()
    {
        settleFront();
        return entryOf(lateIsFirst() ? mLate.front() : mFront.back());
    }

    /// Takes the cheapest entry out; not empty.
    Entry pop()
    {
        settleFront();
        const bool late = lateIsFirst();
        if (late)
            std::pop_heap(mLate.begin(), mLate.end(), std::greater<>());
        std::vector<std::uint64_t>& source = late ? mLate : mFront;
        const Entry entry = entryOf(source.back());
        source.pop_back();
        return entry;
    }

    /// A vertex that will probably come up `ahead` pops from now; any vertex of an entry will do for that. Call after pop().
    bool expected(std::size_t ahead, std::uint32_t& vertex) const
    {
        if (mFront.size() <= ahead)
            return false;
        vertex = static_cast<std::uint32_t>(mFront[mFront.size() - 1 - ahead]);
        return true;
    }

private:
    static constexpr int kBucketShift = 32 + 20; // exponent and three mantissa bits: eight buckets an octave
    static constexpr std::size_t kBucketCount = 2048;

    static std::uint64_t keyOf(float cost, std::uint32_t vertex)
    {
        const float positive = cost + 0.0f; // -0 would sort last
        std::uint32_t bits;
        std::memcpy(&bits, &positive, sizeof bits);
        return std::uint64_t{bits} << 32 | vertex;
    }

    static Entry entryOf(std::uint64_t key)
    {
        const auto bits = static_cast<std::uint32_t>(key >> 32);
        Entry entry;
        std::memcpy(&entry.cost, &bits, sizeof bits);
        entry.vertex = static_cast<std::uint32_t>(key);
        return entry;
    }

    bool lateIsFirst() const { return !mLate.empty() && (mFront.empty() || mLate.front() < mFront.back()); }

    /// Takes the next bucket when nothing is left in front. False when there is none.
    bool settleFront()
    {
        if (!mFront.empty() || !mLate.empty())
            return true;
        const std::size_t next = nextOccupied(mTaken);
        if (next == kBucketCount) {
            mTaken = 0; // with nothing left, what comes may be spread over all buckets again
            return false;
        }
        mTaken = next + 1;
        mOccupied[next / 64] &= ~(std::uint64_t{1} << (next % 64));
        mFront = std::move(mBuckets[next]);
        std::sort(mFront.begin(), mFront.end(), std::greater<>());
        return true;
    }

    std::size_t nextOccupied(std::size_t from) const
    {
        for (std::size_t word = from / 64; word < mOccupied.size(); ++word) {
            const std::uint64_t first = word == from / 64 ? ~std::uint64_t{0} << (from % 64) : ~std::uint64_t{0};
            if (const std::uint64_t bits = mOccupied[word] & first; bits != 0)
                return word * 64 + lowestBit(bits);
        }
        return kBucketCount;
    }

    static std::size_t lowestBit(std::uint64_t bits)
    {
        std::size_t position = 0;
        for (; (bits & 1) == 0; bits >>= 1)
            ++position;
        return position;
    }

    std::array<std::vector<std::uint64_t>, kBucketCount> mBuckets;
    std::array<std::uint64_t, kBucketCount / 64> mOccupied{};
    std::size_t mTaken = 0;            ///< buckets before this one have had their turn
    std::vector<std::uint64_t> mFront; ///< the bucket taken last, descending
    std::vector<std::uint64_t> mLate;  ///< a heap of what came after its bucket's turn
};

} // namespace lodsmith
