using System.Collections;
using Engraver.Core;

namespace Engraver.App.Binding;

/// <summary>A list whose rows are created on access, so that a list of a million rows costs nothing until it is scrolled. Read-only; implements
/// <see cref="IList"/> because list controls require it.</summary>
/// <typeparam name="T">A row; two rows of the same index must be equal.</typeparam>
public sealed class RowList<T>(int count, Func<int, T> make, Func<T, int> placeOf) : IndexedList<T>, IList
    where T : class
{
    public override int Count => count;

    bool IList.IsFixedSize => true;

    bool IList.IsReadOnly => true;

    bool ICollection.IsSynchronized => false;

    object ICollection.SyncRoot => this;

    object? IList.this[int index]
    {
        get => this[index];
        set => throw new NotSupportedException();
    }

    int IList.Add(object? value) => throw new NotSupportedException();

    void IList.Clear() => throw new NotSupportedException();

    bool IList.Contains(object? value) => ((IList)this).IndexOf(value) >= 0;

    int IList.IndexOf(object? value) => value is T row && placeOf(row) is var place && (uint)place < (uint)count && make(place).Equals(row) ? place : -1;

    void IList.Insert(int index, object? value) => throw new NotSupportedException();

    void IList.Remove(object? value) => throw new NotSupportedException();

    void IList.RemoveAt(int index) => throw new NotSupportedException();

    void ICollection.CopyTo(Array array, int index)
    {
        for (var at = 0; at < count; at++) array.SetValue(make(at), index + at);
    }

    protected override T ItemAt(int index) => make(index);
}
