using System.Globalization;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;
using Engraver.Galil.Language;
using Engraver.TestKit;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Files;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Tests.Machines.Runs;

/// <summary>A run is replayed from its journal and moves identically, sample for sample: actions of the operator are part of the conversation. Events at the
/// machine are not, and the replay differs from there on.</summary>
public sealed class ReplayTests : IDisposable
{
    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("engraver-replay-");

    private string Journal => Path.Combine(_folder.FullName, "run.jsonl");

    public void Dispose() => _folder.Delete(recursive: true);

    [Theory]
    [InlineData(JobMode.Stream)]
    [InlineData(JobMode.Calls)]
    [InlineData(JobMode.Program)]
    public async Task A_run_that_was_slowed_held_and_let_go_on_moves_as_it_did(JobMode mode)
    {
        var (control, held) = (new JobControl(), false);
        var (report, record) = await RunAsync(mode, control, told =>
        {
            if (told.Seconds > 0.2) control.FeedRatio = 0.5;
            if (told.Seconds > 0.4 && !held) control.Hold();
            if (told.Phase != JobPhase.Held) return;
            held = true;
            control.Resume();
        });
        await using var replay = await ReplayAsync();

        Assert.Equal((JobOutcome.Complete, 1), (report.Result.Outcome, report.Result.Holds));
        Assert.Equal(record, Samples(replay));
        Assert.True(replay.CompareWith(new StringReader(record)).IsSame);
        Assert.Equal((true, true, 0.0), (replay.EndsAsJournalled, replay.Conversation.IsWhole, replay.LateSeconds));
    }

    [Theory]
    [InlineData(JobMode.Stream)]
    [InlineData(JobMode.Calls)]
    [InlineData(JobMode.Program)]
    public async Task A_run_that_the_operator_stopped_stops_where_it_did(JobMode mode)
    {
        using var stop = new CancellationTokenSource();
        var (report, record) = await RunAsync(
            mode,
            new JobControl(),
            told =>
            {
                if (told.Seconds > 0.5) stop.Cancel();
            },
            stop: stop.Token);
        await using var replay = await ReplayAsync();

        Assert.Equal(JobOutcome.Stopped, report.Result.Outcome);
        Assert.Equal(record, Samples(replay));
        Assert.Equal((report.Result.FinalPosition!.Value.X, report.Result.FinalPosition.Value.Y, true), (replay.FinalPosition!.Value.X, replay.FinalPosition.Value.Y, replay.EndsAsJournalled));
    }

    /// <summary>Regression: after a stop from another thread in real time, the replay ended more than a millimetre away. Commands take no time there, and the
    /// stop has the time at which the controller received it.</summary>
    [Theory]
    [InlineData(JobMode.Stream)]
    [InlineData(JobMode.Program)]
    public async Task A_run_in_real_time_that_is_stopped_from_elsewhere_moves_as_it_did(JobMode mode)
    {
        using var stop = new CancellationTokenSource();
        await using var connection = MachineConnection.To(new SimulatedAddress(1.0), TimeProvider.System, keepsRecord: true);
        var stopping = connection.Simulator!.WaitUntilAsync(status => status is { IsMoving: true, SegmentsExecuted: >= 2 }, CancellationToken.None).ContinueWith(_ => stop.Cancel(), TaskScheduler.Default);
        var (report, record) = await RunAsync(mode, new JobControl(), _ => { }, connection: connection, stop: stop.Token);
        await stopping;
        await using var replay = await ReplayAsync();

        Assert.Equal(JobOutcome.Stopped, report.Result.Outcome);
        Assert.True(record.Split('\n').Length > 200);
        Assert.Equal(record, Samples(replay));
        Assert.Equal((true, 0.0), (replay.EndsAsJournalled, replay.LateSeconds));
    }

    /// <summary>An active switch is an event of the machine and not part of the conversation.</summary>
    [Fact]
    public async Task Where_the_machine_itself_failed_it_is_the_same_up_to_there()
    {
        await using var connection = Simulated();
        var hitAt = 0L;
        var (report, record) = await RunAsync(
            JobMode.Stream,
            new JobControl(),
            told =>
            {
                if (told.Seconds < 0.5 || hitAt > 0) return;
                hitAt = connection.Simulator!.Status.Sample;
                connection.Simulator.SetLimitSwitch(0, forward: true, active: true);
            },
            connection: connection);
        await using var replay = await ReplayAsync();
        var (there, here) = (record.Split('\n'), Samples(replay).Split('\n'));
        var before = there.TakeWhile(row => row[0] == 't' || SampleOf(row) <= hitAt).Count();

        Assert.NotEqual(JobOutcome.Complete, report.Result.Outcome);
        Assert.InRange(before, 200, there.Length - 1);
        Assert.Equal(there.Take(before), here.Take(before));
        Assert.False(replay.CompareWith(new StringReader(record)).IsSame);
    }

    [Fact]
    public async Task A_host_that_died_is_followed_to_its_last_word_and_then_the_watchdog_stops_the_machine()
    {
        var (_, record) = await RunAsync(JobMode.Stream, new JobControl(), _ => { });
        string[] lines;
        using (var kept = CompressedText.Open(ConversationFile.PathOf(Journal))) lines = (await kept.ReadToEndAsync()).TrimEnd('\n').Split('\n');
        var last = Array.FindIndex(lines, line => line[0] != '#' && long.Parse(line.Split(' ')[0], CultureInfo.InvariantCulture) > 6_000_000);
        await File.WriteAllTextAsync(ConversationFile.PathOf(Journal), string.Join('\n', lines.Take(last)) + "\n6000000 0 > torn");
        File.WriteAllLines(Journal, (await File.ReadAllLinesAsync(Journal)).Where(line => !line.Contains("\"kind\":\"end\"", StringComparison.Ordinal)));
        await using var replay = await ReplayAsync();
        var (there, here) = (record.Split('\n'), Samples(replay).Split('\n'));

        Assert.False(replay.Conversation.IsWhole);
        Assert.Null(replay.EndsAsJournalled);
        Assert.Equal(there.Take(400), here.Take(400));
        Assert.EndsWith(",0", here[^2], StringComparison.Ordinal);
        Assert.InRange(replay.Seconds, 0.6, 3.0);
    }

    [Fact]
    public async Task A_machine_that_had_moved_before_begins_where_the_journal_says()
    {
        await using var connection = Simulated();
        await RunAsync(JobMode.Stream, new JobControl(), _ => { }, connection: connection, settings: new DrawingSettings { Finish = FinishPlace.Stay });
        var first = connection.Simulator!.Record.Count;
        File.Delete(Journal);
        var (report, record) = await RunAsync(JobMode.Stream, new JobControl(), _ => { }, connection: connection, origin: new OriginRequest.PresentPosition());
        await using var replay = await ReplayAsync();

        Assert.Equal(JobOutcome.Complete, report.Result.Outcome);
        string[] there = [.. record.Split('\n').Skip(1 + first)];
        string[] here = [.. Samples(replay).Split('\n').SkipWhile(row => row != there[0])];
        Assert.True(there.Length > 1000);
        Assert.Equal(there, here);
    }

    [Fact]
    public async Task What_is_lacking_is_said()
    {
        await RunAsync(JobMode.Stream, new JobControl(), _ => { });
        var wire = ConversationFile.PathOf(Journal);
        var kept = await File.ReadAllTextAsync(wire);
        File.Delete(wire);
        var (none, lack) = await IncidentReplay.RunAsync(Journal, wire, CancellationToken.None);
        await File.WriteAllTextAsync(wire, "something else\n" + kept);
        var (_, unreadable) = await IncidentReplay.RunAsync(Journal, wire, CancellationToken.None);
        var (_, gone) = await IncidentReplay.RunAsync(Journal + "x", wire, CancellationToken.None);

        Assert.Null(none);
        Assert.Contains("does not contain the commands sent to the controller", lack, StringComparison.Ordinal);
        Assert.Contains("line 1", unreadable, StringComparison.Ordinal);
        Assert.NotNull(gone);
    }

    private static MachineConnection Simulated() => MachineConnection.To(new SimulatedAddress(double.PositiveInfinity), TimeProvider.System, keepsRecord: true);

    private static long SampleOf(string row) => row.Length == 0 ? long.MaxValue : (long)Math.Round(double.Parse(row.Split(',')[0], CultureInfo.InvariantCulture) * 1000.0);

    private async Task<(MachineRunReport Report, string Record)> RunAsync(JobMode mode, JobControl control, Action<JobProgress> heard, MachineConnection? connection = null, DrawingSettings? settings = null, OriginRequest? origin = null, CancellationToken stop = default)
    {
        await using var own = connection is null ? Simulated() : null;
        var machine = connection ?? own!;
        var job = JobPreparation.Prepare(new DrawingBuilder().Square(2, 3, 4).Circle(12, 5, 2).Line(15, 0, 18, 1).Line(18, 1, 19, 1.2).Build(), settings ?? new DrawingSettings(), mode.Strategy().Style);
        var options = new MachineRunOptions(new SimulatedAddress(double.PositiveInfinity), mode.Strategy()) { JournalPath = Journal, Control = control, Finish = job.Settings.Finish, Origin = origin ?? new OriginRequest.ActiveOrigin() };
        var report = await MachineRun.RunAsync(job, job.Motion.Program!, machine, options, TimeProvider.System, new ProgressCallback(heard), stop);
        using var record = new StringWriter();
        machine.Simulator!.Record.WriteCsv(record);
        return (report, record.ToString());
    }

    private async Task<IncidentReplay> ReplayAsync()
    {
        var (replay, lack) = await IncidentReplay.RunAsync(Journal, ConversationFile.PathOf(Journal), CancellationToken.None);
        Assert.Null(lack);
        return replay!;
    }

    private static string Samples(IncidentReplay replay)
    {
        using var record = new StringWriter();
        replay.WriteRecord(record);
        return record.ToString();
    }

    /// <summary>On the thread of the job, so that the action occurs at the same time.</summary>
    private sealed class ProgressCallback(Action<JobProgress> told) : IProgress<JobProgress>
    {
        public void Report(JobProgress value) => told(value);
    }
}
