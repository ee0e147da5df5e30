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

/// <summary>A machine whose drawing axes are not A and B needs only a profile: only <see cref="MachineAxes"/> contains axis letters.</summary>
public sealed class OtherAxesTests : IDisposable
{
    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("engraver-axes-");

    [Theory]
    [InlineData('C', 'D', JobMode.Stream)]
    [InlineData('C', 'D', JobMode.Calls)]
    [InlineData('C', 'D', JobMode.Program)]
    [InlineData('B', 'A', JobMode.Stream)]
    [InlineData('B', 'A', JobMode.Calls)]
    [InlineData('D', 'B', JobMode.Program)]
    public async Task A_part_is_cut_by_the_axes_of_the_profile(char x, char y, JobMode mode)
    {
        var report = await RunAsync(On(x, y), mode);

        Assert.Equal(JobOutcome.Complete, report.Result.Outcome);
        Assert.Equal("record", report.Judgement.Source);
        Assert.InRange(report.Judgement.MaxDeviationMm!.Value, 0.0, 0.0035);
        Assert.Equal(0.0, report.Judgement.MissingLengthMm);
    }

    [Theory]
    [InlineData('C', 'D', "galil")]
    [InlineData('B', 'A', "galil-calls")]
    [InlineData('D', 'A', "galil")]
    public async Task Its_posts_name_these_axes_and_no_others_and_cut_the_drawing(char x, char y, string target)
    {
        var settings = On(x, y);
        var drawing = Sample(settings);
        var text = PostedProgram.Create(drawing, settings, PostTable.Find(target).Post, PostedProgram.NoOptions).Text!;
        var report = await ProgramVerification.VerifyAsync(ReadBackFile.FromText(text), new DmcReader(), drawing, settings, progress: null, CancellationToken.None);

        Assert.True(report.Ok);
        Assert.Equal(0.0, report.MissingLengthMm);
        Assert.Contains($"VM{x}{y}", text, StringComparison.Ordinal);
        Assert.DoesNotMatch($"(SP|PA|AC|DC)[^{x}{y}]=|_RP[^{x}{y}]|(BG|AM|SH|ST|VM)[^{x}{y}S]", text);
    }

    [Fact]
    public async Task An_axis_that_the_controller_has_not_is_refused_before_anything_moves()
    {
        var report = await RunAsync(On('A', 'E'), JobMode.Stream);

        Assert.Equal((JobOutcome.Refused, 0), (report.Result.Outcome, report.Result.SegmentsExecuted));
        Assert.Contains("uses axes that this controller (ABCD) does not have: E", report.Result.Message, StringComparison.Ordinal);
    }

    public void Dispose() => _folder.Delete(recursive: true);

    private Task<MachineRunReport> RunAsync(DrawingSettings settings, JobMode mode)
    {
        var job = JobPreparation.Prepare(Sample(settings), settings, mode.Strategy().Style);
        var options = new MachineRunOptions(new SimulatedAddress(double.PositiveInfinity), mode.Strategy()) { JournalPath = Path.Combine(_folder.FullName, "job.jsonl") };
        return MachineRun.RunAsync(job, job.Motion.Program!, options, TimeProvider.System, progress: null, CancellationToken.None);
    }

    private static DrawingSettings On(char x, char y) => new() { Machine = new() { Axes = new MachineAxes(new MachineAxis(x, 1000.0), new MachineAxis(y, 1000.0)) } };

    private static Drawing Sample(DrawingSettings settings) => DrawingFile.Open(Path.Combine(RepositoryFolder.Samples, "gasket.dxf"), settings, CancellationToken.None);
}
