using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Core.Offsets;
using Engraver.Core.Pockets;
using Engraver.Core.Posts;
using Engraver.Core.Sequencing;
using Engraver.Core.Sequencing.Ordering;
using Engraver.Core.Toolpaths;
using Engraver.Core.Verification;

namespace Engraver.TestKit;

/// <summary>Options of the stages for tests that do not depend on them. Core has no defaults of its own; <c>UsualOptionsTests</c> compares these tolerances
/// with the defaults of the program.</summary>
public static class UsualOptions
{
    public const double MaxErrorMm = 0.001;

    public const double JoinToleranceMm = 0.01;

    /// <summary>At 1000 counts per millimetre.</summary>
    private const double CountMm = 0.001;

    public static SequencingOptions Sequencing { get; } = new() { JoinTolerance = JoinToleranceMm, DuplicateTolerance = MaxErrorMm, Order = StrokeOrder.Nearest };

    public static OffsetOptions Offset { get; } = OffsetOptions.Round(MaxErrorMm);

    public static TraceTolerances Trace { get; } = new() { Count = CountMm, MaxError = MaxErrorMm };

    public static OffsetOptions OffsetWith(OffsetJoin join, double mitreLimit = 4.0) => new() { Join = join, MitreLimit = mitreLimit, MaxErrorMm = MaxErrorMm };

    public static PocketOptions Pocket(double toolRadius, double stepover) => new()
    {
        ToolRadius = toolRadius, Stepover = stepover, Strategy = PocketStrategy.Contour, Angle = default, FromCentre = false, Allowance = 0.0,
        MaxErrorMm = MaxErrorMm, JoinToleranceMm = JoinToleranceMm,
    };

    public static PostRequest Post(Toolpath path, MotionProgram? program, Func<int, SourceRef>? sourceOf, IReadOnlyDictionary<string, string> options) =>
        new(path, program, sourceOf, options) { Machine = MachineProfile.Default, MaxErrorMm = MaxErrorMm };
}
