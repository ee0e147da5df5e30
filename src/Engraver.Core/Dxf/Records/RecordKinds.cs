using System.Collections.Frozen;
using Engraver.Core.Drawings;

namespace Engraver.Core.Dxf.Records;

/// <summary>The table of type names. BODY and REGION are deliberately left unknown: they may contain curves that are then lost, and this is reported to the
/// operator.</summary>
internal static class RecordKinds
{
    private static readonly string[] Construction =
    [
        "MPOLYGON", "MLEADER", "MULTILEADER", "3DSOLID", "MESH", "SURFACE", "EXTRUDEDSURFACE", "LOFTEDSURFACE", "REVOLVEDSURFACE", "SWEPTSURFACE", "PLANESURFACE", "NURBSURFACE",
        "VIEWPORT", "RAY", "XLINE", "ACAD_TABLE", "TABLE", "IMAGE", "WIPEOUT", "TOLERANCE", "SHAPE", "LIGHT", "OLEFRAME", "OLE2FRAME",
        "ACAD_PROXY_ENTITY", "PDFUNDERLAY", "DWFUNDERLAY", "DGNUNDERLAY", "POINTCLOUD", "POSITIONMARKER", "CAMERA",
    ];

    private static readonly FrozenSet<string> TableTypes = FrozenSet.Create("TABLE", "ENDTAB", "VPORT", "VIEW", "UCS", "APPID", "DIMSTYLE", "BLOCK_RECORD");

    private static readonly FrozenDictionary<string, RecordKind> Known = Build();

    /// <summary>The known types of ENTITIES and BLOCKS, by how they are handled; docs/diagnostics.md lists them.</summary>
    public static IEnumerable<(string Fate, IEnumerable<string> Types)> Handling() =>
    [
        (Wording.Get("RecordKinds.Cut"), TypesOf(kind => kind is >= RecordKind.Line and <= RecordKind.Polyline or RecordKind.Insert)),
        (Wording.Get("RecordKinds.CutIfNamed"), TypesOf(IsOutline)),
        (Wording.Get("RecordKinds.Text"), TypesOf(kind => kind is RecordKind.Text or RecordKind.Attribute)),
        (Wording.Get("RecordKinds.Construction"), TypesOf(kind => kind is RecordKind.Construction or RecordKind.Point or RecordKind.AttributeDefinition)),
    ];

    public static RecordKind Find(string type) => Known.GetValueOrDefault(type, RecordKind.Unknown);

    /// <summary>True when the record's numbers matter. Of the others only visibility and space are read, so that damaged numbers in a dimension have no
    /// effect.</summary>
    public static bool HasNumbers(RecordKind kind) => kind is not (RecordKind.Unknown or RecordKind.Construction or RecordKind.Text or RecordKind.Point
        or RecordKind.Attribute or RecordKind.AttributeDefinition or RecordKind.SequenceEnd or RecordKind.StyleEntry or RecordKind.LinetypeEntry) && !IsOutline(kind);

    /// <summary>True for known records of ENTITIES or of a block.</summary>
    public static bool IsEntity(RecordKind kind) => kind is (>= RecordKind.Line and <= RecordKind.Polyline) or RecordKind.Insert or RecordKind.Text or RecordKind.Point or RecordKind.Construction or RecordKind.AttributeDefinition
        || IsOutline(kind);

    /// <summary>True for the records whose linetype is read: curves, inserts, points and outlines.</summary>
    public static bool HasLinetype(RecordKind kind) => kind is (>= RecordKind.Line and <= RecordKind.Polyline) or RecordKind.Insert or RecordKind.Point || IsOutline(kind);

    /// <summary>True for the records whose lineweight is read: as for linetypes, and texts and layers.</summary>
    public static bool HasLineweight(RecordKind kind) => HasLinetype(kind) || kind is RecordKind.Text or RecordKind.Attribute or RecordKind.AttributeDefinition or RecordKind.LayerEntry;

    /// <summary>True for every record that makes a section part of a drawing: entities and their parts, blocks, layers.</summary>
    public static bool IsOfDrawing(RecordKind kind) => IsEntity(kind) || kind is RecordKind.Vertex or RecordKind.Attribute or RecordKind.SequenceEnd or RecordKind.LayerEntry or RecordKind.Block or RecordKind.BlockEnd;

    /// <summary>True for the other types of record in TABLES, which are not read.</summary>
    public static bool IsOfTables(string type) => TableTypes.Contains(type);

    /// <summary>For a record without content (a frame such as ENDSEC): false for a group code that it cannot have, which then belongs to another record whose
    /// beginning is damaged. True for every other record.</summary>
    public static bool MayHold(RecordKind kind, string type, int code) => kind switch
    {
        RecordKind.Section or RecordKind.SectionEnd => false,
        RecordKind.BlockEnd or RecordKind.SequenceEnd => code is 5 or 6 or 8 or 39 or 48 or 60 or 62 or 67 or 92 or 100 or 102 or 160 or 284 or (>= 310 and < 450) or >= 1000,
        _ when type == "TABLE" => code is 2 or 5 or 70 or 71 or 100 or 102 or (>= 330 and < 370) or >= 1000,
        _ => type != "ENDTAB",
    };

    /// <summary>True for construction that the operator may choose to cut (<see cref="CutChoice"/>).</summary>
    public static bool IsOutline(RecordKind kind) => kind is RecordKind.Hatch or RecordKind.MultiLine or RecordKind.Leader or RecordKind.Helix or RecordKind.Face or RecordKind.Dimension;

    /// <summary>The choice that an outline belongs to; None for every other kind.</summary>
    public static CutChoice ChoiceOf(RecordKind kind) => kind switch
    {
        RecordKind.Hatch => CutChoice.Hatch,
        RecordKind.MultiLine => CutChoice.MLine,
        RecordKind.Leader => CutChoice.Leader,
        RecordKind.Helix => CutChoice.Helix,
        RecordKind.Face => CutChoice.Solid,
        RecordKind.Dimension => CutChoice.Dimension,
        _ => CutChoice.None,
    };

    /// <summary>True when the record is kept pair by pair, because its codes repeat and their meaning depends on the order, or because it has text.</summary>
    public static bool IsCollected(RecordKind kind, CutChoice cut) => kind is RecordKind.Text or RecordKind.Attribute or RecordKind.AttributeDefinition or RecordKind.StyleEntry || (ChoiceOf(kind) & cut) != 0;

    private static IEnumerable<string> TypesOf(Func<RecordKind, bool> wanted) => Known.Where(pair => wanted(pair.Value)).Select(pair => pair.Key).Order(StringComparer.Ordinal);

    private static FrozenDictionary<string, RecordKind> Build()
    {
        var kinds = new Dictionary<string, RecordKind>(StringComparer.OrdinalIgnoreCase)
        {
            ["LINE"] = RecordKind.Line,
            ["ARC"] = RecordKind.Arc,
            ["CIRCLE"] = RecordKind.Circle,
            ["ELLIPSE"] = RecordKind.Ellipse,
            ["SPLINE"] = RecordKind.Spline,
            ["LWPOLYLINE"] = RecordKind.LwPolyline,
            ["POLYLINE"] = RecordKind.Polyline,
            ["VERTEX"] = RecordKind.Vertex,
            ["INSERT"] = RecordKind.Insert,
            ["ATTRIB"] = RecordKind.Attribute,
            ["SEQEND"] = RecordKind.SequenceEnd,
            ["POINT"] = RecordKind.Point,
            ["TEXT"] = RecordKind.Text,
            ["MTEXT"] = RecordKind.Text,
            ["ATTDEF"] = RecordKind.AttributeDefinition,
            ["RTEXT"] = RecordKind.Text,
            ["ARCALIGNEDTEXT"] = RecordKind.Text,
            ["HATCH"] = RecordKind.Hatch,
            ["MLINE"] = RecordKind.MultiLine,
            ["LEADER"] = RecordKind.Leader,
            ["HELIX"] = RecordKind.Helix,
            ["SOLID"] = RecordKind.Face,
            ["TRACE"] = RecordKind.Face,
            ["3DFACE"] = RecordKind.Face,
            ["DIMENSION"] = RecordKind.Dimension,
            ["ARC_DIMENSION"] = RecordKind.Dimension,
            ["LARGE_RADIAL_DIMENSION"] = RecordKind.Dimension,
            ["LAYER"] = RecordKind.LayerEntry,
            ["STYLE"] = RecordKind.StyleEntry,
            ["LTYPE"] = RecordKind.LinetypeEntry,
            ["BLOCK"] = RecordKind.Block,
            ["ENDBLK"] = RecordKind.BlockEnd,
            ["SECTION"] = RecordKind.Section,
            ["ENDSEC"] = RecordKind.SectionEnd,
            ["EOF"] = RecordKind.FileEnd,
        };
        foreach (var type in Construction) kinds.Add(type, RecordKind.Construction);
        return kinds.ToFrozenDictionary(StringComparer.OrdinalIgnoreCase);
    }
}
