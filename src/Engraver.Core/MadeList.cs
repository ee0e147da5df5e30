using System.Collections;

namespace Engraver.Core;

/// <summary>A list whose items are made when they are asked for, anew each time: of a million that were kept the memory would be many times that of what they are made from.</summary>
/// <param name="count">How many there are.</param>
/// <param name="at">Makes the item of an index; what it reads does not change any more.</param>
public sealed class MadeList<T>(int count, Func<int, T> at) : IReadOnlyList<T>
{
    public int Count => count;

    public T this[int index] => (uint)index < (uint)count ? at(index) : throw new ArgumentOutOfRangeException(nameof(index));

    public IEnumerator<T> GetEnumerator()
    {
        for (var i = 0; i < count; i++) yield return at(i);
    }

    IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();
}
