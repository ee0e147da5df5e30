using Engraver.Core.Machines;
using Engraver.Galil.Language;
using Engraver.Galil.Programs;
using Engraver.Galil.Sessions;

namespace Engraver.Galil.Jobs;

/// <summary>ER of a job: the position error at which the controller itself ends it (#POSERR), so that a jammed axis is detected between two polls and also
/// when this computer has failed (galil-dmc.md C, ER).</summary>
internal static class PositionErrorLimit
{
    /// <summary>The largest limit that every firmware takes (galil-dmc.md C, ER: older ones 0 to 32767).</summary>
    private const int Largest = 32767;

    /// <summary>ER of each axis of the job that may have an encoder and whose limit can be restored afterwards. At the fastest speed of the job, whatever
    /// the override.</summary>
    public static IReadOnlyList<string> Commands(MachineProfile profile, FoundState found) =>
        [.. profile.Axes.All.Where(axis => !axis.IsStepper && found.Motion.Any(setting => setting.Operand == $"_ER{axis.Letter}")).Select(axis => DmcFormat.Text($"ER{axis.Letter}={Counts(profile, axis)}"))];

    private static int Counts(MachineProfile profile, MachineAxis axis) =>
        (int)Math.Clamp(Math.Round(axis.Scale.CountsOf(profile.FollowingErrorAt(profile.FastestMmPerSecond))), 1.0, Largest);
}
