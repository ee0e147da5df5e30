using System.Globalization;

namespace Engraver.Core.EntityTables;

/// <summary>The table as readable text: columns s0 to s15 under their headings, numbers right-aligned, each column as wide as its longest number.</summary>
public static class EntityTableText
{
    private const string Gap = "  ";

    public static void Write(EntityTable table, TextWriter output)
    {
        var widths = Widths(table);
        WriteLine(output, widths, slot => $"s{slot}");
        for (var row = 0; row < table.Count; row++)
        {
            var index = row;
            WriteLine(output, widths, slot => EntityNumber.Format(table[index][slot]));
        }
    }

    private static int[] Widths(EntityTable table)
    {
        var widths = Enumerable.Range(0, EntitySlot.Count).Select(slot => slot < 10 ? 2 : 3).ToArray();
        for (var row = 0; row < table.Count; row++)
        {
            var cells = table[row];
            for (var slot = 0; slot < EntitySlot.Count; slot++) widths[slot] = Math.Max(widths[slot], EntityNumber.Format(cells[slot]).Length);
        }

        return widths;
    }

    private static void WriteLine(TextWriter output, int[] widths, Func<int, string> cell)
    {
        for (var slot = 0; slot < widths.Length; slot++)
        {
            if (slot > 0) output.Write(Gap);
            output.Write(cell(slot).PadLeft(widths[slot]));
        }

        output.Write('\n');
    }
}

/// <summary>Text of a cell: whole numbers without a decimal point, others so that they read back to the same double; never "-0".</summary>
internal static class EntityNumber
{
    public static string Format(double value) => value == 0.0 ? "0" : value.ToString("R", CultureInfo.InvariantCulture);
}
