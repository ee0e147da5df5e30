using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Records;
using Engraver.Core.Geometry;

namespace Engraver.Core.Dxf.Blocks;

/// <summary>A block definition: a run of the block columns, the inserts between its curves, and what cannot be taken.</summary>
internal sealed class BlockDefinition(string name, Vector3D basePoint, int firstCurve)
{
    public string Name { get; } = name;

    public Vector3D BasePoint { get; } = basePoint;

    public int FirstCurve { get; } = firstCurve;

    /// <summary>One past the last curve.</summary>
    public int EndCurve { get; set; } = firstCurve;

    /// <summary>True when nothing can come of it and nothing is reported of it.</summary>
    public bool IsEmpty => EndCurve == FirstCurve && Inserts.Count == 0 && Troubles.Count == 0 && Texts.Count == 0 && Construction.Count == 0;

    /// <summary>What its splines cost an expansion beyond one step each: they may have a million spans.</summary>
    public long ExtraSteps { get; set; }

    public List<NestedInsert> Inserts { get; } = [];

    /// <summary>Findings about its records; most concern the operator only when the block is used (<see cref="RecordIssue.ConcernsMore"/>).</summary>
    public List<RecordIssue> Troubles { get; } = [];

    /// <summary>Texts and points directly in it, by type.</summary>
    public Dictionary<string, long> Annotations { get; } = new(StringComparer.Ordinal);

    /// <summary>Construction other than text directly in it that can be seen, by type and layer.</summary>
    public Dictionary<(string Type, int Layer), (int Count, SourceRef First)> Construction { get; } = [];

    /// <summary>The same texts with content and place; those of attributes too.</summary>
    public List<PlacedText> Texts { get; } = [];

    /// <summary>What the block amounts to with all that is nested in it; null until it has been weighed.</summary>
    public BlockWeight? Weight { get; set; }
}
