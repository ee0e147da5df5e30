namespace Engraver.Core;

/// <summary>A list of a fixed number of items, each created by a function of its index.</summary>
/// <param name="count">Number of items.</param>
/// <param name="at">Creates the item of an index; the data that it reads no longer changes.</param>
public sealed class ComputedList<T>(int count, Func<int, T> at) : IndexedList<T>
{
    public override int Count => count;

    protected override T ItemAt(int index) => at(index);
}
