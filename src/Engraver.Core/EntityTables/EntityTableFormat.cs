namespace Engraver.Core.EntityTables;

/// <summary>The formats in which a table is written, by their names.</summary>
public static class EntityTableFormat
{
    public static IReadOnlyList<string> Names { get; } = ["text", "csv", "json"];

    /// <param name="format">One of <see cref="Names"/>.</param>
    public static void Write(string format, EntityTable table, TextWriter output)
    {
        switch (format)
        {
            case "text": EntityTableText.Write(table, output); break;
            case "csv": EntityTableCsv.Write(table, output); break;
            case "json": EntityTableJson.Write(table, output); break;
            default: throw new ArgumentOutOfRangeException(nameof(format));
        }
    }
}
