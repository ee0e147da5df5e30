using System.Globalization;

namespace Engraver.Tools.CrossChecks;

/// <summary>Says where a record of the drawing may have been lost: the figures of a reading cannot show what both readings pass over. By rules of its own, not the reader's.</summary>
internal sealed class CrossCheckDamage(CrossCheckFile file)
{
    private const string Unknown = "?";

    private static readonly HashSet<string> Drawn = new(StringComparer.Ordinal)
    {
        "LINE", "ARC", "CIRCLE", "ELLIPSE", "SPLINE", "LWPOLYLINE", "POLYLINE", "VERTEX", "SEQEND", "INSERT", "ATTRIB", "ATTDEF", "TEXT", "MTEXT", "POINT", "HATCH", "SOLID", "TRACE", "3DFACE", "LEADER",
        "MLINE", "HELIX", "DIMENSION", "VIEWPORT", "IMAGE", "BLOCK", "ENDBLK", "LAYER", "TABLE",
    };

    private static readonly HashSet<string> Tables = new(StringComparer.Ordinal) { "TABLE", "ENDTAB", "LAYER", "LTYPE", "STYLE", "VIEW", "VPORT", "UCS", "APPID", "DIMSTYLE", "BLOCK_RECORD" };

    private string _section = "";
    private string _type = "";
    private bool _inBlock;
    private bool _variables;
    private bool _named;
    private int _layers;
    private int _names;
    private bool _word;
    private int _count;
    private string _first = "";

    /// <summary>How many such places there are and the first of them; null when there is none.</summary>
    public static string? In(CrossCheckFile file)
    {
        var damage = new CrossCheckDamage(file);
        foreach (var tag in file.TagsAndDamage)
        {
            if (!damage.Take(tag)) break;
        }

        return damage._count == 0 ? null : string.Create(CultureInfo.InvariantCulture, $"{damage._count} {(damage._count == 1 ? "place" : "places")} where a record may be lost, the first {damage._first}");
    }

    private bool Take(CrossCheckTag tag)
    {
        if (file.HasZero(tag)) Add(tag, "zero bytes");
        if (tag.Code == CrossCheckFile.Damaged) TakeDamage(tag);
        else if (tag.Code == 0) return TakeRecord(tag);
        else TakeGroup(tag);
        return true;
    }

    private void TakeDamage(CrossCheckTag tag)
    {
        if (IsOfDrawing) Add(tag, "no group code");
    }

    private bool IsOfDrawing => _section is "" or "ENTITIES" or "BLOCKS" or "TABLES";

    private bool TakeRecord(CrossCheckTag tag)
    {
        if (_word && IsOfDrawing && (_layers > 1 || (_names > 1 && _type is ("LAYER" or "BLOCK")))) Add(tag, "two records in one");
        (_layers, _names, _word, _variables, _named) = (0, 0, false, false, false);
        _type = file.Text(tag).ToUpperInvariant();
        if (_type == "BLOCK") _inBlock = true;
        else if (_type == "ENDBLK") _inBlock = false;
        if (_type is "ENDSEC" or "SECTION") _section = "";
        if (_type.Length == 0) Add(tag, "a record without a name");
        if (IsMisplaced()) Add(tag, $"{_type} where it does not belong");
        return _type != "EOF";
    }

    private bool IsMisplaced() => _section switch
    {
        "TABLES" => !Tables.Contains(_type),
        "BLOCKS" => !_inBlock && Drawn.Contains(_type) && _type != "ENDBLK",
        Unknown or "HEADER" => Drawn.Contains(_type),
        _ => false,
    };

    private void TakeGroup(CrossCheckTag tag)
    {
        if (_type == "SECTION" && !_named && tag.Code == 2)
        {
            Enter(file.Text(tag).ToUpperInvariant());
            return;
        }

        if (tag.Code == 8) _layers++;
        if (tag.Code == 2) _names++;
        if (tag.Code is > 0 and < 10) _word |= Drawn.Contains(file.Text(tag)) || Tables.Contains(file.Text(tag));
        _variables |= tag.Code == 9;
        if (!_variables && IsForeign(tag.Code)) Add(tag, $"group {tag.Code} behind {_type}");
    }

    private void Enter(string name)
    {
        (_named, _inBlock) = (true, false);
        _section = name is "HEADER" or "CLASSES" or "TABLES" or "BLOCKS" or "ENTITIES" or "OBJECTS" or "THUMBNAILIMAGE" or "ACDSDATA" ? name : Unknown;
    }

    /// <summary>What the frame of a drawing does not have: coordinates, names, and in the head of a table what its entries have.</summary>
    private bool IsForeign(int code) => _type switch
    {
        "SECTION" => _section is "TABLES" or "BLOCKS" or "ENTITIES",
        "ENDSEC" or "ENDTAB" => true,
        "ENDBLK" or "SEQEND" => code is 1 or 2 or 3 or 7 or (>= 10 and < 39) or 40 or 66 or 70,
        "TABLE" => code is 3 or 6 or 8 or 62 or (>= 10 and < 60),
        _ => false,
    };

    private void Add(CrossCheckTag tag, string what)
    {
        if (_count++ == 0) _first = $"at {file.Place(tag)}: {what}";
    }
}
