using System.Globalization;
using System.Text.RegularExpressions;
using Engraver.Core.Drawings;
using Engraver.Core.Machines;
using Engraver.Galil.Language;
using Engraver.TestKit;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Verification;

namespace Engraver.Workbench.Tests.Machines;

/// <summary>A part with two depths and a ramp on the sample mill: from the DXF to the simulator's record, all samples are within 2.5 counts of the drawing in
/// X, Y and Z.</summary>
public sealed class HeightPartTests : IDisposable
{
    private const double Count = 1.0 / 800.0;
    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("engraver-heights-");

    private const string Slope = "slope";

    public static TheoryData<JobMode> Modes => [JobMode.Stream, JobMode.Calls, JobMode.Program];

    [Theory]
    [MemberData(nameof(Modes))]
    public async Task A_part_with_two_depths_and_a_ramp_is_cut_within_two_and_a_half_counts_in_three_coordinates(JobMode mode)
    {
        var report = await RunAsync(Part(), Mill(), mode);

        Assert.Equal(($"Done: {report.Result.SegmentsSent} segments.", JobOutcome.Complete), (report.Result.Message, report.Result.Outcome));
        Assert.InRange(report.Result.SegmentsSent, 9, 20); // it brakes before bends: segments are divided there
        Assert.Equal("record", report.Judgement.Source);
        Assert.InRange(report.Judgement.MaxDeviationMm!.Value, 0.0, 2.5 * Count);
        Assert.Equal(0.0, report.Judgement.MissingLengthMm);
        Assert.Equal(new CountsPoint(0, 0, 3200), report.Result.FinalPosition);
        Assert.InRange(report.Result.Seconds, 0.97 * report.PlannedSeconds, 1.03 * report.PlannedSeconds);
    }

    [Theory]
    [InlineData("galil", "LMABC")]
    [InlineData("galil-calls", "JS#SLOPE")]
    public async Task Its_posts_cut_the_same_in_three_axes_and_the_tool_is_up_before_each_rapid(string target, string slope)
    {
        var settings = new DrawingSettings { Machine = Mill() };
        var text = PostedProgram.Create(Part(), settings, PostTable.Find(target).Post, PostedProgram.NoOptions).Text!;

        var report = await ProgramVerification.VerifyAsync(ReadBackFile.FromText(text), new DmcReader(), Part(), settings, progress: null, CancellationToken.None);

        Assert.Empty(report.Diagnostics);
        Assert.True(report.Ok);
        Assert.InRange(report.MaxDeviationMm!.Value, 0.0, 2.5 * Count);
        Assert.Equal((0.0, 0.0), (report.MissingLengthMm, report.ExtraLengthMm));
        Assert.Contains(slope, text, StringComparison.Ordinal);
        Assert.DoesNotContain("1 OF", text, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(Slope, "")] // the slope ends a hundredth of a millimetre too high
    [InlineData("z=oz-800;", "z=oz-810;")] // a stroke is too deep
    [InlineData("z=oz-2000;", "z=oz-1980;")] // and one is not deep enough
    public async Task A_program_that_cuts_at_another_height_is_no_faithful_one(string was, string becomes)
    {
        var settings = new DrawingSettings { Machine = Mill() };
        var text = PostedProgram.Create(Part(), settings, PostTable.Find("galil").Post, PostedProgram.NoOptions).Text!;
        if (was == Slope) (was, becomes) = LowestSlope(text);
        Assert.Contains(was, text, StringComparison.Ordinal);

        var report = await ProgramVerification.VerifyAsync(ReadBackFile.FromText(text.Replace(was, becomes, StringComparison.Ordinal)), new DmcReader(), Part(), settings, progress: null, CancellationToken.None);

        Assert.False(report.Ok);
        Assert.InRange(report.MaxDeviationMm!.Value, 0.009, 0.03);
    }

    /// <summary>The last part of the slope, and the same ending a hundredth of a millimetre higher.</summary>
    private static (string Was, string Becomes) LowestSlope(string text)
    {
        var last = Regex.Matches(text, "LI ([0-9]+),([0-9]+),(-[0-9]+)").Last();
        var z = int.Parse(last.Groups[3].Value, CultureInfo.InvariantCulture);
        return (last.Value, string.Create(CultureInfo.InvariantCulture, $"LI {last.Groups[1].Value},{last.Groups[2].Value},{z + 10}"));
    }

    [Theory]
    [MemberData(nameof(Modes))]
    public async Task A_flat_drawing_is_cut_at_its_depth_in_passes(JobMode mode)
    {
        var mill = Mill() with { Height = Mill().Height! with { CutDepth = 2.5, DepthPerPass = 1.0 } };
        var drawing = Drawing(Circle(20, 20, 0, 8), Line(40, 10, 0, 60, 10, 0));

        var report = await RunAsync(drawing, mill, mode);

        Assert.Equal(("Done: 6 segments.", JobOutcome.Complete), (report.Result.Message, report.Result.Outcome));
        Assert.InRange(report.Judgement.MaxDeviationMm!.Value, 0.0, 2.5 * Count);
        Assert.Equal(0.0, report.Judgement.MissingLengthMm);
    }

    [Fact]
    public async Task What_coincides_in_plan_at_two_depths_is_cut_twice_and_found_missing_when_one_is_not_cut()
    {
        var drawing = Drawing(Line(10, 10, -1, 40, 10, -1), Line(10, 10, -2, 40, 10, -2));
        var report = await RunAsync(drawing, Mill(), JobMode.Stream);
        Assert.Equal(("Done: 2 segments.", 0.0), (report.Result.Message, report.Judgement.MissingLengthMm));

        var settings = new DrawingSettings { Machine = Mill() };
        var once = PostedProgram.Create(Drawing(Line(10, 10, -1, 40, 10, -1)), settings, PostTable.Find("galil").Post, PostedProgram.NoOptions).Text!;
        var found = await ProgramVerification.VerifyAsync(ReadBackFile.FromText(once), new DmcReader(), drawing, settings, progress: null, CancellationToken.None);
        Assert.Equal((false, 30.0), (found.Ok, Math.Round(found.MissingLengthMm, 2)));
    }

    [Fact]
    public async Task A_machine_that_switches_its_tool_says_that_heights_are_not_cut_and_cuts_the_plan()
    {
        var flat = MachineProfile.Default;
        var job = JobPreparation.Prepare(Part(), new DrawingSettings { Machine = flat }, MotionStyle.Continuous);
        Assert.Equal(["JOB0002", "JOB0003"], job.Findings.Select(finding => finding.Id));
        Assert.All(job.Motion.Program!.Strokes, stroke => Assert.Equal(0, stroke.Start.Z));

        var report = await RunAsync(Part(), flat, JobMode.Stream);
        Assert.Equal(JobOutcome.Complete, report.Result.Outcome);
        Assert.Empty(JobPreparation.Prepare(Part(), new DrawingSettings { Machine = Mill() }, MotionStyle.Continuous).Findings);
    }

    public void Dispose() => _folder.Delete(recursive: true);

    private static MachineProfile Mill() => MachineProfileSource.Load(Path.Combine(RepositoryFolder.Samples, "machine-mill.json"));

    /// <summary>A contour with a rounded corner 1 mm deep, a circle 2.5 mm deep, and a ramp down to 2.5 mm, level and up again.</summary>
    private static Drawing Part() => Drawing(
        Line(5, 5, -1, 35, 5, -1),
        [(0, "ARC"), (8, "0"), (10, 35.0), (20, 10.0), (30, -1.0), (40, 5.0), (50, 270.0), (51, 0.0)],
        Line(40, 10, -1, 40, 25, -1),
        Line(40, 25, -1, 5, 25, -1),
        Line(5, 25, -1, 5, 5, -1),
        Circle(15, 15, -2.5, 4),
        Line(25, 10, -0.5, 35, 14, -2.5),
        Line(35, 14, -2.5, 35, 20, -2.5),
        Line(35, 20, -2.5, 25, 20, -0.5));

    private static (int Code, object Value)[] Line(double x1, double y1, double z1, double x2, double y2, double z2) =>
        [(0, "LINE"), (8, "0"), (10, x1), (20, y1), (30, z1), (11, x2), (21, y2), (31, z2)];

    private static (int Code, object Value)[] Circle(double x, double y, double z, double radius) => [(0, "CIRCLE"), (8, "0"), (10, x), (20, y), (30, z), (40, radius)];

    private static Drawing Drawing(params (int Code, object Value)[][] entities)
    {
        using var folder = new TemporaryDrawing(DxfText.WithEntities([.. entities.SelectMany(entity => entity)]).ToAscii());
        return DrawingFile.Open(folder.Path, new DrawingSettings(), CancellationToken.None);
    }

    private async Task<MachineRunReport> RunAsync(Drawing drawing, MachineProfile machine, JobMode mode)
    {
        var settings = new DrawingSettings { Machine = machine };
        var job = JobPreparation.Prepare(drawing, settings, mode.Strategy().Style);
        var options = new MachineRunOptions(new SimulatedAddress(double.PositiveInfinity), mode.Strategy()) { JournalPath = Path.Combine(_folder.FullName, "job.jsonl") };
        return await MachineRun.RunAsync(job, job.Motion.Program!, options, TimeProvider.System, progress: null, CancellationToken.None);
    }

    private sealed class TemporaryDrawing : IDisposable
    {
        public TemporaryDrawing(byte[] content) => File.WriteAllBytes(Path, content);

        public string Path { get; } = System.IO.Path.Combine(System.IO.Path.GetTempPath(), $"engraver-{Guid.NewGuid():N}.dxf");

        public void Dispose() => File.Delete(Path);
    }
}
