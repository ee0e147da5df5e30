namespace Engraver.Galil.Jobs.Watching;

/// <summary>Reads back settings before the job relies on them. Over a network only: on a serial line every command is already compared with its echo, and a
/// query would take long.</summary>
internal static class SettingCheck
{
    /// <summary>Allowed difference as a part of the value: the controller keeps speeds and accelerations in steps (galil-dmc.md B.4: VS 2, VA 1024), and a
    /// difference of this size is harmless.</summary>
    private const double Share = 0.02;

    /// <param name="wanted">Operand, value sent, and the step in which the controller keeps it.</param>
    public static async ValueTask ReadBackAsync(JobMachine machine, params IReadOnlyList<(string Operand, double Value, double Step)> wanted)
    {
        if (machine.Line is not null || wanted.Count == 0) return;
        var values = await machine.Commands.AskAllAsync(string.Join(',', wanted.Select(one => one.Operand))).ConfigureAwait(false);
        for (var i = 0; i < wanted.Count; i++)
        {
            var (operand, value, step) = wanted[i];
            if (Math.Abs(values[i] - value) > step + (step > Exact ? Share * Math.Abs(value) : 0.0)) throw JobEnd.LinkLost(Wording.Get("SettingCheck.ValueDiffers", values[i], operand, value)).ToException();
        }
    }

    /// <summary>Step of a number that must be kept as it was sent: the error of the fourth decimal, which the controller truncates.</summary>
    public const double Exact = 0.0002;

    /// <summary>Steps of SP and VS, counts/s.</summary>
    public const double Speed = 2.0;

    /// <summary>Steps of AC, DC, VA and VD, counts/s2.</summary>
    public const double Acceleration = 1024.0;
}
