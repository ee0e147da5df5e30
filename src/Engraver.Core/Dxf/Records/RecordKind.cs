namespace Engraver.Core.Dxf.Records;

/// <summary>What the reader does with a record, decided by its type name.</summary>
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

    /// <summary>Drawn for people who read the drawing, not cut: dimensions, hatches, images, solids.</summary>
    Construction,
    Hatch,
    MultiLine,
    Leader,
    Helix,

    /// <summary>SOLID, TRACE, 3DFACE.</summary>
    Face,

    /// <summary>ATTDEF: a template, but for a constant one, which is a text of every copy of its block.</summary>
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
