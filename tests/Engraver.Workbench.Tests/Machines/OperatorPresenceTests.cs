using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Workbench.Machines;

namespace Engraver.Workbench.Tests.Machines;

/// <summary>A continuous jog requires signals from the front end. The session uses the clock of the test, the simulated machine its own.</summary>
public sealed class OperatorPresenceTests : IDisposable
{
    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("engraver-presence-");

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public async Task A_jog_of_which_no_sign_is_heard_is_braked_and_one_with_signs_goes_on(bool staysReady)
    {
        await using var bench = await MachineBench.ConnectedAsync();
        using var jog = bench.Machine.Hand.Presence.BeginJog(new JogVelocity(600, 0));
        var jogging = await JoggingAsync(bench, jog, staysReady);

        for (var beat = 0; beat < 40; beat++)
        {
            bench.Time.Advance(OperatorPresence.SignInterval);
            bench.Machine.Hand.Presence.Sign();
        }

        bench.Time.Advance(TimeSpan.FromMilliseconds(290));
        Assert.Equal((false, false), (jog.IsReleased, jogging.IsCompleted));
        bench.Time.Advance(TimeSpan.FromMilliseconds(20));

        Assert.True(jog.IsReleased);
        Assert.True(await jog.Abandoned);
        Assert.Equal(JobOutcome.Complete, (await jogging.WaitAsync(bench.Limit)).Outcome);
        await bench.Controller.WaitUntilAsync(status => !status.IsMoving, bench.Limit);
    }

    [Fact]
    public async Task An_operator_who_leaves_releases_every_jog_at_once_and_a_released_jog_is_not_lost()
    {
        await using var bench = await MachineBench.ConnectedAsync();
        using var jog = bench.Machine.Hand.Presence.BeginJog(new JogVelocity(0, -600));
        var jogging = await JoggingAsync(bench, jog, staysReady: false);

        bench.Machine.Hand.Presence.ReleaseAll();

        Assert.True(jog.IsReleased);
        Assert.False(await jog.Abandoned);
        Assert.Equal(JobOutcome.Complete, (await jogging.WaitAsync(bench.Limit)).Outcome);
        using var other = bench.Machine.Hand.Presence.BeginJog(new JogVelocity(0, 600));
        other.Release();
        bench.Machine.Hand.Presence.ReleaseAll();
        bench.Time.Advance(TimeSpan.FromSeconds(2));
        Assert.False(other.Abandoned.IsCompleted);
    }

    /// <summary>Also before the machine moves: a waiting jog does not start after the operator has left.</summary>
    [Fact]
    public async Task Signs_are_needed_from_the_press_on_and_no_longer_than_the_jog()
    {
        await using var bench = await MachineBench.ConnectedAsync();
        var told = new List<bool>();
        bench.Machine.Changed += (_, _) => told.Add(bench.Machine.Hand.Presence.IsNeeded);
        using (var jog = bench.Machine.Hand.Presence.BeginJog(new JogVelocity(600, 0)))
        {
            Assert.True(bench.Machine.Hand.Presence.IsNeeded);
            bench.Time.Advance(TimeSpan.FromMilliseconds(350));
            Assert.True(jog.IsReleased);
            var result = await bench.Machine.Hand.JogAsync(jog, Path.Combine(_folder.FullName, "jog.jsonl"), bench.Limit).WaitAsync(bench.Limit);
            Assert.DoesNotContain(bench.Controller.Record.Snapshot(), sample => sample.A != 0);
            Assert.NotEqual(JobOutcome.LinkLost, result.Outcome);
        }

        Assert.False(bench.Machine.Hand.Presence.IsNeeded);
        Assert.Equal((true, false), (told[0], told[^1]));
    }

    /// <summary>A delayed check does not show which side was delayed: it checks again.</summary>
    [Fact]
    public async Task When_this_program_was_held_up_as_a_whole_the_sign_behind_it_counts()
    {
        var time = new SteppedTimeProvider();
        var presence = new OperatorPresence(time, () => { });
        using var jog = presence.BeginJog(new JogVelocity(600, 0));

        time.Advance(TimeSpan.FromSeconds(1));
        presence.Sign();
        time.Advance(OperatorPresence.SignInterval);
        Assert.False(jog.IsReleased);
        for (var look = 0; look < 6; look++) time.Advance(OperatorPresence.SignInterval);
        Assert.True(await jog.Abandoned.WaitAsync(TimeSpan.FromSeconds(60)));
    }

    public void Dispose() => _folder.Delete(recursive: true);

    /// <returns>Time at which it moves.</returns>
    private async Task<Task<JobResult>> JoggingAsync(MachineBench bench, ContinuousJog jog, bool staysReady)
    {
        var journal = Path.Combine(_folder.FullName, "jog.jsonl");
        var jogging = staysReady ? bench.Machine.ReadyJogs.JogAsync(jog, journal) : bench.Machine.Hand.JogAsync(jog, journal, bench.Limit);
        await bench.Controller.WaitUntilAsync(status => status.IsMoving, bench.Limit);
        return jogging;
    }

    /// <summary>A clock whose single timer fires once, regardless of its delay.</summary>
    private sealed class SteppedTimeProvider : TimeProvider
    {
        private TimerCallback _callback = _ => { };
        private long _now;

        public override long TimestampFrequency => TimeSpan.TicksPerSecond;

        public override long GetTimestamp() => _now;

        public override ITimer CreateTimer(TimerCallback callback, object? state, TimeSpan dueTime, TimeSpan period)
        {
            _callback = callback;
            return new Timer(_ => { }, null, Timeout.InfiniteTimeSpan, Timeout.InfiniteTimeSpan);
        }

        public void Advance(TimeSpan time)
        {
            _now += time.Ticks;
            _callback(null);
        }
    }
}
