using System.Collections;

namespace Engraver.App.Canvas.Marks;

/// <summary>Marks that are made when they are asked for: a mark takes three times the memory of its place, and there may be millions.</summary>
/// <param name="count">How many there are.</param>
/// <param name="at">The mark of an index.</param>
internal sealed class MarkList(int count, Func<int, SceneMark> at) : IReadOnlyList<SceneMark>
{
    public int Count => count;

    public SceneMark this[int index] => (uint)index < (uint)count ? at(index) : throw new ArgumentOutOfRangeException(nameof(index));

    public IEnumerator<SceneMark> GetEnumerator()
    {
        for (var i = 0; i < count; i++) yield return at(i);
    }

    IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();
}
