using Engraver.Galil.Jobs;
using Engraver.TestKit;

namespace Engraver.Galil.Tests.Jobs;

public class JobClockTests
{
    [Theory]
    [InlineData(1.0, 0, 0, false)] // a real controller
    [InlineData(1.0, 900, 0, false)] // its first answer was held up: the second seems to come at once
    [InlineData(1.0, 0, 900, false)]
    [InlineData(20.0, 0, 0, true)]
    [InlineData(20.0, 100, 100, true)]
    public void Only_a_controller_whose_time_is_proved_to_run_ahead_is_polled_without_a_pause(double speed, int firstHeldUp, int secondHeldUp, bool ahead)
    {
        var time = new ManualTimeProvider();
        var clock = new JobClock(time, 0.001, TimeSpan.FromMilliseconds(50));
        var start = time.GetTimestamp();
        foreach (var (pause, heldUp) in new[] { (500, firstHeldUp), (50, secondHeldUp) })
        {
            time.Advance(TimeSpan.FromMilliseconds(pause));
            clock.Asks();
            var sample = (long)(time.GetElapsedTime(start).TotalMilliseconds * speed);
            time.Advance(TimeSpan.FromMilliseconds(heldUp));
            clock.Polled(sample);
        }

        Assert.Equal(ahead, clock.RunsAhead);
        Assert.Equal((50 + firstHeldUp) * speed / 1000, clock.Seconds, 9);
    }

    [Fact]
    public void The_count_of_the_first_poll_is_no_time_that_passed()
    {
        var time = new ManualTimeProvider();
        var clock = new JobClock(time, 0.001, TimeSpan.FromMilliseconds(50));
        clock.Asks();
        clock.Polled(1_000_000);

        Assert.False(clock.RunsAhead);
        Assert.Equal(0.0, clock.Seconds);
    }

    [Theory]
    [InlineData(1.6, 0.3, true)] // virtual time: each question costs 1.6 ms of it, whatever the wall says
    [InlineData(1.6, 1.7, false)]
    [InlineData(25.0, 25.0, false)] // a real controller on a slow wire
    public async Task Polls_in_a_row_show_a_clock_that_only_counts_commands(double samplesPerPoll, double milliseconds, bool ahead)
    {
        var time = new ManualTimeProvider();
        var clock = new JobClock(time, 0.001, TimeSpan.FromMilliseconds(10));
        var samples = 0.0;
        for (var poll = 0; poll < 30; poll++)
        {
            clock.Asks();
            time.Advance(TimeSpan.FromMilliseconds(milliseconds));
            clock.Polled((long)(samples += samplesPerPoll));
            Assert.True(clock.PauseAsync(CancellationToken.None).AsTask().IsCompletedSuccessfully);
        }

        Assert.Equal(ahead, clock.RunsAhead);
    }

    [Fact]
    public async Task A_busy_start_hides_it_only_until_the_next_row()
    {
        var time = new ManualTimeProvider();
        var clock = new JobClock(time, 0.001, TimeSpan.FromMilliseconds(10));
        var (samples, pauses) = (0.0, 0);
        for (var poll = 0; poll < 250 && !clock.RunsAhead; poll++)
        {
            clock.Asks();
            time.Advance(TimeSpan.FromMilliseconds(poll < 40 ? 5.0 : 0.3));
            clock.Polled((long)(samples += 1.6));
            var pause = clock.PauseAsync(CancellationToken.None).AsTask();
            if (pause.IsCompleted) continue;
            pauses++;
            time.Advance(TimeSpan.FromMilliseconds(10));
            samples += 10.0;
            await pause;
        }

        Assert.True(clock.RunsAhead);
        Assert.Equal(150, pauses);
    }
}
