using Engraver.Core.Machines;
using Engraver.Galil.Jobs;
using Engraver.Galil.Programs.Resident;
using Engraver.TestKit;

namespace Engraver.Galil.Tests.Jobs;

/// <summary>Heartbeats beside a job that this computer delays: the watchdog does not trip, and a job that hangs does not keep the machine in motion.</summary>
public class HeartbeatKeeperTests
{
    private readonly ManualTimeProvider _time = new();

    [Fact]
    public void A_job_that_is_late_gets_heartbeats_for_five_seconds()
    {
        var heartbeat = new Heartbeat(_time);

        var beats = BeatsOf(heartbeat, TimeSpan.FromSeconds(20), acts: false);

        Assert.InRange(beats[0], 300.0, 500.0);
        Assert.All(beats.Zip(beats.Skip(1)), pair => Assert.InRange(pair.Second - pair.First, 300.0, 500.0));
        Assert.InRange(beats[^1], 4500.0, 5000.0);
    }

    [Fact]
    public void A_job_that_sends_its_own_heartbeats_gets_none() => Assert.Empty(BeatsOf(new Heartbeat(_time), TimeSpan.FromSeconds(20), acts: true));

    [Fact]
    public void Motion_that_lasts_as_long_as_a_key_is_held_gets_none() => Assert.Empty(BeatsOf(Heartbeat.Close(_time), TimeSpan.FromSeconds(20), acts: false));

    [Fact]
    public async Task It_beats_ten_times_a_second_while_it_is_due_and_ends_with_the_job()
    {
        using var beats = new SemaphoreSlim(0);
        var keeper = new HeartbeatKeeper(_time, () => true, () =>
        {
            beats.Release();
            return ValueTask.CompletedTask;
        });
        for (var i = 0; i < 3; i++)
        {
            _time.Advance(TimeSpan.FromMilliseconds(100));
            Assert.True(await beats.WaitAsync(TimeSpan.FromSeconds(60)));
        }

        await keeper.DisposeAsync();
        _time.Advance(TimeSpan.FromSeconds(10));

        Assert.Equal(0, beats.CurrentCount);
        keeper.ThrowIfFailed();
    }

    [Fact]
    public async Task A_heartbeat_that_fails_ends_the_job_at_its_next_command()
    {
        var keeper = new HeartbeatKeeper(_time, () => true, () => throw new ControllerLinkException("cut"));
        _time.Advance(TimeSpan.FromMilliseconds(100));

        await keeper.DisposeAsync();

        Assert.Equal("cut", Assert.Throws<ControllerLinkException>(keeper.ThrowIfFailed).Message);
    }

    /// <summary>Milliseconds of the heartbeats beside a job, asked ten times a second.</summary>
    /// <param name="acts">The job sends its own.</param>
    private List<double> BeatsOf(Heartbeat heartbeat, TimeSpan during, bool acts)
    {
        var (beats, start) = (new List<double>(), _time.GetTimestamp());
        while (_time.GetElapsedTime(start) < during)
        {
            _time.Advance(TimeSpan.FromMilliseconds(100));
            if (acts) heartbeat.IsDue();
            if (heartbeat.IsDueBeside()) beats.Add(_time.GetElapsedTime(start).TotalMilliseconds);
        }

        return beats;
    }
}
