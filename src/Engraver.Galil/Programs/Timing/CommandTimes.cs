using Engraver.Core.Machines;

namespace Engraver.Galil.Programs.Timing;

/// <summary>How long the machine stands while commands, questions and answers pass, by the link and the way of the job. Seconds; motion itself is not counted.</summary>
public abstract class CommandTimes
{
    /// <summary>One statement of a program in the controller (galil-dmc.md A.4).</summary>
    internal const double SecondsPerStatement = 0.0005;

    /// <summary>Server loop, dispatch and subprogram of one call, its WT 2 included.</summary>
    internal const double SecondsPerCall = 26 * SecondsPerStatement;

    /// <summary>The nominal sample (TM 1000); every motion ends on one.</summary>
    internal const double Sample = 0.001;

    /// <summary>TIME counts 1024 in a second on hardware (galil-dmc.md C), and the settle is waited for by TIME.</summary>
    private const double SettleSamplesPerSecond = 1024.0;

    private protected CommandTimes()
    {
    }

    /// <summary>A job that the host leads over the network: 1.6 ms for each command.</summary>
    public static CommandTimes Ethernet { get; } = new EthernetTimes();

    /// <summary>What is loaded into the controller while the job lasts.</summary>
    internal abstract double Loading(MotionProgram program);

    /// <param name="moving">How long the rapid itself takes; 0 where there is nowhere to go.</param>
    internal abstract double Rapid(CountsPoint from, CountsPoint to, double moving, MotionProgram program);

    /// <summary>Before a sequence begins and behind its end.</summary>
    /// <param name="moving">How long the sequence itself takes.</param>
    internal abstract double Sequence(VectorSequence sequence, double moving, MotionProgram program);

    /// <summary>One change of the tool with its settle.</summary>
    /// <param name="at">Where the machine stands, job frame.</param>
    internal abstract double Tool(CountsPoint at, MotionProgram program);

    /// <summary>The settle as the job waits for it, in whole samples.</summary>
    private protected static double Settle(MotionProgram program) => Math.Ceiling(program.Profile.ToolSettleSeconds * SettleSamplesPerSecond) * Sample;
}
