using Engraver.Core.Geometry;

namespace Engraver.Core.Operations;

/// <summary>One operation: what is machined, with which tool, how deep and how. Lengths in millimetres, depths below the top of the work (height 0) and
/// positive.</summary>
public sealed record Operation
{
    /// <summary>Distance of picked places from their contours unless stated otherwise, mm.</summary>
    public const double PickedWithin = 10.0;

    /// <summary>Unique in its list; files, journals and reports name the operation by it.</summary>
    public required string Id { get; init; }

    /// <summary>The name that is shown; empty for none.</summary>
    public string Name { get; init; } = "";

    /// <summary>False: it is kept and not run.</summary>
    public bool IsOn { get; init; } = true;

    public required OperationKind Kind { get; init; }

    public required OperationSelection Select { get; init; }

    /// <summary>Number of the tool in the library.</summary>
    public required int Tool { get; init; }

    /// <summary>Cutting speed along the path, mm/min; null: that of the tool, otherwise of the machine profile.</summary>
    public double? Feed { get; init; }

    /// <summary>Speed straight down, mm/min; null: that of the tool, otherwise of the machine profile.</summary>
    public double? Plunge { get; init; }

    /// <summary>Speed of the spindle, turns per minute; null: that of the tool, or none.</summary>
    public double? Spindle { get; init; }

    /// <summary>Power of a beam, percent of its full power, above 0 and up to 100; null: full power, or the speed of the tool where that is its
    /// power.</summary>
    public double? Power { get; init; }

    /// <summary>Depth of the surface where cutting begins.</summary>
    public double StartDepth { get; init; }

    /// <summary>Final depth; null on a machine without a tool axis.</summary>
    public double? Depth { get; init; }

    /// <summary>The depth below <see cref="StartDepth"/> follows from the width of each line: the groove is as wide as the line. <see cref="Depth"/> is then
    /// null; operations for each width are made of this one.</summary>
    public bool DepthByWidth { get; init; }

    /// <summary>Id of the operation from which this one was made for one width; empty otherwise.</summary>
    public string DividedFrom { get; init; } = "";

    /// <summary>Maximum depth that one pass removes; null: one pass.</summary>
    public double? DepthPerPass { get; init; }

    /// <summary>Depth that a last pass removes; 0 for no such pass.</summary>
    public double Finish { get; init; }

    /// <summary>Material that a profile or pocket leaves at the walls.</summary>
    public double Stock { get; init; }

    /// <summary>Number of times that the last pass is cut.</summary>
    public int Repeats { get; init; } = 1;

    /// <summary>Before each repeat of the last pass the job stops with the tool up and off, and continues when the operator continues it. A repeat then cuts
    /// all contours before the next one begins.</summary>
    public bool StopsBetween { get; init; }

    public CutDirection Direction { get; init; }

    public PassOrder Order { get; init; }

    /// <summary>Side of a profile.</summary>
    public ProfileSide Side { get; init; } = ProfileSide.Nesting;

    /// <summary>An engraving cuts the dashes of linetypes and leaves their gaps.</summary>
    public bool CutsDashes { get; init; }

    /// <summary>A pocket or fill takes the areas of hatches and solids of its selection, and no curves.</summary>
    public bool TakesHatches { get; init; }

    /// <summary>Distance of neighbouring passes of a pocket as a fraction of the tool's diameter, above 0 and below 1.</summary>
    public double Stepover { get; init; } = 0.4;

    /// <summary>Passes of a pocket are straight rows; otherwise they are parallel to its contour.</summary>
    public bool IsZigzag { get; init; }

    /// <summary>Distance of the lines of a fill, mm; 0 for another kind.</summary>
    public double Spacing { get; init; }

    /// <summary>Lines of a fill.</summary>
    public FillPattern Pattern { get; init; }

    /// <summary>A fill has a second set of lines at right angles to the first.</summary>
    public bool IsCross { get; init; }

    /// <summary>Distance of the lines of a fill from the contours, mm; null: the radius of the tool.</summary>
    public double? Inset { get; init; }

    /// <summary>Way of a beam before and behind each line of a fill at full speed while it is off, mm; 0 for none.</summary>
    public double Overscan { get; init; }

    /// <summary>Direction of straight rows, degrees counter-clockwise from the X axis.</summary>
    public double AngleDegrees { get; init; }

    /// <summary>Depth of a peck of a drill, after which the tool rises to the surface; null: one movement.</summary>
    public double? Peck { get; init; }

    /// <summary>Time at the bottom of a hole, seconds.</summary>
    public double DwellSeconds { get; init; }

    /// <summary>Time between the tool at work and its first move, seconds: until a beam has gone through the material.</summary>
    public double PierceSeconds { get; init; }

    /// <summary>A drill takes circles up to this diameter only; null: every circle.</summary>
    public double? MaxDiameter { get; init; }

    /// <summary>Angle at which the tool descends along a stroke to the depth of a pass, degrees; null: straight down.</summary>
    public double? RampDegrees { get; init; }

    /// <summary>Radius of the helix beside the start of a stroke on which the tool descends at that angle, mm; null: it descends along the stroke.</summary>
    public double? HelixRadius { get; init; }

    /// <summary>Length by which a closed profile is cut beyond its start, mm.</summary>
    public double Overcut { get; init; }

    /// <summary>Outputs of the machine profile that are on while its strokes are cut, by name or number: air, coolant.</summary>
    public IReadOnlyList<string> Outputs { get; init; } = [];

    /// <summary>How a profile is entered; null: straight down on the contour.</summary>
    public LeadMove? LeadIn { get; init; }

    /// <summary>How a profile is left; null: straight up.</summary>
    public LeadMove? LeadOut { get; init; }

    /// <summary>Where a closed profile starts.</summary>
    public StartRule Start { get; init; }

    /// <summary>Places that the operator picked, mm: each is the start of the closed contour nearest to it. The other contours start by
    /// <see cref="Start"/>.</summary>
    public IReadOnlyList<Point2D> StartAt { get; init; } = [];

    /// <summary>Largest distance of a picked start from the path of its contour, mm.</summary>
    public double StartWithin { get; init; } = PickedWithin;

    /// <summary>Bridges that hold the part; null for none.</summary>
    public PartTabs? Tabs { get; init; }

    /// <summary>The operation with its picked places on a drawing that is placed.</summary>
    internal Operation Placed(Func<Point2D, Point2D> map) => this with { StartAt = [.. StartAt.Select(map)], Tabs = Tabs is { } tabs ? tabs with { At = [.. tabs.At.Select(map)] } : null };

    /// <summary>Distance along a contour from its start within which a helix may cut, mm; 0 without one.</summary>
    internal double HelixReachOf(CuttingTool tool) => HelixRadius is { } radius ? radius + (tool.Diameter / 2.0) : 0.0;

    /// <summary>The kind as files write it.</summary>
    public string KindWord => OperationFields.WordOf(Kind);

    /// <summary>The name, or the id where it has none.</summary>
    public string Title => Name.Length > 0 ? Name : Id;

    /// <summary>Index of the last pass, which the repeats cut again.</summary>
    public int LastPass => Depth is null ? 0 : RoughPasses - (Finish > 0.0 ? 0 : 1);

    /// <summary>Passes before the last one removes <see cref="Finish"/>.</summary>
    private int RoughPasses => DepthPerPass is { } step ? Math.Max(1, (int)Math.Ceiling((Depth!.Value - Finish - StartDepth) / step * (1.0 - 1e-12))) : 1;

    /// <summary>The repeat that a pass is, from 2; 1 for the passes before the first repeat.</summary>
    /// <param name="pass">Index of the pass.</param>
    public int RepeatOf(int pass) => Math.Max(1, pass - LastPass + 1);

    /// <summary>Depth of each pass, from the top down; the last is <see cref="Depth"/>, once for each repeat. Passes divide the depth evenly.</summary>
    public IReadOnlyList<double> PassDepths()
    {
        if (Depth is not { } depth) return [.. Enumerable.Repeat(0.0, Repeats)];
        var (rough, count) = (depth - Finish, RoughPasses);
        List<double> depths = [.. Enumerable.Range(1, count).Select(pass => StartDepth + ((rough - StartDepth) * pass / count))];
        if (Finish > 0.0) depths.Add(depth);
        depths[^1] = depth;
        depths.AddRange(Enumerable.Repeat(depth, Repeats - 1));
        return depths;
    }
}
