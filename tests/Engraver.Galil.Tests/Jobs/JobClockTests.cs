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
}
