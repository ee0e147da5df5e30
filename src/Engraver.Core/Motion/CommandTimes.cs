using Engraver.Core.Machines;

namespace Engraver.Core.Motion;

/// <summary>How a family of controllers spends time: the speeds it really runs at, and how long the machine stands while commands, questions and answers pass, by the link and the mode of the job. Seconds; its driver says it.</summary>
public abstract class CommandTimes
{
    /// <summary>Seconds between two looks of the controller at its motors; every motion ends on one.</summary>
    public abstract double Sample { get; }

    /// <summary>Counts/s at which X and Y travel between strokes, as the controller takes them.</summary>
    public abstract (double X, double Y) RapidSpeeds(MachineProfile profile);

    /// <summary>What is loaded into the controller while the job lasts.</summary>
    public abstract double Loading(MotionProgram program);

    /// <param name="moving">How long the rapid itself takes; 0 where there is nowhere to go.</param>
    public abstract double Rapid(CountsPoint from, CountsPoint to, double moving, MotionProgram program);

    /// <summary>Before a sequence begins and behind its end.</summary>
    /// <param name="moving">How long the sequence itself takes.</param>
    public abstract double Sequence(VectorSequence sequence, double moving, MotionProgram program);

    /// <summary>One change of the tool with its settle.</summary>
    /// <param name="at">Where the machine stands, job frame.</param>
    public abstract double Tool(CountsPoint at, MotionProgram program);
}
