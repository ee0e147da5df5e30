using Engraver.Galil.Programs;
using Engraver.Galil.Sessions;

namespace Engraver.Galil.Jobs;

/// <summary>How far the watchdog in the controller is wound up: 1.0 s of the controller's own time, and 1.0 s of ours where its clock verifiably runs ahead of ours.</summary>
/// <param name="Rate">Controller seconds for each of ours; 1 where nothing else is proved. Only a simulator's is another.</param>
public readonly record struct WatchdogLimit(double Rate)
{
    /// <summary>A real controller counts 2.4 % faster than it says (galil-dmc.md C, TIME); three times is no inexactness.</summary>
    private const double MuchFaster = 3.0;

    /// <summary>An estimate this much above what is proved came from a reply that was held up.</summary>
    private const double HeldUp = 1.25;

    private const int MostLooks = 10;

    /// <summary>The machine stands and no thread runs: virtual time stands too, and only a clock that really runs gets anywhere.</summary>
    private static readonly TimeSpan Pause = TimeSpan.FromMilliseconds(20);

    public static WatchdogLimit OneSecond { get; } = new(1.0);

    public int Ticks => (int)Math.Ceiling(ResidentProgram.HeartbeatTicks * Rate);

    /// <summary>Samples of the controller that are as long as so many at a clock like ours.</summary>
    public double Samples(int samples) => samples * Rate;

    /// <summary>Two looks at TIME with a pause between, again while a delay on the way leaves it open how fast the clock is.</summary>
    /// <exception cref="Protocol.ControllerException">The link failed.</exception>
    internal static async ValueTask<WatchdogLimit> MeasureAsync(ControllerSession session, CancellationToken stop)
    {
        if (!session.ClockMoves) return OneSecond;
        var (proved, estimated) = (0.0, double.PositiveInfinity);
        for (var look = 0; look < MostLooks && estimated > MuchFaster && estimated > proved * HeldUp; look++)
        {
            if (await LookAsync(session, stop).ConfigureAwait(false) is not { } seen) return OneSecond;
            (proved, estimated) = (Math.Max(proved, seen.Proved), Math.Min(estimated, seen.Estimated));
        }

        return Of(proved, estimated);
    }

    /// <summary>From before the first question to behind the second answer is at least the time between the two samples, so that no delay on the way makes a real controller look fast. Bytes on a
    /// serial line take their time whatever our clock says: a simulated controller whose time is those bytes is not fast either.</summary>
    private static async ValueTask<(double Proved, double Estimated)?> LookAsync(ControllerSession session, CancellationToken stop)
    {
        var time = session.Time;
        var onWire = session.WireTime;
        var asked = time.GetTimestamp();
        var first = (await session.Commands.ReadAsync("TIME", stop).ConfigureAwait(false)).OrNothing;
        var answered = time.GetTimestamp();
        await Task.Delay(Pause, time, stop).ConfigureAwait(false);
        var askedAgain = time.GetTimestamp();
        var last = (await session.Commands.ReadAsync("TIME", stop).ConfigureAwait(false)).OrNothing;
        if (last - first is not { } samples) return null;
        var seconds = samples * (session.Identity.Limits.SampleMicroseconds ?? 1000) / 1e6;
        var atMost = Math.Max(time.GetElapsedTime(asked).TotalSeconds, (session.WireTime - onWire).TotalSeconds);
        return (seconds / atMost, seconds / time.GetElapsedTime(answered, askedAgain).TotalSeconds);
    }

    /// <param name="proved">The rate that the clock has at least.</param>
    /// <param name="estimated">The rate that it has at most.</param>
    public static WatchdogLimit Of(double proved, double estimated) => proved > MuchFaster ? new(Math.Min(estimated, proved * HeldUp)) : OneSecond;
}
