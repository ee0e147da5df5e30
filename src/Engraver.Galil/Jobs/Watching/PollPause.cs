namespace Engraver.Galil.Jobs.Watching;

/// <summary>The pauses between the polls of one wait: while what is waited for cannot have come yet, and where it does not come for long; else it is asked at once again, so that its end is seen at once.</summary>
/// <param name="interval">The longest pause: so often the job is looked at in any case. Zero: no pause at all.</param>
/// <param name="atLeastSeconds">How long the wait takes at the least; zero when nothing is known.</param>
internal sealed class PollPause(TimeSpan interval, double atLeastSeconds)
{
    /// <summary>Polls without a pause after which the wait is a long one.</summary>
    private const int PollsInARow = 50;

    /// <summary>So much sooner the polling begins, seconds: a poll takes its time, and the motion began before the wait did.</summary>
    private const double Margin = 0.004;

    private int _inARow;

    /// <summary>The pause behind a poll that saw no end yet, seconds.</summary>
    /// <param name="elapsed">Since the wait began, seconds.</param>
    public double Next(double elapsed)
    {
        var early = atLeastSeconds - Margin - elapsed;
        if (early > 0.0) return Math.Min(early, interval.TotalSeconds);
        return ++_inARow > PollsInARow ? interval.TotalSeconds : 0.0;
    }
}
