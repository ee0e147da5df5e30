namespace Engraver.Core.EntityTables;

/// <summary>The table as CSV: header <c>s0..s15</c>, one line per row, comma and invariant point, LF.</summary>
public static class EntityTableCsv
{
    public static void Write(EntityTable table, TextWriter output)
    {
        output.Write(string.Join(',', Enumerable.Range(0, EntitySlot.Count).Select(slot => $"s{slot}")));
        output.Write('\n');
        for (var row = 0; row < table.Count; row++)
        {
            WriteCells(table[row], output);
            output.Write('\n');
        }
    }

    /// <summary>The 16 cells with commas between them; JSON has the same cells.</summary>
    internal static void WriteCells(EntityRow row, TextWriter output)
    {
        for (var slot = 0; slot < EntitySlot.Count; slot++)
        {
            if (slot > 0) output.Write(',');
            output.Write(EntityNumber.Format(row[slot]));
        }
    }
}
