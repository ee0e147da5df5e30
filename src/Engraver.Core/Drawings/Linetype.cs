namespace Engraver.Core.Drawings;

/// <summary>A row of the LTYPE table. DXF reference, "LTYPE".</summary>
/// <param name="Name">Group 2; entities and layers refer to it in any case.</param>
public sealed record Linetype(string Name)
{
    /// <summary>Index of the linetype of the layer in every list of linetypes.</summary>
    public const int ByLayer = 0;

    /// <summary>Index of the linetype of the insert.</summary>
    public const int ByBlock = 1;

    /// <summary>Index of the linetype without gaps.</summary>
    public const int Continuous = 2;

    /// <summary>The linetypes that every drawing has, at the indices above.</summary>
    public static IReadOnlyList<Linetype> Standard { get; } = [new("ByLayer"), new("ByBlock"), new("Continuous")];

    /// <summary>Groups 49, in drawing units: a dash is positive, a gap negative, a dot 0. Empty for a linetype without gaps.</summary>
    public IReadOnlyList<double> Elements { get; init; } = [];

    /// <summary>A group 74 is not 0: texts or shapes are drawn in its gaps.</summary>
    public bool HasShapes { get; init; }

    /// <summary>Length of the pattern, drawing units; 0 without one.</summary>
    public double PatternLength => Elements.Sum(Math.Abs);
}
