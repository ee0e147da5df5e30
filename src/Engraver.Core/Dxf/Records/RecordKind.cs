namespace Engraver.Core.Dxf.Records;

/// <summary>How the reader handles a record, determined by its type name.</summary>
internal enum RecordKind : byte
{
    /// <summary>An unknown type: refused and counted.</summary>
    Unknown,
    Line,
    Arc,
    Circle,
    Ellipse,
    Spline,
    LwPolyline,
    Polyline,
    Vertex,
    Insert,
    Attribute,
    SequenceEnd,
    Point,
    Text,

    /// <summary>Drawn as information, not cut: images, tables, solids in space.</summary>
    Construction,
    Hatch,
    MultiLine,
    Leader,
    Helix,

    /// <summary>SOLID, TRACE, 3DFACE.</summary>
    Face,

    /// <summary>A dimension, which is drawn by its own block.</summary>
    Dimension,

    /// <summary>ATTDEF: a template, except for a constant one, which is a text of every copy of its block.</summary>
    AttributeDefinition,
    LayerEntry,
    LinetypeEntry,
    StyleEntry,
    Block,
    BlockEnd,
    Section,
    SectionEnd,
    FileEnd,
}
