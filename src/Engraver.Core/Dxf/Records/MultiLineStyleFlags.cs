namespace Engraver.Core.Dxf.Records;

/// <summary>Group 70 of MLINESTYLE (DXF reference).</summary>
[Flags]
internal enum MultiLineStyleFlags
{
    None = 0,

    /// <summary>A line across at every inner vertex.</summary>
    Joints = 2,
    StartLine = 16,

    /// <summary>Arcs between pairs of inner elements.</summary>
    StartInnerArcs = 32,

    /// <summary>A half circle between the outermost elements.</summary>
    StartOuterArc = 64,
    EndLine = 256,
    EndInnerArcs = 512,
    EndOuterArc = 1024,
}
