using Engraver.Core.Machines;
using Engraver.Galil.Language;
using Engraver.TestKit;
using Engraver.Workbench.Commands;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Tests.Commands.Trajectories;

/// <summary>Trajectories run as a job by CNCRUN and CNCARM, and at their heights on a mill. The drawing: a line A1, an arc A2, a circle A3 (20,5 radius 3),
/// a square A4.</summary>
public class TrajectoryRunTests
{
    private const double Count = 1.0 / 800.0;

    [Fact]
    public async Task CNCRUN_runs_the_trajectories_instead_of_the_drawing_and_judges_by_what_they_follow()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("SACESETMAXERROR", "0.02", "SACEPATH", "H", "A3", "", "SACEOFFSET", "H", "A4", "", "1", "Out", "CNCCONNECT", "sim:");
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCRUN", "T", "Y"));
        var judged = talk.Session.Machine.Runs.LastRun!.Judgement;

        Assert.Contains("The job cuts 2 trajectories", talk.Said, StringComparison.Ordinal);
        Assert.InRange(judged.MaxDeviationMm!.Value, 0.004, 0.0228); // The error of the spline is visible.
        Assert.Equal(0.0, judged.MissingLengthMm);
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCRUN", "T", "T", "Y")); // And back to the drawing.
        Assert.InRange(talk.Session.Machine.Runs.LastRun!.Judgement.MaxDeviationMm!.Value, 0.0, 0.004);
    }

    [Fact]
    public async Task CNCARM_arms_them_until_they_change_and_START_runs_them()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("SACESETMAXERROR", "0.02", "SACEPATH", "H", "A3", "", "SACEPATH", "H", "A1", "", "CNCCONNECT", "sim:", "CNCARM", "T", "Stream", "SELECT", "ALL", "");
        Assert.NotNull(talk.Session.Machine.Arming.Armed);
        await talk.TypeAsync("SACEDELETELASTTRAJECTORY");
        Assert.Null(talk.Session.Machine.Arming.Armed);

        await talk.TypeAsync("CNCARM", "T", "Stream");
        Assert.IsType<InputResult.Done>(await talk.TypeAsync("CNCRUN"));
        Assert.InRange(talk.Session.Machine.Runs.LastRun!.Judgement.MaxDeviationMm!.Value, 0.004, 0.0228);
        Assert.Equal(0.0, talk.Session.Machine.Runs.LastRun!.Judgement.MissingLengthMm);
        Assert.NotNull(talk.Session.Machine.Runs.ShownJob);
        await talk.TypeAsync("SACEDELETEALLTRAJECTORIES");
        Assert.Null(talk.Session.Machine.Runs.ShownJob);
        Assert.Contains("No trajectories yet", Assert.IsType<InputResult.Failed>(await talk.TypeAsync("CNCARM", "T", "Stream")).Message, StringComparison.Ordinal);
    }

    [Fact]
    public async Task Depths_and_a_helix_are_cut_at_their_heights_by_a_mill()
    {
        await using var talk = Mill();
        await talk.TypeAsync("SACESETMAXERROR", "0.005", "SACEDEEPENGRAVING", "H", "A4", "", "0.5", "1.2", "SACEHELICALDRILL", "20,5", "1.25", "0.25", "1", "0.4", "");
        var result = await talk.TypeAsync("SACESIMULATE");
        var judged = talk.Session.Machine.Runs.LastRun!.Judgement;

        Assert.IsType<InputResult.Done>(result);
        Assert.DoesNotContain("JOB00", talk.Said, StringComparison.Ordinal);
        Assert.InRange(judged.MaxDeviationMm!.Value, 0.0, 0.006 + (2.5 * Count));
        Assert.Equal(0.0, judged.MissingLengthMm);
        Assert.InRange(talk.Session.Machine.Runs.LastRun!.Trace!.Places.Count, 100, 1_000_000);
    }

    [Theory]
    [InlineData("SACEDEEPENGRAVING", "H", "A3", "", "0.5", "1")]
    [InlineData("SACEHELICALDRILL", "20,5", "1.25", "0.25", "1", "0.4", "")]
    public async Task A_depth_that_was_not_cut_is_missing(params string[] commands)
    {
        await using var talk = Mill();
        await talk.TypeAsync(commands);
        var all = talk.State.Sidecar.Trajectories.All;
        var whole = TrajectoryJob.Prepare(talk.State.Drawing!, talk.State.Settings, all, MotionStyle.Continuous).Job;
        var raised = all.Count > 1 ? all.SkipLast(1).ToList() : [all[0] with { Curve = all[0].Curve.Moved(0.1) }];
        var other = TrajectoryJob.Prepare(talk.State.Drawing!, talk.State.Settings, raised, MotionStyle.Continuous).Job;
        var options = new MachineRunOptions(new SimulatedAddress(double.PositiveInfinity), JobMode.Stream.Strategy()) { JournalPath = talk.PathOf("job.jsonl") };
        var report = await MachineRun.RunAsync(whole, other.Motion.Program!, options, TimeProvider.System, progress: null, CancellationToken.None);

        Assert.Equal(JobOutcome.Deviated, report.Result.Outcome);
        Assert.InRange(report.Judgement.MissingLengthMm!.Value, 6.0, 60.0);
    }

    [Fact]
    public async Task A_machine_that_switches_its_tool_says_that_it_has_no_heights()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("SACEDEEPENGRAVING", "H", "A3", "", "0.5", "1", "SACEHELICALDRILL", "20,5", "1.25", "0.25", "1", "0.4", "");

        Assert.IsType<InputResult.Done>(await talk.TypeAsync("SACESIMULATE"));
        Assert.Contains("TRJ0007: The trajectories have heights from -1 to 0 mm", talk.Said, StringComparison.Ordinal);
        Assert.DoesNotContain("JOB00", talk.Said, StringComparison.Ordinal);
        Assert.Equal(0.0, talk.Session.Machine.Runs.LastRun!.Judgement.MissingLengthMm);
    }

    [Fact]
    public async Task Chords_in_space_keep_the_error_that_they_are_given()
    {
        await using var talk = CommandTestSession.WithDrawing();
        await talk.TypeAsync("SACEHELICALDRILL", "20,5", "1.25", "0.25", "1", "0.4", "");
        var curve = talk.State.Sidecar.Trajectories.All[0].Curve;
        foreach (var error in new[] { 1e-2, 1e-4 })
        {
            foreach (var chords in new[] { Core.Trajectories.TrajectoryChords.OfCurve(curve, error), Core.Trajectories.TrajectoryChords.OfSource(curve, error) })
            {
                Assert.Equal((0.0, -1.0), (chords[0].StartZ, chords[^1].EndZ));
                Assert.All(chords.Zip(chords.Skip(1)), pair => Assert.Equal((pair.First.Segment.End, pair.First.EndZ), (pair.Second.Segment.Start, pair.Second.StartZ)));
                Assert.All(chords, chord => Assert.InRange(chord.Segment.PointAt(0.5).DistanceTo(new Core.Geometry.Point2D(20.0, 5.0)), 1.0 - error - curve.VerifiedBound, 1.0 + curve.VerifiedBound));
                Assert.InRange(chords.Count, 4.0 * Math.PI / Math.Sqrt(8.0 * error), curve.Points + (40.0 * Math.PI / Math.Sqrt(8.0 * error)));
            }
        }
    }

    private static CommandTestSession Mill()
    {
        var talk = CommandTestSession.WithDrawing();
        talk.Session.Document.Commit("CNCPROFILE", talk.State with { Settings = talk.State.Settings with { Machine = MachineProfileSource.Load(Path.Combine(RepositoryFolder.Samples, "machine-mill.json")) } });
        return talk;
    }
}
