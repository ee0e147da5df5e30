using Engraver.Core.Machines;

namespace Engraver.Core.Motion;

/// <summary>How a family of controllers spends time: the speeds it really runs at, and how long the machine stands while commands, questions and answers pass, by the link and the mode of the job. Seconds; its driver says it.</summary>
public abstract class CommandTimes
{
    /// <summary>Seconds between two looks of the controller at its motors; every motion ends on one.</summary>
    public abstract double Sample { get; }

    /// <summary>Counts/s at which an axis travels between strokes, as the controller takes them.</summary>
    public abstract double RapidSpeed(MachineProfile profile, MachineAxis axis);

    /// <summary>What is loaded into the controller while the job lasts.</summary>
    public abstract double Loading(MotionProgram program);

    /// <param name="moving">How long the rapid itself takes; 0 where there is nowhere to go.</param>
    public abstract double Rapid(CountsPoint from, CountsPoint to, double moving, MotionProgram program);

    /// <summary>Before a sequence begins and behind its end.</summary>
    /// <param name="moving">How long the sequence itself takes.</param>
    public abstract double Sequence(VectorSequence sequence, double moving, MotionProgram program);

    /// <summary>Counts/s at which the tool's axis goes down to the work.</summary>
    public abstract double PlungeSpeed(MachineProfile profile);

    /// <summary>One change of the tool with its settle; where an axis holds the tool, what is exchanged for its moves.</summary>
    /// <param name="at">Where the machine stands, job frame.</param>
    /// <param name="on">The tool comes to the work; otherwise it goes.</param>
    /// <param name="moving">How long the moves of the tool's axis take; 0 where an output is the tool.</param>
    public abstract double Tool(CountsPoint at, bool on, double moving, MotionProgram program);
}
