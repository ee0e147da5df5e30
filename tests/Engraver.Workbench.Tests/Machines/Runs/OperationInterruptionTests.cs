using Engraver.Core.Drawings;
using Engraver.Core.Machines;
using Engraver.Core.Operations;
using Engraver.Core.Sequencing;
using Engraver.TestKit;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Tests.Machines.Runs;

/// <summary>HOLD within a lead, over a tab and in a peck, and STOP with a resumed run: a square of 24 mm with a lead-in and two tabs, and a hole.</summary>
public sealed class OperationInterruptionTests : IDisposable
{
    private const string Operations = """
        { "version": "1.0", "tools": [{"number": 1, "diameter": 2, "feed": 600, "plunge": 200}],
          "operations": [
            { "id": "hole", "kind": "drill", "select": {"layers": ["HOLES"]}, "tool": 1, "depth": 2, "peck": 0.7 },
            { "id": "cut", "kind": "profile", "side": "outside", "select": {"layers": ["0"]}, "tool": 1, "depth": 2, "leadIn": {"shape": "arc", "radius": 3}, "tabs": {"count": 2, "width": 3, "height": 1} }] }
        """;

    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("engraver-roles-");
    private readonly PreparedJob _job = JobPreparation.Prepare(Plate(), new DrawingSettings { Machine = MachineProfileSource.Load(Path.Combine(RepositoryFolder.Samples, "machine-mill.json")), Operations = OperationFile.Parse(Operations) }, MotionStyle.Continuous);

    public static TheoryData<string> Places => ["lead", "tab", "peck"];

    public void Dispose() => _folder.Delete(recursive: true);

    [Theory]
    [MemberData(nameof(Places))]
    public async Task A_hold_there_continues_on_the_path(string place)
    {
        var control = new JobControl();
        var isHeld = false;

        var report = await RunAsync("held.jsonl", control, null, CancellationToken.None, progress =>
        {
            if (!isHeld && IsAt(place, progress)) control.Hold();
            isHeld |= control.IsHoldWanted;
            if (progress.Phase == JobPhase.Held) control.Resume();
        });

        Assert.Equal((JobOutcome.Complete, 1), (report.Result.Outcome, report.Result.Holds));
        AssertCut(report, ["hole 2", "cut 2"]);
    }

    [Theory]
    [MemberData(nameof(Places))]
    public async Task A_job_that_was_stopped_there_is_resumed_on_the_path(string place)
    {
        using var stop = new CancellationTokenSource();
        var first = await RunAsync("first.jsonl", new JobControl(), null, stop.Token, progress =>
        {
            if (IsAt(place, progress)) stop.Cancel();
        });
        Assert.Equal(JobOutcome.Stopped, first.Result.Outcome);
        Assert.Equal(place == "peck" ? 0 : 1, _job.Motion.Program!.SegmentAfter(first.Result.Place.Segments)!.Value.Stroke);

        var second = await RunAsync("second.jsonl", new JobControl(), new ResumeRequest { Journal = Path.Combine(_folder.FullName, "first.jsonl") }, CancellationToken.None, _ => { });

        Assert.True(second.Result.Outcome == JobOutcome.Complete, second.Result.Message);
        AssertCut(second, place == "peck" ? ["hole 2", "cut 2"] : ["cut 2"]);
    }

    private static void AssertCut(MachineRunReport report, string[] operations)
    {
        Assert.Equal("record", report.Judgement.Source);
        Assert.InRange(report.Judgement.MaxDeviationMm!.Value, 0.0, 0.004);
        Assert.Equal(0.0, report.Judgement.MissingLengthMm);
        Assert.Equal(operations, report.Judgement.Operations.Select(one => FormattableString.Invariant($"{one.Id} {one.Depths[0]:0.###}")));
        Assert.All(report.Judgement.Operations, one => Assert.Equal((0.0, 0.0), (one.MissingLength, one.ExtraLength)));
        Assert.All(report.Judgement.Operations, one => Assert.InRange(one.MaxDeviation, 0.0, 0.004));
    }

    /// <summary>Whether the tool is in the middle of a move of this kind.</summary>
    private bool IsAt(string place, in JobProgress progress)
    {
        if (progress.Phase != JobPhase.Running || !progress.ToolOn) return false;
        var (at, depth) = (_job.Settings.Machine.Scale.ToMillimetres(progress.X, progress.Y), -progress.Place.Z / 800.0);
        if (place == "peck") return progress.Stroke == 0 && depth is > 0.9 and < 1.3;
        var role = place == "lead" ? StrokeRole.Lead : StrokeRole.Tab;
        return progress.Stroke == 1 && _job.Toolpath.Strokes[1].Moves.Any(move => move.Role == role && move.Segment.Length > 1.0 && move.Segment.PointAt(0.5).DistanceTo(at) < 1.0 && Math.Abs(depth + move.StartZ) < 0.1);
    }

    private Task<MachineRunReport> RunAsync(string journal, JobControl control, ResumeRequest? resume, CancellationToken stop, Action<JobProgress> told)
    {
        var options = new MachineRunOptions(new SimulatedAddress(double.PositiveInfinity), MachineFamilies.DriverOf(_job.Settings.Machine).DefaultStrategy) { JournalPath = Path.Combine(_folder.FullName, journal), Control = control, Resume = resume };
        return MachineRun.RunAsync(_job, _job.Motion.Program!, options, TimeProvider.System, new Told(told), stop);
    }

    private static Drawing Plate() => new DrawingBuilder()
        .Line(0, 0, 24, 0).Line(24, 0, 24, 24).Line(24, 24, 0, 24).Line(0, 24, 0, 0)
        .OnLayer(new Layer("HOLES", On: true, Frozen: false, Plot: true)).Circle(12, 12, 1)
        .Build();

    private sealed class Told(Action<JobProgress> report) : IProgress<JobProgress>
    {
        public void Report(JobProgress value) => report(value);
    }
}
