using Engraver.Core.Drawings;
using Engraver.Core.Machines;
using Engraver.Galil.Programs.Posting;
using Engraver.TestKit;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.Reports;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Verification;

namespace Engraver.Workbench.Tests.Verification;

/// <summary>The program of a drawing with a small arc between two lines, compared with the two lines alone.</summary>
public class CornerVerificationTests
{
    /// <summary>Distance of the middle of an arc of radius 0.1 in a right angle from its sides.</summary>
    private const double Deviation = 0.1 * (1.0 - 0.70710678);

    private static readonly Drawing s_corner = new DrawingBuilder().Line(0, 0, 10, 0).Line(10, 0, 10, 8).Build();
    private static readonly Drawing s_rounded = new DrawingBuilder().Line(0, 0, 9.9, 0).Arc(9.9, 0.1, 0.1, 270, 0).Line(10, 0.1, 10, 8).Build();

    [Theory]
    [InlineData(MotionStyle.Continuous)]
    [InlineData(MotionStyle.Calls)]
    public async Task A_Galil_program_may_round_a_corner_within_the_tolerance(MotionStyle style)
    {
        var motion = JobPreparation.Prepare(s_rounded, Settings(0.0), style).Motion.Program!;
        var text = style == MotionStyle.Calls ? DmcPost.Calls(motion, DmcPostOptions.Default).Text : DmcPost.Sequences(motion, DmcPostOptions.Default).Text;

        var allowed = await VerifyAsync(text, new DmcReader(), 0.05);
        Assert.InRange(allowed.MaxDeviationMm!.Value, 0.0, 0.002);
        Assert.Equal(Deviation, allowed.CornerDeviationMm!.Value, 0.002);
        Assert.Equal((0.0, 0.0, 0.0035), (allowed.MissingLengthMm, allowed.ExtraLengthMm, allowed.ToleranceMm));
        Assert.DoesNotContain(allowed.Diagnostics, finding => finding.Id is "VER0008" or "VER0009");
        Assert.Contains("At rounded corners: 0.02", VerificationText.Sentence(allowed), StringComparison.Ordinal);

        var tight = await VerifyAsync(text, new DmcReader(), 0.02);
        Assert.Contains(tight.Diagnostics, finding => finding.Id == "VER0008");
        var none = await VerifyAsync(text, new DmcReader(), 0.0);
        Assert.Equal((true, null), (none.MaxDeviationMm > 0.02, none.CornerDeviationMm));
    }

    [Fact]
    public async Task G_code_keeps_the_corners()
    {
        var target = PostTable.Find("gcode");
        var text = PostedProgram.Create(s_rounded, Settings(0.0), target.Post, PostedProgram.NoOptions).Text!;
        var report = await VerifyAsync(text, target.Reader!, 0.05);

        Assert.Contains(report.Diagnostics, finding => finding.Id == "VER0008");
        Assert.Null(report.CornerDeviationMm);
    }

    /// <summary>An arc in counts would be an ellipse in the drawing.</summary>
    [Theory]
    [InlineData(1000.0, 0.05)]
    [InlineData(-1000.0, 0.05)]
    [InlineData(800.0, 0.0)]
    public void Corners_are_rounded_on_axes_of_equal_scale_only(double y, double tolerance)
    {
        var settings = Settings(0.05) with { Machine = MachineProfile.Default with { Axes = MachineAxes.Default with { Y = new MachineAxis('B', y) } } };

        Assert.Equal(tolerance, RunJudge.Tolerances(JobPreparation.Prepare(s_corner, settings, MotionStyle.Continuous)).CornerTolerance);
    }

    private static DrawingSettings Settings(double tolerance) => new() { CornerToleranceMm = tolerance };

    private static Task<VerificationReport> VerifyAsync(string text, Core.Posts.IProgramReader reader, double tolerance) =>
        ProgramVerification.VerifyAsync(ReadBackFile.FromText(text), reader, s_corner, Settings(tolerance), progress: null, CancellationToken.None);
}
