using Engraver.Galil.Jobs.Watching;
using Engraver.Galil.Language;

namespace Engraver.Galil.Jobs.Execution;

/// <summary>Settings of the motion that the host commands: VS, VA and VD of sequences, SP of rapids, and the number of free places in the segment buffer. They
/// are sent and queried where they change, because each exchange before a motion is time at standstill.</summary>
/// <remarks>What another host changes meanwhile is noticed by the speed of the path (<see cref="FeedWatch"/>).</remarks>
internal sealed class MotionSettings(JobMachine machine)
{
    private readonly Dictionary<char, int> _rapids = [];
    private int _speed;
    private int _acceleration;

    /// <summary>Free places in the buffer before a sequence; 0 until it is known.</summary>
    public int Capacity { get; private set; }

    /// <summary>The controller may have other settings by now: the next motion sends them.</summary>
    public void Forget()
    {
        (_speed, _acceleration, Capacity) = (0, 0, 0);
        ForgetRapids();
    }

    /// <summary>The controller may have other speeds of the axes by now.</summary>
    public void ForgetRapids() => _rapids.Clear();

    /// <summary>Puts SP of axes in force.</summary>
    /// <param name="speeds">Counts/s by axis letter.</param>
    public async ValueTask SendRapidsAsync(IEnumerable<(char Letter, int Speed)> speeds)
    {
        var changed = speeds.Where(axis => _rapids.GetValueOrDefault(axis.Letter) != axis.Speed).ToList();
        await machine.Commands.SendAllAsync(changed.Select(axis => SpeedOf(axis.Letter, axis.Speed))).ConfigureAwait(false);
        await SettingCheck.ReadBackAsync(machine, [.. changed.Select(axis => ($"_SP{axis.Letter}", (double)axis.Speed, SettingCheck.Speed))]).ConfigureAwait(false);
        foreach (var (letter, speed) in changed) _rapids[letter] = speed;
    }

    /// <summary>SP of one axis.</summary>
    public static string SpeedOf(char letter, int speed) => DmcFormat.Text($"SP{letter}={speed}");

    /// <summary>Puts the settings of a sequence in force, after CSS and VM or LM.</summary>
    /// <param name="speed">VS, counts/s.</param>
    /// <param name="acceleration">VA and VD, counts/s2.</param>
    public async ValueTask SendAsync(int speed, int acceleration)
    {
        var wanted = new List<(string Operand, double Value, double Step)>();
        if (speed != _speed)
        {
            await machine.Commands.SendAsync(DmcFormat.Text($"VSS={speed}")).ConfigureAwait(false);
            wanted.Add(("_VSS", speed, SettingCheck.Speed));
        }

        if (acceleration != _acceleration)
        {
            await machine.Commands.SendAllAsync([DmcFormat.Text($"VAS={acceleration}"), DmcFormat.Text($"VDS={acceleration}")]).ConfigureAwait(false);
            wanted.AddRange([("_VAS", acceleration, SettingCheck.Acceleration), ("_VDS", acceleration, SettingCheck.Acceleration)]);
        }

        await SettingCheck.ReadBackAsync(machine, wanted).ConfigureAwait(false);
        (_speed, _acceleration) = (speed, acceleration);
        await machine.Speed.PutInForceAsync(isKnown: Capacity > 0).ConfigureAwait(false);
        if (Capacity == 0) Capacity = (int)await machine.Commands.AskAsync("_LMS").ConfigureAwait(false);
    }
}
