using Engraver.Core.Drawings;
using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Operations;
using Engraver.Core.Sequencing;
using Engraver.Core.Sequencing.Ordering;
using Engraver.Core.Toolpaths;
using Engraver.Core.Verification;

namespace Engraver.Core.Tests.Operations;

/// <summary>A drawing with its operations, through every step to the strokes.</summary>
internal sealed class OperationJob
{
    public const double MaxError = 0.001;

    private static readonly SequencingOptions s_options = new() { JoinTolerance = 0.01, DuplicateTolerance = MaxError, Order = StrokeOrder.Nearest };

    private static readonly MachineLimits s_limits = new(SlowestSpeed: 2, FastestSpeed: 12_000_000, AccelerationStep: 1024, LargestAcceleration: 67_107_840, Outputs: 8, "ABCDEFGH");

    private readonly Drawing _drawing;

    /// <param name="operations">The entries of the list, as JSON. Tool 1 has a diameter of 2 mm, tool 2 of 1 mm, tool 3 a tip of 60 degrees.</param>
    public OperationJob(Drawing drawing, string operations, MachineProfile? machine = null, int tool = 0, double diameter = 2.0)
    {
        var read = OperationFile.Read(FormattableString.Invariant($$"""{ "version": "1.0", "tools": [{"number": 1, "diameter": {{diameter}}, "plunge": 100}, {"number": 2, "diameter": 1, "maxDepth": 4}, {"number": 3, "kind": "engraver", "diameter": 2, "angle": 60, "tip": 0.1, "maxDepth": 1.6}], "operations": [{{operations}}] }"""), _ => (null, ""));
        Assert.True(read.Plan is not null, string.Join('\n', read.Diagnostics.Select(finding => finding.Message)));
        Plan = read.Plan;
        var analysed = ArcAnalysis.Analyse(EntityTableBuilder.Build(drawing, LayerSelection.Default));
        Assignment = OperationAssignment.Of(analysed, drawing, Plan, machine ?? new MachineProfile { Height = new HeightDrive(), Axes = MachineAxes.Default with { Z = new MachineAxis('C', 800.0) } }, s_limits, tool, LayerSelection.Default);
        _drawing = drawing = Assignment.Drawing;
        var shaper = new OperationShaper(drawing, s_options, MaxError);
        Shapes = [.. Assignment.Parts.Select(shaper.Shape)];
        Ordered = OperationOrder.Of(Shapes, drawing, s_options);
        Passes = OperationPasses.Of(Ordered, Sequencer.Chain(analysed, drawing, s_options), Assignment.Contours, drawing, s_options, MaxError);
        Path = ToolpathPlanner.Plan(Passes.Sequence, default, MaxError);
    }

    public OperationPlan Plan { get; }

    public OperationAssignment Assignment { get; }

    public IReadOnlyList<ShapedOperation> Shapes { get; }

    public IReadOnlyList<OrderedOperation> Ordered { get; }

    public OperationPasses Passes { get; }

    public Toolpath Path { get; }

    /// <summary>Ids of the findings of the check of a path.</summary>
    public IReadOnlyList<string> CheckOf(Toolpath path) => [.. OperationCheck.Findings(Shapes, Assignment.Contours, path, Passes.Strokes, new ToolpathTolerances(MaxError, 0.01, false), _drawing.SourceOf).Select(finding => finding.Id)];

    /// <summary>Ids of the findings of the check of a drilled shape without strokes.</summary>
    public IReadOnlyList<string> CheckOfShape(ShapedOperation shape) => [.. OperationCheck.Findings([shape], Assignment.Contours, new Toolpath(default, []), [], new ToolpathTolerances(MaxError, 0.01, false), _drawing.SourceOf).Select(finding => finding.Id)];

    /// <summary>Ids of the findings of the check of dashes.</summary>
    public IReadOnlyList<string> CheckOfDashes(ShapedOperation shape) => [.. DashCheck.Findings([shape], _drawing, MaxError).Select(finding => finding.Id)];

    /// <summary>Ids of the findings of the check of widths.</summary>
    public IReadOnlyList<string> CheckOfWidths(Toolpath path, OperationAssignment? assignment = null) => [.. LineWidthCheck.Findings(assignment ?? Assignment, _drawing, path, Passes.Strokes).Select(finding => finding.Id)];

    /// <summary>Points of a stroke, at most a step apart.</summary>
    public static IEnumerable<Point2D> PointsOf(ToolpathStroke stroke, double step) =>
        stroke.Moves.SelectMany(move => Enumerable.Range(0, (int)Math.Ceiling(move.Segment.Length / step) + 1).Select(i => move.Segment.PointAt(Math.Min(1.0, i * step / Math.Max(move.Segment.Length, step)))));

    /// <summary>Signed area of the polygon of some points, positive counter-clockwise.</summary>
    public static double AreaOf(IReadOnlyList<Point2D> points)
    {
        var area = 0.0;
        for (var i = 0; i < points.Count; i++) area += (points[i].X * points[(i + 1) % points.Count].Y) - (points[(i + 1) % points.Count].X * points[i].Y);
        return area / 2.0;
    }
}
