using Engraver.Simulator.Motion;

namespace Engraver.Simulator;

/// <summary>Reactions to a changed input line or a character on the serial port (galil-dmc.md C, C.3, D).</summary>
internal sealed class InputChanges(Machine machine)
{
    /// <summary>Sets the level of an input; latches, selective abort and the input interrupt react to it.</summary>
    public void Set(int input, bool level)
    {
        var before = machine.Io.Input(input);
        machine.Io.SetInput(input, level);
        if (before == level) return;
        var polarity = machine.Motion.Polarity;
        if (input <= Axis.Real && machine.Motion.Axes[input - 1].Latch is { IsArmed: true, WaitsForIndex: false } latch && level == polarity.LatchOnRise)
            latch.Catch(machine.Motion.Axes[input - 1].Motor.Position);
        if (input > Axis.Real && !level && polarity.SelectiveAbort)
        {
            machine.Motion.Halt(machine.Motion.Axes[input - 1 - Axis.Real], StopCode.SelectiveAbort, motorsOff: false);
            machine.Threads.Interrupt("POSERR");
        }

        Watch();
    }

    /// <summary>Starts #ININT when a watched input has its interrupt level.</summary>
    public void Watch()
    {
        if (machine.InputInterrupt.IsDue(machine.Io.Inputs) && machine.Threads.Interrupt("ININT")) machine.InputInterrupt.Taken();
    }

    /// <summary>Takes a character from the serial port; returns true when it is data for the program and not part of a command (CI n,1).</summary>
    public bool TakeSerial(char c)
    {
        if (machine.SerialInterrupt.Accept(c) && machine.Threads[0].IsRunning && machine.Threads.Interrupt("COMINT")) machine.SerialInterrupt.Taken();
        return machine.SerialInterrupt.TakesData;
    }
}
