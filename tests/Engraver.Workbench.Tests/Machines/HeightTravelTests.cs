using System.Globalization;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Galil.Language;
using Engraver.TestKit;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Tests.Commands;

namespace Engraver.Workbench.Tests.Machines;

/// <summary>The travel of the tool axis: a cut 2.5 mm deep under a clearance of 4 mm reaches from -2.5 to 4 mm over the work, a dry run of it from 4 to 10.5
/// mm.</summary>
public sealed class HeightTravelTests
{
    [Fact]
    public async Task A_job_that_is_too_deep_at_the_height_of_the_work_is_not_armed_and_not_run()
    {
        await using var talk = await ConnectedAsync("-2", "20");
        await talk.TypeAsync("CNCZERO", "All");

        Assert.Equal(CommandFailure.Refused, Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCARM", "Stream")).Reason);
        Assert.Contains(talk.Said.Split('\n'), line => line.StartsWith("NOT OK The job would take the tool's axis Z to -2.5 mm; its travel is -2 to 20 mm. ", StringComparison.Ordinal) && line.Contains("CNCZERO", StringComparison.Ordinal));
        Assert.Equal(CommandFailure.Refused, Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCRUN", "Yes")).Reason);
        Assert.Contains("JOB0033", talk.Said, StringComparison.Ordinal);
        Assert.DoesNotContain("inside the travel", talk.Said, StringComparison.Ordinal);
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCARM", "Dryrun", "Stream")); // It does not reach that depth.
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCRUN"));
        await talk.TypeAsync("CNCZERO", "Z", "Yes"); // 4 mm higher now, where the run has left the tool
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCARM", "Stream"));
        Assert.Contains("ok     The placed job is inside the travel of the machine.", talk.Said, StringComparison.Ordinal);
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCRUN"));
    }

    [Fact]
    public async Task A_dry_run_and_a_frame_that_would_go_too_high_are_refused_and_the_job_itself_is_not()
    {
        await using var talk = await ConnectedAsync("-5", "10");
        await talk.TypeAsync("CNCZERO", "All");

        Assert.Equal(CommandFailure.Refused, Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCARM", "Dryrun", "Stream")).Reason);
        Assert.Contains(talk.Said.Split('\n'), line => line.StartsWith("NOT OK A dry run and a frame run 6.5 mm higher than the job. This would take the tool's axis Z to 10.5 mm; its travel is -5 to 10 mm. ", StringComparison.Ordinal));
        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCRUN", "Dryrun", "Yes"));
        foreach (var shape in Enum.GetNames<FrameShape>()) Assert.Equal(CommandFailure.Refused, Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCFRAME", shape)).Reason);
        Assert.Equal(3, talk.Said.Split("JOB0034").Length - 1);
        Assert.Equal((0.0, 0.0), (talk.Session.Machine.Status.MachinePosition!.Value.X, talk.Session.Machine.Status.MachineHeight));
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCARM", "Stream"));
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCRUN"));
        Assert.Equal(JobOutcome.Complete, talk.Session.Machine.Runs.LastRun!.Result.Outcome);
    }

    [Fact]
    public async Task A_step_and_a_raised_way_that_would_leave_the_travel_of_the_tool_are_refused_before_a_byte_of_motion()
    {
        await using var talk = await ConnectedAsync("-3", "10");
        await talk.TypeAsync("CNCJOG", "Z+", "7", "CNCZERO", "All");

        Assert.Contains("axis Z to 11 mm; its travel is -3 to 10 mm", Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCGOTO", "3,4")).Message, StringComparison.Ordinal);
        Assert.Contains("axis Z to 11 mm; its travel is -3 to 10 mm", Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCGOTO", "Clearance")).Message, StringComparison.Ordinal);
        Assert.Contains("axis Z to -4 mm; its travel is -3 to 10 mm", Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCJOG", "Z-", "11")).Message, StringComparison.Ordinal);
        Assert.Equal((0.0, 7.0), (talk.Session.Machine.Status.MachinePosition!.Value.X, talk.Session.Machine.Status.MachineHeight));
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCJOG", "Z+", "3"));
        Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCGOTO", "3,4")); // still a millimetre under the clearance over the work
    }

    /// <summary>The forecast matches the motion of the motors.</summary>
    [Theory]
    [InlineData(JobMode.Stream, false)]
    [InlineData(JobMode.Stream, true)]
    [InlineData(JobMode.Calls, false)]
    [InlineData(JobMode.Calls, true)]
    [InlineData(JobMode.Program, false)]
    [InlineData(JobMode.Program, true)]
    public async Task The_heights_that_are_checked_are_those_that_the_run_reaches(JobMode mode, bool dryRun)
    {
        await using var bench = await MachineBench.ConnectedAsync();
        var folder = Directory.CreateTempSubdirectory("engraver-heights-");
        var file = Path.Combine(folder.FullName, "mill.json");
        await File.WriteAllTextAsync(file, Mill("-50", "50"), bench.Limit);
        var mill = bench.Machine.Profile = MachineProfileSource.Load(file);
        await bench.Machine.Origins.SetAsync((memory, _) => memory.WithOrigin("G54", 0, 0, 1600), bench.Limit);
        var job = JobPreparation.Prepare(new DrawingBuilder().Line(5, 0, 20, 0).Circle(40, 0, 5).Build(), new DrawingSettings { Machine = mill }, mode.Strategy().Style);
        var before = bench.Controller.Record.Snapshot().Count;

        var report = await bench.Machine.Runs.RunAsync(job, job.Motion.Program!, address => new MachineRunOptions(address, mode.Strategy()) { JournalPath = Path.Combine(folder.FullName, "job.jsonl"), DryRun = dryRun }, bench.Limit);

        Assert.True(report.Result.Outcome == JobOutcome.Complete, report.Result.Message);
        var heights = MotionExtents.Of(job.Motion.Program!).Heights(mill, dryRun)!.Value;
        var reached = bench.Controller.Record.Snapshot().Skip(before).SkipWhile(sample => sample.A == 0).Select(sample => (long)sample.C).ToList();
        Assert.Equal((heights.Min + 1600, heights.Max + 1600), (reached.Min(), reached.Max()));
        folder.Delete(recursive: true);
    }

    private static string Mill(string least, string most) => File.ReadAllText(Path.Combine(RepositoryFolder.Samples, "machine-mill.json"))
        .Replace("\"cutDepth\": 0", string.Create(CultureInfo.InvariantCulture, $"\"cutDepth\": 2.5, \"travelZ\": {{ \"min\": {least}, \"max\": {most} }}"), StringComparison.Ordinal);

    private static async Task<CommandTestSession> ConnectedAsync(string least, string most)
    {
        var talk = new CommandTestSession();
        await File.WriteAllTextAsync(talk.PathOf("mill.json"), Mill(least, most));
        await talk.TypeAsync("OPEN", CommandTestSession.Sample("paper-001.dxf"), "CNCPROFILE", talk.PathOf("mill.json"), "CNCCONNECT", "sim:?speed=max", "CNCMOTORS", "ON");
        return talk;
    }
}
