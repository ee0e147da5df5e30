namespace Engraver.Galil.Jobs.Execution;

/// <summary>How much slower the path has to be when few sent segments are left to execute (a short lead), so that the buffer does not run dry
/// (galil-dmc.md F.1, J 7). It is a factor of VR (<see cref="JobSpeed"/>).</summary>
/// <param name="reactionSeconds">Delay between detecting a short lead and the command reaching the controller.</param>
/// <param name="rampSeconds">Time of the path from full speed to rest: VR acts no faster than VA and VD allow, so it must be sent that much earlier.</param>
internal sealed class FeedThrottle(double rampSeconds, double reactionSeconds)
{
    /// <summary>Below this lead, in segments, the ratio is <see cref="Slow"/>; below the second one <see cref="VerySlow"/>.</summary>
    private const int ShortLead = 20;
    private const int VeryShortLead = 8;

    /// <summary>A lead of this many seconds suffices even with few segments: at 1.6 ms a command more than a hundred can be sent in this time. Much more than
    /// the short lead, so that the speed does not oscillate.</summary>
    private const double ComfortableSeconds = 0.25;

    /// <summary>Of the short lead in seconds, for the time until the lead has been read.</summary>
    private const double WatchMargin = 1.25;

    private const double Full = 1.0;
    private const double Slow = 0.5;
    private const double VerySlow = 0.1;

    /// <summary>With more buffered motion than this, the factor would not change, seconds.</summary>
    public double WatchSeconds => Now == Full ? WatchMargin * ShortSeconds : CalmSeconds;

    private double CalmSeconds => Math.Max(ComfortableSeconds, 2 * ShortSeconds);

    private double ShortSeconds => rampSeconds + reactionSeconds;

    /// <summary>The factor in force.</summary>
    public double Now { get; private set; } = Full;

    /// <summary>Adapts the factor to this lead.</summary>
    /// <param name="lead">Number of segments sent and not yet executed.</param>
    /// <param name="secondsAhead">Their duration at full speed.</param>
    /// <param name="remaining">Number of segments not yet sent.</param>
    /// <returns>Whether it has changed.</returns>
    public bool Adapt(int lead, double secondsAhead, int remaining)
    {
        if (remaining == 0 || secondsAhead > CalmSeconds) return Release();
        if (lead < VeryShortLead || secondsAhead < ShortSeconds / 2) return Change(VerySlow);
        return Now == Full && (lead < ShortLead || secondsAhead < ShortSeconds) && Change(Slow);
    }

    /// <summary>Back to full speed, when everything has been sent.</summary>
    /// <returns>Whether it has changed.</returns>
    public bool Release() => Change(Full);

    private bool Change(double ratio)
    {
        var changes = ratio != Now;
        Now = ratio;
        return changes;
    }
}
