namespace Engraver.Fonts.OpenType.Outlines;

/// <summary>Outlines of the table "CFF ": Type 2 charstrings, in one font or, for large ones, in several parts (Adobe TN 5176).</summary>
internal sealed class CffOutlines : IGlyphOutlines
{
    /// <summary>The selection of a glyph's part is one byte.</summary>
    private const int MaxParts = 256;

    private readonly FontBytes _table;
    private readonly CffIndex _charstrings;
    private readonly CffIndex _globalSubroutines;
    private readonly CffIndex[] _localSubroutines;
    private readonly CffFontSelection? _selection;

    public CffOutlines(FontFile file)
    {
        _table = file.Table("CFF ");
        int offset = _table.Byte(2);
        CffIndex.Read(_table, ref offset);
        var top = new CffDict(CffIndex.Read(_table, ref offset)[0]);
        CffIndex.Read(_table, ref offset);
        _globalSubroutines = CffIndex.Read(_table, ref offset);
        _charstrings = IndexAt(top.Integer(CffDict.CharStrings));
        if (!top.Has(CffDict.FontArray))
        {
            _localSubroutines = [LocalSubroutines(top)];
            return;
        }
        var fonts = IndexAt(top.Integer(CffDict.FontArray));
        if (fonts.Count > MaxParts)
            throw new BrokenFontException("The font has too many parts.");
        _localSubroutines = [.. Enumerable.Range(0, fonts.Count).Select(i => LocalSubroutines(new CffDict(fonts[i])))];
        _selection = new CffFontSelection(_table.Slice(top.Integer(CffDict.FontSelect)));
    }

    public void Draw(int glyph, IOutlineSink sink)
    {
        if (glyph < 0 || glyph >= _charstrings.Count)
            return;
        var font = _selection?.FontOf(glyph) ?? 0;
        var locals = font < _localSubroutines.Length ? _localSubroutines[font] : CffIndex.Empty;
        new CharstringInterpreter(sink, _globalSubroutines, locals).Run(_charstrings[glyph]);
    }

    public int? StatedLeft(int glyph) => null;

    /// <summary>The private dictionary says where they are, counted from itself.</summary>
    private CffIndex LocalSubroutines(CffDict font)
    {
        if (!font.Has(CffDict.Private))
            return CffIndex.Empty;
        int length = font.Integer(CffDict.Private), start = font.Integer(CffDict.Private, 1);
        var details = new CffDict(_table.Slice(start, length));
        return details.Has(CffDict.Subroutines) ? IndexAt(start + details.Integer(CffDict.Subroutines)) : CffIndex.Empty;
    }

    private CffIndex IndexAt(int offset) => CffIndex.Read(_table, ref offset);
}
