#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <vector>

namespace lodsmith {

/// The collapse queue: a multiset of (cost, vertex), cheapest first, equal costs by vertex number.
///
/// An entry is one 64-bit key (the bits of a non-negative float order like the number), and keys are spread over buckets
/// by exponent and leading mantissa bits. Only the bucket in front is in order: sorted when it gets there, with a heap
/// beside it for what comes later; the others take insertions as they come. The order is exactly that of a tree, without
/// its nodes and cache misses, and the next entries are known ahead, so that their vertices can be prefetched
/// (docs/simplifier.md has the figures).
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
        if (bucket.isSorted) {
            bucket.late.push_back(key);
            std::push_heap(bucket.late.begin(), bucket.late.end(), std::greater<>());
        } else {
            bucket.keys.push_back(key);
        }
        mOccupied[index / 64] |= std::uint64_t{1} << (index % 64);
        mFront = std::min(mFront, index);
    }

    /// The cheapest entry; not empty.
    Entry top()
    {
        settleFront();
        const Bucket& bucket = mBuckets[mFront];
        return entryOf(bucket.lateIsFirst() ? bucket.late.front() : bucket.keys.back());
    }

    /// Takes the cheapest entry out; not empty.
    Entry pop()
    {
        settleFront();
        Bucket& bucket = mBuckets[mFront];
        std::vector<std::uint64_t>& source = bucket.lateIsFirst() ? bucket.late : bucket.keys;
        if (&source == &bucket.late)
            std::pop_heap(source.begin(), source.end(), std::greater<>());
        const Entry entry = entryOf(source.back());
        source.pop_back();
        if (bucket.isEmpty()) {
            bucket.isSorted = false;
            mOccupied[mFront / 64] &= ~(std::uint64_t{1} << (mFront % 64));
        }
        return entry;
    }

    /// A vertex that will probably come up `ahead` pops from now; any vertex of an entry will do for that. Call after pop().
    bool expected(std::size_t ahead, std::uint32_t& vertex) const
    {
        if (mFront == kBucketCount || !mBuckets[mFront].isSorted || mBuckets[mFront].keys.size() <= ahead)
            return false;
        vertex = static_cast<std::uint32_t>(mBuckets[mFront].keys[mBuckets[mFront].keys.size() - 1 - ahead]);
        return true;
    }

private:
    static constexpr int kBucketShift = 32 + 20; // exponent and three mantissa bits: eight buckets an octave
    static constexpr std::size_t kBucketCount = 2048;

    struct Bucket {
        std::vector<std::uint64_t> keys; ///< descending when sorted
        std::vector<std::uint64_t> late; ///< a heap, used only when sorted
        bool isSorted = false;

        bool isEmpty() const { return keys.empty() && late.empty(); }
        bool lateIsFirst() const { return !late.empty() && (keys.empty() || late.front() < keys.back()); }
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

    /// Finds the lowest occupied bucket and puts it in order. False when there is none.
    bool settleFront()
    {
        while (mFront < kBucketCount && mBuckets[mFront].isEmpty())
            mFront = nextOccupied(mFront + 1);
        if (mFront == kBucketCount)
            return false;
        Bucket& bucket = mBuckets[mFront];
        if (!bucket.isSorted) {
            std::sort(bucket.keys.begin(), bucket.keys.end(), std::greater<>());
            bucket.isSorted = true;
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
