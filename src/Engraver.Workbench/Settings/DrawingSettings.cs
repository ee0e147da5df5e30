using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Kerf;
using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Core.Operations;
using Engraver.Core.Machines.Origins;
using Engraver.Core.Sequencing.Ordering;

namespace Engraver.Workbench.Settings;

/// <summary>The settings between a drawing and its motion. Each property has a row in <see cref="SettingTable"/>. The defaults of the program are the values
/// here; only the numbers of the built-in machine are those of <see cref="MachineProfile"/>.</summary>
public sealed record DrawingSettings
{
    public static DrawingSettings Default { get; } = new();

    /// <summary>Unit of the next drawing that is opened or created, instead of the unit that its file states; null: the file's own. The drawing that is open
    /// keeps its <see cref="Drawing.Scale"/>.</summary>
    public LengthUnit? Unit { get; init; }

    /// <summary>Where the drawing is cut. In the desktop the open drawing is always placed so (<see cref="Drawing.Placement"/>).</summary>
    public DrawingPlacement Placement { get; init; } = DrawingPlacement.None;

    /// <summary>Construction of the next drawing that is opened which is cut all the same: hatch boundaries, multilines, leaders, helices, the edges of
    /// solids. The drawing that is open keeps its <see cref="Drawing.Cut"/>.</summary>
    public CutChoice Cut { get; init; }

    /// <summary>Only these layers (even when switched off); null: visible, not frozen, plottable.</summary>
    public IReadOnlyList<string>? Layers { get; init; }

    /// <summary>Layers left out.</summary>
    public IReadOnlyList<string> SkippedLayers { get; init; } = [];

    /// <summary>Maximum gap for joining end points, mm.</summary>
    public double JoinToleranceMm { get; init; } = 0.01;

    /// <summary>Maximum distance of a chord from its curve, mm.</summary>
    public double MaxErrorMm { get; init; } = 0.001;

    /// <summary>Maximum distance from a corner at which an arc rounds it, so that the machine need not stop there, mm; 0: it stops at corners.</summary>
    public double CornerToleranceMm { get; init; } = 0.01;

    /// <summary>Lines and arcs that continue each other are merged in the motion program, and lines that draw a curve become arcs within
    /// <see cref="MaxErrorMm"/>.</summary>
    public bool FitArcs { get; init; } = true;

    /// <summary>How far the motion may be beside the toolpath.</summary>
    public MotionTolerances MotionTolerances => new(MaxErrorMm, CornerToleranceMm) { FitsArcs = FitArcs };

    /// <summary>Drawing point at which the tool is when the job starts, mm.</summary>
    public Point2D Start { get; init; }

    /// <summary>Where the machine goes behind the last stroke, tool off.</summary>
    public FinishPlace Finish { get; init; }

    /// <summary>Where cutting must begin; null: free choice.</summary>
    public ContourEntry? Enter { get; init; }

    public StrokeOrder Order { get; init; } = StrokeOrder.Nearest;

    /// <summary>What <see cref="StrokeOrder.Optimal"/> minimises.</summary>
    public OrderCost OrderCost { get; init; } = OrderCost.Time;

    /// <summary>Seconds that the search for <see cref="StrokeOrder.Optimal"/> takes on all cores; 0: a number of steps on one core, so that the same drawing
    /// always has the same order.</summary>
    public double OrderSeconds { get; init; }

    public bool KeepDuplicates { get; init; }

    /// <summary>Lines that approximate an arc within <see cref="MaxErrorMm"/> are cut as that arc.</summary>
    public bool RecoverArcs { get; init; }

    /// <summary>On which side of the lines the tool runs.</summary>
    public KerfSide Kerf { get; init; }

    /// <summary>Diameter of the tool, mm; above 0 when <see cref="Kerf"/> is not off.</summary>
    public double ToolDiameterMm { get; init; }

    /// <summary>What is machined with which tool, how deep and how; null: every curve once, at the heights of the machine profile.</summary>
    public OperationPlan? Operations { get; init; }

    /// <summary>Number of the tool whose operations are run; 0: all, which then need the same tool.</summary>
    public int Tool { get; init; }

    /// <summary>The machine, with the feed of the feed option already in it.</summary>
    public MachineProfile Machine { get; init; } = MachineProfile.Default;

    /// <summary>The machine as the job uses it: operations replace its cutting depth, the depth of a pass and the plunge feed.</summary>
    public MachineProfile CuttingMachine => Operations?.Applied(Machine, Tool) ?? Machine;

    /// <summary>The settings for records of a drawing: with the unit, the placement and the construction that were chosen when it was opened, so that they
    /// open it again with the same scale and the same curves. Texts are not read differently: whether they are cut is a setting of the job.</summary>
    public DrawingSettings AsOpened(Drawing drawing)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        return this with { Unit = drawing.Unit.Source == LengthUnit.Chosen ? drawing.Unit : null, Placement = drawing.Placement, Cut = (drawing.Cut & ~CutChoice.Text) | (Cut & CutChoice.Text) };
    }
}
