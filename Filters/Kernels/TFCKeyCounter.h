// SPDX-FileCopyrightText: the Transfer Function Combinations developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief How often each 64-bit key occurs, for histograms of which few cells hold something.
 *
 * A hash table with open addressing and multiplicative hashing (Knuth, The Art of Computer
 * Programming 3, section 6.4), at most half full. Runs of equal keys, the normal case in a volume,
 * are counted before the table is touched. Memory: 16 bytes per slot, two to four slots per key.
 * Not thread-safe: one per thread; sorted lists of several counters merge to the same result in any
 * order.
 */

#ifndef TFCKeyCounter_h
#define TFCKeyCounter_h

#include "TFCGradient.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace tfc
{
struct KeyCount
{
  std::uint64_t Key = 0;
  std::int64_t Count = 0;
};

class KeyCounter
{
public:
  /// A key that is not counted.
  static constexpr std::uint64_t NoKey = ~std::uint64_t{ 0 };

  void Add(const std::uint64_t* keys, Index n)
  {
    for (Index i = 0; i < n;)
    {
      const std::uint64_t key = keys[i];
      Index end = i + 1;
      while (end < n && keys[end] == key)
      {
        ++end;
      }
      if (key != NoKey)
      {
        this->Add(key, end - i);
      }
      i = end;
    }
  }

  void Add(std::uint64_t key, std::int64_t count)
  {
    KeyCount& slot = this->Find(key);
    if (slot.Count == 0)
    {
      slot.Key = key;
      ++this->Used;
    }
    slot.Count += count;
    if (this->Used > this->Slots.size() / 2)
    {
      this->Grow();
    }
  }

  void AppendTo(std::vector<KeyCount>& list) const
  {
    list.reserve(list.size() + this->Used);
    for (const KeyCount& slot : this->Slots)
    {
      if (slot.Count != 0)
      {
        list.push_back(slot);
      }
    }
  }

private:
  KeyCount& Find(std::uint64_t key)
  {
    const std::size_t mask = this->Slots.size() - 1;
    std::size_t at = (key * 0x9E3779B97F4A7C15u) >> this->Shift;
    while (this->Slots[at].Count != 0 && this->Slots[at].Key != key)
    {
      at = (at + 1) & mask;
    }
    return this->Slots[at];
  }

  void Grow()
  {
    std::vector<KeyCount> old(2 * this->Slots.size());
    old.swap(this->Slots);
    --this->Shift;
    for (const KeyCount& slot : old)
    {
      if (slot.Count != 0)
      {
        this->Find(slot.Key) = slot;
      }
    }
  }

  static constexpr int FirstBits = 12;
  std::vector<KeyCount> Slots = std::vector<KeyCount>(std::size_t{ 1 } << FirstBits);
  std::size_t Used = 0;
  int Shift = 64 - FirstBits;
};

/**
 * Sort by key and add up equal keys. Cost: n log n.
 */
inline void MergeKeys(std::vector<KeyCount>& list)
{
  std::sort(list.begin(), list.end(),
    [](const KeyCount& a, const KeyCount& b) { return a.Key < b.Key; });
  std::size_t last = 0;
  for (std::size_t i = 1; i < list.size(); ++i)
  {
    if (list[i].Key == list[last].Key)
    {
      list[last].Count += list[i].Count;
    }
    else
    {
      list[++last] = list[i];
    }
  }
  list.resize(std::min(list.size(), last + 1));
}
}

#endif
