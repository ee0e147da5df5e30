using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Records;
using Engraver.Core.Geometry;

namespace Engraver.Core.Dxf.Blocks;

/// <summary>A block definition: a range of the block columns, the inserts between its curves, and findings about its records.</summary>
internal sealed class BlockDefinition(string name, Vector3D basePoint, int firstCurve)
{
    public string Name { get; } = name;

    public Vector3D BasePoint { get; } = basePoint;

    public int FirstCurve { get; } = firstCurve;

    /// <summary>Index after the last curve.</summary>
    public int EndCurve { get; set; } = firstCurve;

    /// <summary>True when inserting it does not draw or report anything.</summary>
    public bool IsEmpty => EndCurve == FirstCurve && Inserts.Count == 0 && Issues.Count == 0 && Texts.Count == 0 && Construction.Count == 0;

    /// <summary>Steps of an expansion beyond one for each curve: a spline may have a million spans.</summary>
    public long ExtraSteps { get; set; }

    public List<NestedInsert> Inserts { get; } = [];

    /// <summary>Findings about its records; most concern the operator only when the block is used (<see cref="RecordIssue.ConcernsMore"/>).</summary>
    public List<RecordIssue> Issues { get; } = [];

    /// <summary>Number of texts and points directly in it, by type.</summary>
    public Dictionary<string, long> Annotations { get; } = new(StringComparer.Ordinal);

    /// <summary>Visible construction other than text directly in it, by type and layer.</summary>
    public Dictionary<(string Type, int Layer), (int Count, SourceRef First)> Construction { get; } = [];

    /// <summary>Its texts with content and position; those of attributes too.</summary>
    public List<PlacedText> Texts { get; } = [];

    /// <summary>Its points with their places.</summary>
    public List<PlacedPoint> Points { get; } = [];

    /// <summary>Its weight, nested blocks included; null until it has been computed.</summary>
    public BlockWeight? Weight { get; set; }
}
