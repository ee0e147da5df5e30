using System.Collections;

namespace Engraver.Core;

/// <summary>A list whose items are created again on each access: storing a million of them would need many times the memory of their source.</summary>
/// <param name="count">Number of items.</param>
/// <param name="at">Creates the item of an index; the data that it reads no longer changes.</param>
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
