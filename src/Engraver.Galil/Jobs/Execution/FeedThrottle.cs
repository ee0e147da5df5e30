namespace Engraver.Galil.Jobs.Execution;

/// <summary>Slows the path down by VR when the lead of the feeder gets short, instead of letting the buffer run dry (galil-dmc.md F.1, J 7).</summary>
/// <param name="reactionSeconds">What passes between seeing that the lead is short and saying so.</param>
/// <param name="rampSeconds">How long the path takes to stop from full speed: VR does not act faster than VA and VD allow, so it must be sent that much earlier.</param>
internal sealed class FeedThrottle(double rampSeconds, double reactionSeconds)
{
    /// <summary>Below this lead, in segments, the ratio is <see cref="Slow"/>; below the second one <see cref="VerySlow"/>.</summary>
    private const int ShortLead = 20;
    private const int VeryShortLead = 8;

    /// <summary>A few long segments are lead enough: 1.6 ms a command feeds more than a hundred in this time, seconds. Wide apart from the short lead, so that the speed does not hunt.</summary>
    private const double ComfortableSeconds = 0.25;

    private const double Full = 1.0;
    private const double Slow = 0.5;
    private const double VerySlow = 0.1;

    private double _now = Full;

    private double ShortSeconds => rampSeconds + reactionSeconds;

    /// <summary>The command that sets the ratio.</summary>
    public static string Command(double ratio) => JobMachine.Text($"VR {ratio}");

    /// <summary>The ratio for this lead, or null when it stands so already.</summary>
    /// <param name="lead">Segments sent and not yet executed.</param>
    /// <param name="secondsAhead">How long they last at full speed.</param>
    /// <param name="remaining">Segments not yet sent.</param>
    public double? Ratio(int lead, double secondsAhead, int remaining)
    {
        if (remaining == 0 || secondsAhead > Math.Max(ComfortableSeconds, 2 * ShortSeconds)) return Release();
        if (lead < VeryShortLead || secondsAhead < ShortSeconds / 2) return Change(VerySlow);
        return _now == Full && (lead < ShortLead || secondsAhead < ShortSeconds) ? Change(Slow) : null;
    }

    /// <summary>Back to full speed: nothing more has to be sent in time.</summary>
    public double? Release() => Change(Full);

    private double? Change(double ratio)
    {
        if (ratio == _now) return null;
        _now = ratio;
        return ratio;
    }
}
