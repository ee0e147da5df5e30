using System.Globalization;
using Engraver.Core.EntityTables;

namespace Engraver.App.Tables;

/// <summary>A row of the fixed-slot table with its 16 formatted values. Created on access.</summary>
public sealed class TableRow(EntityTable table, int index) : IEquatable<TableRow>
{
    /// <summary>Larger whole numbers are written with an exponent.</summary>
    private const double LargestWhole = 1e15;

    public int Index => index;

    /// <summary>The drawing entity the row came from.</summary>
    public int EntityIndex => table.EntityIndexOf(index);

    public string Figure(int slot)
    {
        var value = table[index][slot];
        return value == Math.Floor(value) && Math.Abs(value) < LargestWhole ? value.ToString("0", CultureInfo.InvariantCulture) : value.ToString("0.####", CultureInfo.InvariantCulture);
    }

    public bool Equals(TableRow? other) => other is not null && other.Index == Index;

    public override bool Equals(object? obj) => Equals(obj as TableRow);

    public override int GetHashCode() => index;

    /// <summary>For a screen reader: the number of the row and its values.</summary>
    public override string ToString() => string.Create(CultureInfo.InvariantCulture, $"{index + 1}: {string.Join(' ', Enumerable.Range(0, EntitySlot.Count).Select(Figure))}");
}
