using Engraver.Core.Machines;
using Engraver.Galil.Sessions;

namespace Engraver.Galil.Jobs.Watching;

/// <summary>Whether the motors of a machine at rest are where they were sent: the host polls the reference position, and of an axis that was blocked by less
/// than ER the controller reports nothing (galil-dmc.md C, TE and ER).</summary>
internal sealed class FollowingCheck(ControllerSession session, MachineProfile profile)
{
    /// <summary>Position error that a motor at rest may keep, mm: friction, and a static load.</summary>
    private const double AllowedMm = 0.2;

    /// <summary>The same of an axis with few counts a millimetre.</summary>
    private const double AllowedCounts = 20.0;

    /// <summary>Motors settle after the end of a motion: readings until they must have settled, one each <see cref="s_settling"/>.</summary>
    private const int Looks = 10;

    private static readonly TimeSpan s_settling = TimeSpan.FromMilliseconds(50);

    /// <summary>Reads until every motor is where it was sent, or its settling time is over.</summary>
    /// <returns>The axes that are not, with their position errors; empty when all are, or the controller does not report them.</returns>
    /// <exception cref="ControllerException">The link failed.</exception>
    public async ValueTask<string> AtRestAsync()
    {
        for (var look = 1; ; look++)
        {
            var off = await LookAsync().ConfigureAwait(false);
            if (off.Length == 0 || look == Looks) return off;
            await Task.Delay(s_settling, session.Time, CancellationToken.None).ConfigureAwait(false);
        }
    }

    private async ValueTask<string> LookAsync()
    {
        MachineAxis[] axes = [.. profile.Axes.All.Where(axis => !axis.IsStepper)];
        if (axes.Length == 0) return "";
        var reading = await session.StopHandle.ReadAsync(string.Join(',', axes.Select(axis => $"_TE{axis.Letter}")), CancellationToken.None).ConfigureAwait(false);
        if (reading.Refusal is not null) return "";
        return string.Join(", ", axes.Select((axis, i) => (Axis: axis, Error: reading.Values[i])).Where(one => Math.Abs(one.Error) > Allowed(one.Axis)).Select(one => Wording.Get("JobMachine.AxisError", profile.Axes.NameOf(one.Axis.Letter), one.Error)));
    }

    private static double Allowed(MachineAxis axis) => Math.Max(AllowedCounts, axis.Scale.CountsOf(AllowedMm));
}
