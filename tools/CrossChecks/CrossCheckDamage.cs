namespace Engraver.Tools.CrossChecks;

/// <summary>Finds places of a file where a record of the drawing may have been lost, which the figures cannot show if both readings skip it. Its rules are
/// independent of the reader's.</summary>
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

    /// <summary>A phrase with the number of such places and the first of them; null for none.</summary>
    public static string? In(CrossCheckFile file)
    {
        var damage = new CrossCheckDamage(file);
        foreach (var tag in file.TagsAndDamage)
        {
            if (!damage.Take(tag)) break;
        }

        return damage._count switch
        {
            0 => null,
            1 => Wording.Get("CrossCheckDamage.OnePlace", damage._first),
            _ => Wording.Get("CrossCheckDamage.SeveralPlaces", damage._count, damage._first),
        };
    }

    private bool Take(CrossCheckTag tag)
    {
        if (file.HasZero(tag)) Add(tag, place => Wording.Get("CrossCheckDamage.ZeroBytes", place));
        if (tag.Code == CrossCheckFile.Damaged) TakeDamage(tag);
        else if (tag.Code == 0) return TakeRecord(tag);
        else TakeGroup(tag);
        return true;
    }

    private void TakeDamage(CrossCheckTag tag)
    {
        if (IsOfDrawing) Add(tag, place => Wording.Get("CrossCheckDamage.NoGroupCode", place));
    }

    private bool IsOfDrawing => _section is "" or "ENTITIES" or "BLOCKS" or "TABLES";

    private bool TakeRecord(CrossCheckTag tag)
    {
        if (_word && IsOfDrawing && (_layers > 1 || (_names > 1 && _type is ("LAYER" or "BLOCK")))) Add(tag, place => Wording.Get("CrossCheckDamage.TwoRecordsInOne", place));
        (_layers, _names, _word, _variables, _named) = (0, 0, false, false, false);
        _type = file.Text(tag).ToUpperInvariant();
        if (_type == "BLOCK") _inBlock = true;
        else if (_type == "ENDBLK") _inBlock = false;
        if (_type is "ENDSEC" or "SECTION") _section = "";
        if (_type.Length == 0) Add(tag, place => Wording.Get("CrossCheckDamage.NamelessRecord", place));
        if (IsMisplaced()) Add(tag, place => Wording.Get("CrossCheckDamage.MisplacedRecord", place, _type));
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
        if (!_variables && IsForeign(tag.Code)) Add(tag, place => Wording.Get("CrossCheckDamage.ForeignGroup", place, tag.Code, _type));
    }

    private void Enter(string name)
    {
        (_named, _inBlock) = (true, false);
        _section = name is "HEADER" or "CLASSES" or "TABLES" or "BLOCKS" or "ENTITIES" or "OBJECTS" or "THUMBNAILIMAGE" or "ACDSDATA" ? name : Unknown;
    }

    /// <summary>True for a group code that cannot follow a record of the file's structure (SECTION, ENDSEC, TABLE ...): coordinates, names, and in the head
    /// of a table the codes of its entries.</summary>
    private bool IsForeign(int code) => _type switch
    {
        "SECTION" => _section is "TABLES" or "BLOCKS" or "ENTITIES",
        "ENDSEC" or "ENDTAB" => true,
        "ENDBLK" or "SEQEND" => code is 1 or 2 or 3 or 7 or (>= 10 and < 39) or 40 or 66 or 70,
        "TABLE" => code is 3 or 6 or 8 or 62 or (>= 10 and < 60),
        _ => false,
    };

    /// <summary>Counts a place; only the first is described.</summary>
    private void Add(CrossCheckTag tag, Func<string, string> name)
    {
        if (_count++ == 0) _first = name(file.Place(tag));
    }
}
