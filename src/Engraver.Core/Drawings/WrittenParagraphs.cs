using Engraver.Core.Geometry;

namespace Engraver.Core.Drawings;

/// <summary>The values that only an MTEXT has, as its record states them. DXF reference, "MTEXT".</summary>
public sealed record WrittenParagraphs
{
    /// <summary>Group 71: 1 top left, 2 top centre ... 9 bottom right.</summary>
    public int Attachment { get; init; } = 1;

    /// <summary>Group 72: 1 left to right, 3 top to bottom, 5 as the style.</summary>
    public int FlowDirection { get; init; } = 1;

    /// <summary>Group 41: width at which the text wraps; 0 when it does not wrap.</summary>
    public double ReferenceWidth { get; init; }

    /// <summary>Group 46, or extended data: height of the frame; 0 where it is not stated.</summary>
    public double DefinedHeight { get; init; }

    /// <summary>Group 73: 1 at least (taller letters increase the distance), 2 exactly.</summary>
    public int LineSpacingStyle { get; init; } = 1;

    /// <summary>Group 44: line distance as a multiple of 5/3 of the height.</summary>
    public double LineSpacingFactor { get; init; } = 1.0;

    /// <summary>Groups 11, 21, 31: direction of the lines in the system of the block; null where the rotation (50) is stated after it, or it is not
    /// stated.</summary>
    public Vector3D? XAxis { get; init; }

    /// <summary>Null for a text of one column.</summary>
    public TextColumns? Columns { get; init; }
}
