using Engraver.Core.Machines;
using Engraver.Galil.Jobs;
using Engraver.Galil.Language;
using Engraver.Galil.Sessions;
using Engraver.Galil.Tests.Links;
using Engraver.Links;

namespace Engraver.Galil.Tests.Jobs;

/// <summary>The operator's stop has priority over every present and pending step of a job, however busy this computer is: the job sends nothing after it, and
/// its own commands are sent without waiting.</summary>
public class StopWinsTests
{
    public static TheoryData<JobMode, string> Steps => new()
    {
        { JobMode.Stream, "BG" }, // the rapid
        { JobMode.Stream, "LI " },
        { JobMode.Stream, "VP " },
        { JobMode.Stream, "SB 1" },
        { JobMode.Stream, "BGS" },
        { JobMode.Stream, "MG _BGS," },
        { JobMode.Calls, "x=" },
        { JobMode.Calls, "SB 1" },
        { JobMode.Calls, "go=1" },
        { JobMode.Calls, "r=" },
        { JobMode.Calls, "hb=" },
        { JobMode.Program, "XQ" },
        { JobMode.Program, "HX0" },
        { JobMode.Program, "MG _BGS," },
    };

    [Theory]
    [MemberData(nameof(Steps))]
    public async Task Behind_the_stop_nothing_of_the_job_is_sent_whatever_it_was_about_to_do(JobMode mode, string step)
    {
        await using var bench = new SimulatedBench();
        using var stop = new CancellationTokenSource();
        var (links, behind, braked) = (new List<WithheldLink>(), new List<string>(), false);
        await using var session = await bench.OpenAsync(opened: links.Add);
        links[1].Sending = line => braked |= stop.IsCancellationRequested && line.StartsWith("CSS", StringComparison.Ordinal);
        links[0].Sending = line =>
        {
            if (stop.IsCancellationRequested && !braked) behind.Add(line);
            if (line.StartsWith(step, StringComparison.Ordinal)) stop.Cancel(); // it is sent already
        };

        var result = await JobRunner.RunAsync(MotionPrograms.Paper, session, SimulatedBench.Job with { Strategy = mode.Strategy() }, null, stop.Token);

        Assert.Equal((JobOutcome.Stopped, true), (result.Outcome, braked));
        Assert.Empty(behind);
        Assert.Equal((0, 0, false), (bench.Controller.Status.Outputs, bench.Controller.Status.RunningThreads, bench.Controller.Status.IsMoving));
    }

    [Theory]
    [InlineData(JobMode.Stream)]
    [InlineData(JobMode.Calls)]
    [InlineData(JobMode.Program)]
    public async Task With_no_thread_to_take_its_answers_the_stop_has_said_everything(JobMode mode)
    {
        await using var bench = new SimulatedBench();
        using var stop = new CancellationTokenSource();
        var (links, said) = (new List<WithheldLink>(), new List<string>());
        await using var session = await bench.OpenAsync(opened: links.Add);
        (bool Moves, int Outputs) behind = (true, 1);
        var press = new CancelWhen(progress => progress.X > 50000, () =>
        {
            links[1].Sending = said.Add;
            links[1].Withhold(); // the thread that would take the reply is blocked: only the bytes that are sent at once are sent
            links[0].Withhold();
            stop.Cancel();
            bench.Controller.AdvanceUntil(status => !status.IsMoving, TimeSpan.FromSeconds(0.5));
            behind = (bench.Controller.Status.IsMoving, bench.Controller.Status.Outputs);
        });
        var running = JobRunner.RunAsync(MotionPrograms.LongLine(200000), session, SimulatedBench.Job with { Strategy = mode.Strategy() }, press, stop.Token);
        await links[1].HasWaiter;
        while (!running.IsCompleted)
        {
            bench.Controller.Advance(TimeSpan.FromSeconds(1)); // both handles count as lost
            await Task.Yield();
        }

        Assert.Equal((false, 0), behind);
        Assert.Equal("CB 1;STS;ST AB;HX0\r", Assert.Single(said));
    }

    /// <summary>A job that waits between two polls is also woken by the stop: it must not unwind, by exceptions and with the stop's own registration, before
    /// the stop is sent.</summary>
    [Theory]
    [InlineData(JobMode.Stream)]
    [InlineData(JobMode.Calls)]
    [InlineData(JobMode.Program)]
    public async Task In_a_pause_of_the_job_the_stop_is_said_first_and_in_one_line(JobMode mode)
    {
        await using var bench = new SimulatedBench();
        using var stop = new CancellationTokenSource();
        var (links, said, time) = (new List<WithheldLink>(), new List<string>(), new PausingTimeProvider(bench.Clock));
        await using var session = await ControllerSession.OpenAsync(
            _ =>
            {
                links.Add(new WithheldLink(new StreamLink(bench.Controller.OpenConnection(), "memory")));
                return Task.FromResult<IControllerLink>(links[^1]);
            },
            new SessionOptions(), time, CancellationToken.None);
        var running = JobRunner.RunAsync(MotionPrograms.LongLine(200000), session, SimulatedBench.Job with { Strategy = mode.Strategy() }, new CancelWhen(progress => progress.X > 50000, time.Pause), stop.Token);
        await time.Paused;
        links[1].Sending = said.Add;

        time.Resume();
        var key = new Thread(stop.Cancel); // like the desktop's: continuations can run on it at once
        key.Start();
        key.Join();
        var result = await running;

        Assert.Equal(JobOutcome.Stopped, result.Outcome);
        Assert.Equal("CB 1;STS;ST AB;HX0\r", said[0]);
    }

    /// <summary>A clock whose next pause does not end.</summary>
    private sealed class PausingTimeProvider(TimeProvider inner) : TimeProvider
    {
        private readonly TaskCompletionSource _paused = new(TaskCreationOptions.RunContinuationsAsynchronously);
        private volatile bool _isPausing;

        public Task Paused => _paused.Task;

        public override long TimestampFrequency => inner.TimestampFrequency;

        public void Pause() => _isPausing = true;

        public void Resume() => _isPausing = false;

        public override DateTimeOffset GetUtcNow() => inner.GetUtcNow();

        public override long GetTimestamp() => inner.GetTimestamp();

        public override ITimer CreateTimer(TimerCallback callback, object? state, TimeSpan dueTime, TimeSpan period)
        {
            if (!_isPausing) return inner.CreateTimer(callback, state, dueTime, period);
            _paused.TrySetResult();
            return inner.CreateTimer(callback, state, Timeout.InfiniteTimeSpan, period);
        }
    }
}
