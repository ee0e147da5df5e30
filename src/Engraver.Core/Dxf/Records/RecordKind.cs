namespace Engraver.Core.Dxf.Records;

/// <summary>What the reader does with a record, decided by its type name.</summary>
internal enum RecordKind : byte
{
    /// <summary>A type we do not know: refused, counted.</summary>
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

    /// <summary>Drawn for the reader of the drawing, not for the tool: dimensions, hatches, images, solids.</summary>
    Construction,
    Hatch,
    MultiLine,
    Leader,
    Helix,

    /// <summary>SOLID, TRACE, 3DFACE.</summary>
    Face,
    LayerEntry,
    StyleEntry,
    Block,
    BlockEnd,
    Section,
    SectionEnd,
    FileEnd,
}
