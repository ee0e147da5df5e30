using Engraver.Core.Machines;

namespace Engraver.Core.Motion;

/// <summary>How a family of controllers uses time: its actual speeds, and how long the machine is at rest while commands, queries and replies are exchanged, by
/// the link and the mode of the job. Seconds; the family's driver supplies them.</summary>
public abstract class CommandTimes
{
    /// <summary>Seconds between two samples of the motors by the controller; every motion ends on one.</summary>
    public abstract double Sample { get; }

    /// <summary>Counts/s at which an axis travels between strokes, as the controller accepts them.</summary>
    public abstract double RapidSpeed(MachineProfile profile, MachineAxis axis);

    /// <summary>Time for the data that is loaded into the controller during the job.</summary>
    public abstract double Loading(MotionProgram program);

    /// <param name="moving">Duration of the rapid itself; 0 where it has no length.</param>
    public abstract double Rapid(CountsPoint from, CountsPoint to, double moving, MotionProgram program);

    /// <summary>Time before the start of a sequence and after its end.</summary>
    /// <param name="moving">Duration of the sequence itself.</param>
    public abstract double Sequence(VectorSequence sequence, double moving, MotionProgram program);

    /// <summary>Counts/s at which the tool's axis moves down to the work.</summary>
    public abstract double PlungeSpeed(MachineProfile profile);

    /// <summary>Time of a wait that an operation states, at standstill.</summary>
    /// <param name="at">Position of the machine, job frame.</param>
    /// <param name="seconds">Above 0.</param>
    public virtual double Wait(CountsPoint at, double seconds) => seconds;

    /// <summary>Time to switch the tool on or off once, with its settle time; where an axis is the tool drive, the time of the commands for its
    /// moves.</summary>
    /// <param name="at">Position of the machine, job frame.</param>
    /// <param name="on">The tool is switched on or moves to the work; otherwise off or away from it.</param>
    /// <param name="moving">Duration of the moves of the tool's axis; 0 where an output is the tool.</param>
    public abstract double Tool(CountsPoint at, bool on, double moving, MotionProgram program);
}
