namespace Engraver.Core.Dxf.Records;

/// <summary>The text styles of the STYLE table: their fonts.</summary>
internal sealed class StyleTable
{
    private readonly Dictionary<string, string> _fonts = new(StringComparer.OrdinalIgnoreCase);

    /// <summary>Takes a STYLE entry: 2 name, 3 font file. Entries without a name are shape files, not text styles.</summary>
    public void Define(EntityRecord entry)
    {
        if (entry.TextOf(2) is { Length: > 0 } name) _fonts.TryAdd(name, entry.TextOf(3));
    }

    /// <summary>Font file of a style; "" when it is not known.</summary>
    public string FontOf(string style) => _fonts.GetValueOrDefault(style, "");
}
