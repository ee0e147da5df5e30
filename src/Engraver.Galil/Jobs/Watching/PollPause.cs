namespace Engraver.Galil.Jobs.Watching;

/// <summary>Pauses between the polls of one wait: long ones while its end cannot have come yet, and when it has not come for a long time; otherwise none,
/// so that the end is seen at once.</summary>
/// <param name="interval">The longest pause; zero for no pauses.</param>
/// <param name="atLeastSeconds">Shortest possible time of the wait; zero when nothing is known.</param>
internal sealed class PollPause(TimeSpan interval, double atLeastSeconds)
{
    /// <summary>Polls without a pause after which the wait is a long one.</summary>
    private const int PollsInARow = 50;

    /// <summary>Polling begins this much earlier, seconds: a poll takes time, and the motion began before the wait did.</summary>
    private const double Margin = 0.004;

    private int _inARow;

    /// <summary>The pause after a poll that did not see the end, seconds.</summary>
    /// <param name="elapsed">Since the wait began, seconds.</param>
    public double Next(double elapsed)
    {
        var early = atLeastSeconds - Margin - elapsed;
        if (early > 0.0) return Math.Min(early, interval.TotalSeconds);
        return ++_inARow > PollsInARow ? interval.TotalSeconds : 0.0;
    }
}
