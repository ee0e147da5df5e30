namespace Engraver.Simulator;

/// <summary>The kinds of scheduled faults.</summary>
public enum FaultKind
{
    /// <summary>Answers are delayed.</summary>
    Delay,

    /// <summary>A command is lost: it is neither executed nor answered.</summary>
    DropCommand,

    /// <summary>A command is executed, but its answer is lost.</summary>
    DropReply,

    /// <summary>Garbage bytes precede the next answer.</summary>
    Garbage,

    /// <summary>Every link is cut, as by a disconnected cable; motion and programs continue.</summary>
    Reset,

    /// <summary>A limit switch is hit.</summary>
    LimitSwitch,

    /// <summary>The abort input is closed.</summary>
    AbortInput,

    /// <summary>A motor is switched off, as by off-on-error: the motion that drives its axis stops without a ramp.</summary>
    MotorOff,

    /// <summary>A shaft is blocked: its motor does not move, and the position error grows.</summary>
    Jam,

    /// <summary>The controller is switched off and on again: links, variables, programs and positions are lost, the burned state is restored (galil-dmc.md
    /// A.6).</summary>
    PowerCycle,
}
