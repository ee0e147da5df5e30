using System.Collections;

namespace Engraver.Core;

/// <summary>A read-only list whose items are created from their index on each access: storing a million of them would need many times the memory of their
/// source.</summary>
public abstract class IndexedList<T> : IReadOnlyList<T>
{
    public abstract int Count { get; }

    public T this[int index] => (uint)index < (uint)Count ? ItemAt(index) : throw new ArgumentOutOfRangeException(nameof(index));

    public virtual IEnumerator<T> GetEnumerator()
    {
        for (int i = 0, count = Count; i < count; i++) yield return ItemAt(i);
    }

    IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();

    /// <param name="index">From 0 to <see cref="Count"/> - 1.</param>
    protected abstract T ItemAt(int index);
}
