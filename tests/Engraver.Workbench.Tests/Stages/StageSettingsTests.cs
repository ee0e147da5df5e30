using System.Globalization;
using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Kerf;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;
using Engraver.Core.Motion;
using Engraver.Core.Operations;
using Engraver.Core.Sequencing.Ordering;
using Engraver.TestKit;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Stages;

namespace Engraver.Workbench.Tests.Stages;

/// <summary>Changes each setting alone for each stage alone and compares the results: exactly the settings that a stage lists make a difference.</summary>
public class StageSettingsTests
{
    private static readonly MachineProfile s_mill = MachineProfileSource.Load(Path.Combine(RepositoryFolder.Samples, "machine-mill.json"));

    private static readonly OperationPlan s_operations = Plan(depth: 1, feed: 500);

    private static readonly DrawingSettings s_drawn = new() { SkippedLayers = ["C"], RecoverArcs = true };

    private static readonly IReadOnlyList<DrawingSettings> s_bases =
    [
        s_drawn,
        s_drawn with { MaxErrorMm = 0.05, JoinToleranceMm = 0.5 },
        s_drawn with { Machine = s_mill },
        s_drawn with { Order = StrokeOrder.Optimal },
        s_drawn with { Kerf = KerfSide.Nesting, ToolDiameterMm = 1.0 },
        s_drawn with { Machine = s_mill, Operations = s_operations },
    ];

    private static readonly Dictionary<Setting, Func<DrawingSettings, DrawingSettings>> s_changes = new()
    {
        [SettingTable.Layers] = settings => settings with { Layers = ["B"] },
        [SettingTable.SkippedLayers] = settings => settings with { SkippedLayers = ["B"] },
        [SettingTable.Units] = settings => settings with { Unit = LengthUnit.AssumedMillimetres with { MillimetresPerUnit = 25.4 } },
        [SettingTable.Scale] = settings => settings with { Placement = settings.Placement with { Scale = 3.0 } },
        [SettingTable.Mirror] = settings => settings with { Placement = settings.Placement with { Mirror = MirrorAxis.X } },
        [SettingTable.Rotate] = settings => settings with { Placement = settings.Placement with { Rotation = Angle.FromDegrees(30.0) } },
        [SettingTable.Move] = settings => settings with { Placement = settings.Placement with { Move = new Vector2D(5.0, 7.0) } },
        [SettingTable.Place] = settings => settings with { Placement = settings.Placement with { Place = BlankPlace.Corner } },
        [SettingTable.Align] = settings => settings with { Placement = settings.Placement with { Align = new PointPair(default, new Point2D(1.0, 0.0)) } },
        [SettingTable.To] = settings => settings with { Placement = settings.Placement with { To = new PointPair(default, new Point2D(0.0, 1.0)) } },
        [SettingTable.AlignTolerance] = settings => settings with { Placement = settings.Placement with { AlignTolerance = 2.0 } },
        [SettingTable.Blank] = settings => settings with { Placement = settings.Placement with { Blank = new Vector2D(3.0, 4.0) } },
        [SettingTable.Back] = settings => settings with { Placement = settings.Placement with { Back = MirrorAxis.Y } },
        [SettingTable.Cut] = settings => settings with { Cut = (CutChoice)31 },
        [SettingTable.JoinTolerance] = settings => settings with { JoinToleranceMm = settings.JoinToleranceMm > 0.1 ? 0.01 : 0.5 },
        [SettingTable.CornerTolerance] = settings => settings with { CornerToleranceMm = settings.CornerToleranceMm > 0.015 ? 0.002 : 0.02 },
        [SettingTable.FitArcs] = settings => settings with { FitArcs = !settings.FitArcs },
        [SettingTable.MaxError] = settings => settings with { MaxErrorMm = settings.MaxErrorMm > 0.01 ? 0.0001 : 0.05 },
        [SettingTable.Start] = settings => settings with { Start = new Point2D(30_000, 4) },
        [SettingTable.Finish] = settings => settings with { Finish = FinishPlace.Stay },
        [SettingTable.Enter] = settings => settings with { Enter = new ContourEntry.ByPoint(new Point2D(40, 0)) },
        [SettingTable.Order] = settings => settings with { Order = StrokeOrder.Drawn },
        [SettingTable.OrderCost] = settings => settings with { OrderCost = OrderCost.Distance },
        [SettingTable.OrderSeconds] = settings => settings with { OrderSeconds = 0.001 },
        [SettingTable.KeepDuplicates] = settings => settings with { KeepDuplicates = true },
        [SettingTable.RecoverArcs] = settings => settings with { RecoverArcs = !settings.RecoverArcs },
        [SettingTable.Kerf] = settings => settings with { Kerf = settings.Kerf == KerfSide.Off ? KerfSide.Outside : KerfSide.Off, ToolDiameterMm = 1.0 },
        [SettingTable.ToolDiameter] = settings => settings with { ToolDiameterMm = 2.0 },
        [SettingTable.Operations] = settings => settings with { Operations = settings.Operations is null ? s_operations : Plan(depth: 2, feed: 400) },
        [SettingTable.Tool] = settings => settings with { Tool = 7 },
        [SettingTable.Machine] = settings => settings with { Machine = settings.Machine.Height is null ? s_mill : MachineProfile.Default },
        [SettingTable.Feed] = settings => settings with { Machine = settings.Machine with { FeedMmPerMinute = 77 } },
        [SettingTable.VectorSpeed] = settings => settings with { Machine = settings.Machine with { FeedMmPerMinute = 88 } },
        [SettingTable.Rapid] = settings => settings with { Machine = settings.Machine with { RapidMmPerMinute = 99 } },
        [SettingTable.Acceleration] = settings => settings with { Machine = settings.Machine with { AccelerationCounts = 20_480 } },
    };

    private static OperationPlan Plan(double depth, double feed) => OperationFile.Parse(FormattableString.Invariant($$"""{ "version": "1.0", "tools": [{"number": 1, "diameter": 1}], "operations": [{ "id": "a", "kind": "engrave", "select": {"layers": ["B"]}, "tool": 1, "depth": {{depth}}, "feed": {{feed}} }, { "id": "b", "kind": "engrave", "select": "rest", "tool": 1, "depth": 1 }] }"""));

    public static TheoryData<string> Keys => [.. JobStages.All.Select(stage => stage.Key)];

    [Theory]
    [MemberData(nameof(Keys))]
    public void A_stage_reads_no_setting_that_it_does_not_list(string key)
    {
        var stage = JobStages.All.Single(stage => stage.Key == key);
        var read = SettingTable.All.Where(setting => s_bases.Any(settings => Differs(stage, settings, s_changes[setting]))).Select(setting => setting.Key);

        Assert.Empty(read.Except(stage.Settings.Select(setting => setting.Key)));
    }

    private static bool Differs(JobStage stage, DrawingSettings settings, Func<DrawingSettings, DrawingSettings> change)
    {
        var input = JobStages.All.TakeWhile(earlier => earlier != stage).Aggregate(new DrawnJob(Drawing(), settings), (job, earlier) => earlier.Run(job, CancellationToken.None));
        return Print(stage.Run(input, CancellationToken.None)) != Print(stage.Run(input with { Settings = change(settings) }, CancellationToken.None));
    }

    /// <summary>Duplicates, a gap of 0.1 mm, lines that approximate arcs, an ellipse, three layers, slopes, and lines above each other.</summary>
    private static Drawing Drawing()
    {
        var builder = new DrawingBuilder().Line(0, 0, 10, 0).Line(0, 0, 10, 0).Line(0, 0, 10, 0).Line(0, 60, 10, 60).Line(0, 64, 10, 64);
        builder.Line(0, 70, 10, 70).Line(0, 70.02, 10, 70.02).Line(0, 80, 10, 80).Line(0, 80.02, 10, 80.02);
        builder.Square(20, 0, 10).Circle(25, 5, 2).Line(80, 0, 90, 0).Line(90.1, 0, 100, 0).Line(0, 20, 10, 20).Line(0, 20.02, 10, 20.02);
        builder.Curve(CurveType.LwPolyline, Chords(60, 0, 5)).Curve(CurveType.LwPolyline, Chords(60, 20, 1)).Free(FreeCurves.Ellipse(120, 0, 12, 0.6, 0, 0, 360).ToCurve());
        builder.OnLayer(new Layer("B", On: true, Frozen: false, Plot: true)).Line(0, 40, 5, 45).OnLayer(new Layer("C", On: true, Frozen: false, Plot: true)).Line(0, 50, 5, 50);
        var drawing = builder.Build();
        return drawing with { Parts = drawing.Parts.With(Enumerable.Range(0, drawing.Parts.Count).Select(i => (i, AtHeight(drawing.Parts[i]))), []) };
    }

    private static DrawingPart AtHeight(DrawingPart part)
    {
        if (part.Entity is >= 2 and <= 8) (part.C, part.F) = part.Entity switch { 2 or 5 or 8 => (-1.0, -1.0), 3 => (-0.3, 0.0), 4 => (0.0, -0.3), _ => (0.0, 0.0) };
        return part;
    }

    /// <summary>A quarter of a circle of radius 5 mm as lines.</summary>
    private static Segment[] Chords(double x, double y, int degrees) =>
        [.. Enumerable.Range(0, 90 / degrees).Select(i => Segment.FromLine(On(x, y, i * degrees), On(x, y, (i + 1) * degrees)))];

    private static Point2D On(double x, double y, int degrees) => new(x + (5.0 * Math.Cos(double.DegreesToRadians(degrees))), y + (5.0 * Math.Sin(double.DegreesToRadians(degrees))));

    private static string Print(DrawnJob job) => job switch
    {
        PlannedJob { Planned: { } planned } of => Join([of.Posted.Value!.Text, planned.DurationSeconds, .. Sentences(of.PostFindings)]),
        CheckedJob of => Join([of.Motion.Program is null, .. Sentences([.. of.Faults, .. of.Findings])]),
        MotionJob { Motion.Program: { } program } => Join([ProgramFingerprint.Of(program), program.Start, program.Finish, program.Profile, MotionTime.Calculate(program, MachineFamilies.DriverOf(program.Profile).NetworkTimes).Total]),
        PathJob { Toolpath: var path } => Join([path.ToolStart, .. path.Strokes.Select(stroke => stroke.FeedMmPerMinute), .. path.Strokes.SelectMany(stroke => stroke.Moves).Select(move => Print(move.Segment))]),
        OrderedJob { Sequence: var sequence } of => Join([sequence.Travel, .. of.Operations.SelectMany(operation => Print(operation.Path.ToSegments())), .. of.Passes.Select(pass => pass.Depth), .. Print(sequence.Table.ToSegments()), .. sequence.Discontinuities.Select(end => end.DiagnosticId), .. Sentences(sequence.Diagnostics)]),
        ShapedJob { Shapes: { Count: > 0 } shapes } and not (ChainedJob or OrderedJob) => Join([.. shapes.SelectMany(shape => Print(shape.Path.ToSegments()))]),
        ChainedJob { Chained: var chained } => Join([.. Print(chained.Segments), chained.Chain.Contours.Count, chained.DuplicatesRemoved, .. Sentences(chained.Diagnostics)]),
        CompensatedJob { Cut: var cut } => Join([.. Print(cut.Table.ToSegments()), .. Sentences(cut.Diagnostics)]),
        AssignedJob { Assignment: { } assignment } => Join([.. assignment.Parts.SelectMany(part => Print(part.Table.ToSegments())), .. Sentences(assignment.Findings), .. Sentences(assignment.Faults)]),
        AnalysedJob of => Join([.. Print(of.Analysed.ToSegments())]),
        LetteredJob { Letters: var letters } => Join([letters.Drawing.Entities.Count, letters.Drawing.Parts.Count, letters.Texts.Count, .. Sentences(letters.Findings)]),
        _ => throw new ArgumentException("not printed", nameof(job)),
    };

    private static IEnumerable<string> Print(ReadOnlyMemory<Segment> segments) => segments.ToArray().Select(Print);

    private static string Print(Segment segment) => $"{segment.Kind} {segment.Start} {segment.End} {segment.Length}";

    private static IEnumerable<string> Sentences(IReadOnlyList<Diagnostic> findings) => findings.Select(finding => finding.Sentence);

    private static string Join(object?[] facts) => string.Join('\n', facts.Select(fact => Convert.ToString(fact, CultureInfo.InvariantCulture)));
}
