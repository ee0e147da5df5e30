namespace Engraver.Galil.Jobs.Execution;

/// <summary>Says how much slower the path has to be when few sent segments are left to execute (a short lead), instead of letting the buffer run dry
/// (galil-dmc.md F.1, J 7). <see cref="SpeedRatio"/> makes VR of it.</summary>
/// <param name="reactionSeconds">Delay between detecting a short lead and the command reaching the controller.</param>
/// <param name="rampSeconds">Time of the path from full speed to rest: VR acts no faster than VA and VD allow, so it must be sent that much earlier.</param>
internal sealed class FeedThrottle(double rampSeconds, double reactionSeconds)
{
    /// <summary>Below this lead, in segments, the ratio is <see cref="Slow"/>; below the second one <see cref="VerySlow"/>.</summary>
    private const int ShortLead = 20;
    private const int VeryShortLead = 8;

    /// <summary>A lead of this many seconds suffices even with few segments: at 1.6 ms a command more than a hundred can be sent meanwhile. Much more than
    /// the short lead, so that the speed does not oscillate.</summary>
    private const double ComfortableSeconds = 0.25;

    private const double Full = 1.0;
    private const double Slow = 0.5;
    private const double VerySlow = 0.1;

    private double _now = Full;

    private double ShortSeconds => rampSeconds + reactionSeconds;

    /// <summary>The new ratio for this lead, or null when it does not change.</summary>
    /// <param name="lead">Number of segments sent and not yet executed.</param>
    /// <param name="secondsAhead">Their duration at full speed.</param>
    /// <param name="remaining">Number of segments not yet sent.</param>
    public double? Ratio(int lead, double secondsAhead, int remaining)
    {
        if (remaining == 0 || secondsAhead > Math.Max(ComfortableSeconds, 2 * ShortSeconds)) return Release();
        if (lead < VeryShortLead || secondsAhead < ShortSeconds / 2) return Change(VerySlow);
        return _now == Full && (lead < ShortLead || secondsAhead < ShortSeconds) ? Change(Slow) : null;
    }

    /// <summary>Back to full speed, when everything has been sent.</summary>
    public double? Release() => Change(Full);

    private double? Change(double ratio)
    {
        if (ratio == _now) return null;
        _now = ratio;
        return ratio;
    }
}
