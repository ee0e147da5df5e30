using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Galil.Language;

namespace Engraver.Galil.Programs.Timing;

/// <summary>The times that are the same for every execution strategy on a controller of this family.</summary>
public abstract class DmcTimes : CommandTimes
{
    /// <summary>One statement of a program in the controller (galil-dmc.md A.4).</summary>
    internal const double SecondsPerStatement = 0.0005;

    /// <summary>Server loop, dispatch and subprogram of one call, including its WT 2.</summary>
    internal const double SecondsPerCall = 26 * SecondsPerStatement;

    /// <summary>The nominal sample (TM 1000); every motion ends on one.</summary>
    internal const double SampleSeconds = 0.001;

    /// <summary>On hardware TIME counts 1024 in a second (galil-dmc.md C), and the settle time is measured by TIME.</summary>
    private const double SettleSamplesPerSecond = 1024.0;

    private protected DmcTimes()
    {
    }

    /// <summary>A job run by the host over the network: 1.6 ms for each command. For one estimate, because it follows the settings of the sequences.</summary>
    public static CommandTimes Ethernet => new EthernetTimes();

    public override double Sample => SampleSeconds;

    public override double RapidSpeed(MachineProfile profile, MachineAxis axis) => profile.RapidSpeed(axis);

    public override double PlungeSpeed(MachineProfile profile) => profile.PlungeSpeed();

    public override double Wait(CountsPoint at, double seconds) => Waited(seconds);

    /// <summary>A wait that the host counts, in whole samples.</summary>
    private protected static double Waited(double seconds) => Math.Ceiling(seconds * SettleSamplesPerSecond) * SampleSeconds;

    /// <summary>Moves of the tool axis in one change: fast and at the plunge feed, or up.</summary>
    private protected static int MovesOfTool(bool on) => on ? 2 : 1;

    /// <summary>The settle time of the job, in whole samples.</summary>
    private protected static double Settle(MotionProgram program, bool on) => Waited(on ? program.Profile.ToolSettleSeconds : program.Profile.OffSettleSeconds);
}
