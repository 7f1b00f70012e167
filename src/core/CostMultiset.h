#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <functional>
#include <vector>

namespace lodsmith {

/// The collapse queue: a multiset of (cost, vertex), cheapest first, equal costs by vertex number.
///
/// An entry is one 64-bit key (the bits of a non-negative float order like the number), and keys are spread over buckets
/// by exponent and leading mantissa bits. Only the bucket in front is kept as a heap; the others are unsorted, so that
/// an insertion is an append. The order is exactly that of a tree, without its nodes and cache misses (docs/simplifier.md).
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
        const std::size_t index = key >> kBucketShift;
        Bucket& bucket = mBuckets[index];
        bucket.keys.push_back(key);
        if (bucket.isHeap)
            std::push_heap(bucket.keys.begin(), bucket.keys.end(), std::greater<>());
        mOccupied[index / 64] |= std::uint64_t{1} << (index % 64);
        mFront = std::min(mFront, index);
    }

    /// The cheapest entry; not empty.
    Entry top()
    {
        settleFront();
        return entryOf(mBuckets[mFront].keys.front());
    }

    /// Takes the cheapest entry out; not empty.
    Entry pop()
    {
        settleFront();
        Bucket& bucket = mBuckets[mFront];
        std::pop_heap(bucket.keys.begin(), bucket.keys.end(), std::greater<>());
        const Entry entry = entryOf(bucket.keys.back());
        bucket.keys.pop_back();
        if (bucket.keys.empty()) {
            bucket.isHeap = false;
            mOccupied[mFront / 64] &= ~(std::uint64_t{1} << (mFront % 64));
        }
        return entry;
    }

private:
    static constexpr int kBucketShift = 32 + 20; // exponent and three mantissa bits: eight buckets an octave
    static constexpr std::size_t kBucketCount = 2048;

    struct Bucket {
        std::vector<std::uint64_t> keys;
        bool isHeap = false;
    };

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

    /// Finds the lowest occupied bucket and makes a heap of it. False when there is none.
    bool settleFront()
    {
        while (mFront < kBucketCount && mBuckets[mFront].keys.empty())
            mFront = nextOccupied(mFront + 1);
        if (mFront == kBucketCount)
            return false;
        Bucket& bucket = mBuckets[mFront];
        if (!bucket.isHeap) {
            std::make_heap(bucket.keys.begin(), bucket.keys.end(), std::greater<>());
            bucket.isHeap = true;
        }
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

    std::array<Bucket, kBucketCount> mBuckets;
    std::array<std::uint64_t, kBucketCount / 64> mOccupied{};
    std::size_t mFront = kBucketCount;
};

} // namespace lodsmith
