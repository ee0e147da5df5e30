using System.Text;
using Engraver.Simulator.Language.Commands;

namespace Engraver.Simulator;

/// <summary>DR n,h (galil-dmc.md A.9): a data record every n samples as a separate datagram, without a prompt.</summary>
internal sealed class DataRecordPush(Machine machine)
{
    private long _last;

    /// <summary>Samples between two records; 0 is off: <c>_DR0</c>.</summary>
    public int Period { get; private set; }

    /// <summary>The UDP handle: <c>_DR1</c>.</summary>
    public int HandleIndex { get; private set; }

    public bool IsOn => Period > 0;

    /// <summary>Records sent since power up.</summary>
    public long Sent { get; private set; }

    /// <summary>The sample in which the next record is due; long.MaxValue when no record is due.</summary>
    public long NextDue => IsOn ? _last + (long)Math.Max(1, Period / machine.SamplesPerMillisecond) : long.MaxValue;

    public void Start(int period, int handleIndex)
    {
        Period = period;
        HandleIndex = handleIndex;
        _last = machine.Sample;
    }

    public void Stop() => Period = 0;

    /// <summary>Sends a record when the sample <see cref="NextDue"/> is reached; switches off when the handle is closed.</summary>
    public void Step()
    {
        if (machine.Sample < NextDue) return;
        _last = machine.Sample;
        if (machine.Handles[HandleIndex] is not { IsUdp: true } handle)
        {
            Stop();
            return;
        }

        Sent++;
        handle.Send(Encoding.Latin1.GetBytes(DataRecord.Build(machine, "")));
    }
}
