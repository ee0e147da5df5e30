using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Toolpaths;
using Engraver.Galil.Programs.Generation;

namespace Engraver.Galil.Tests.Programs;

/// <summary>How a gap within the join tolerance (0.01 mm, ten counts of the default machine) is handled.</summary>
public class BridgedGapTests
{
    private const double MaxError = 0.001;

    /// <summary>Rounding one end of the bridge moves it by at most this, counts.</summary>
    private static readonly double s_rounding = Math.Sqrt(0.5);

    [Theory]
    [InlineData(0.0, 0.002)]
    [InlineData(0.0, 0.0044)]
    [InlineData(0.0, 0.01)]
    [InlineData(0.006, 0.0)]
    [InlineData(0.0099, 0.0)]
    [InlineData(-0.007, 0.007)]
    public void A_gap_is_cut_straight_from_the_true_end_to_the_true_start_and_at_most_half_of_it_from_the_drawing(double gapX, double gapY)
    {
        var (before, after) = (Toolpaths.Line(0, 0, 10, 0), Toolpaths.Line(10 + gapX, gapY, 20, gapY));
        var sequences = Program(Toolpaths.OfStroke(before, after)).Strokes.Single().Sequences;
        var replay = new SegmentReplay(MachineProfile.Default.AngleQuantumDegrees);
        foreach (var sequence in sequences) replay.Run(sequence);

        var gap = before.End.DistanceTo(after.Start);
        var off = replay.Track.Select(at => new Point2D(at.Place.X / 1000.0, at.Place.Y / 1000.0)).Max(place => Math.Min(before.DistanceTo(place), after.DistanceTo(place)));
        Assert.Contains(new CountsPoint(10_000, 0), sequences.SelectMany(sequence => sequence.Segments).Select(segment => segment.End));
        Assert.InRange(off, 0.0, (gap / 2.0) + (s_rounding / 1000.0));
    }

    [Theory]
    [InlineData(0.0069, 1000.0, 0.001, false)]
    [InlineData(0.0071, 1000.0, 0.001, true)]
    [InlineData(0.0071, 1000.0, 0.002, false)]
    [InlineData(0.0099, 500.0, 0.001, false)]
    [InlineData(0.0071, -1000.0, 0.001, true)]
    public void A_gap_that_takes_the_tool_farther_than_two_and_a_half_counts_and_the_curve_error_is_warned_of(double gap, double scale, double maxError, bool warned)
    {
        var profile = MachineProfile.Default with { Axes = MachineAxes.FromScale(scale, Math.Abs(scale)) };
        var found = MotionProgramGenerator.Generate(Toolpaths.OfStroke(Toolpaths.Line(0, 0, 10, 0), Toolpaths.Line(10 + gap, 0, 20, 0)), profile, new(maxError, 0.0), null).Diagnostics;

        Assert.Equal(warned ? ["MOT0011"] : [], found.Select(finding => finding.Id));
    }

    [Fact]
    public void The_warning_counts_the_gaps_and_names_the_widest()
    {
        var toolpath = Toolpaths.OfStroke(Toolpaths.Line(0, 0, 10, 0), Toolpaths.Line(10.008, 0, 20, 0), Toolpaths.Line(20.01, 0, 30, 0), Toolpaths.Line(30, 0, 40, 0));
        var found = Assert.Single(MotionProgramGenerator.Generate(toolpath, MachineProfile.Default, new(MaxError, 0.0), entity => new(entity + 1, null)).Diagnostics);

        Assert.Equal(3, found.Source.Line);
        Assert.EndsWith("At 2 of them the tool deviates from the drawing by more than rounding and curve error, up to 0.005 mm. The widest gap is 0.01 mm, at 20, 0.", found.Sentence, StringComparison.Ordinal);
    }

    private static MotionProgram Program(Toolpath toolpath) => MotionProgramGenerator.Generate(toolpath, MachineProfile.Default, new(MaxError, 0.0), null).Program!;
}
