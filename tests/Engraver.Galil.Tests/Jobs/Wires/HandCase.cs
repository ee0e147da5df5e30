using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Galil.Jobs;
using Engraver.Galil.Sessions;
using Engraver.Simulator;

namespace Engraver.Galil.Tests.Jobs.Wires;

/// <summary>Motion by hand, which runs as a job without strokes.</summary>
internal sealed record HandCase(string Name, Func<WireBench, ControllerSession, Task<JobResult>> RunAsync)
{
    private static readonly MotionProgram s_program = new(MachineProfile.Default with { Axes = MachineAxes.Default with { Z = new MachineAxis('C', 800.0) } }, default, []);

    private static readonly MotionProgram s_homed = new(
        MachineProfile.Default with { Axes = MachineAxes.Default with { X = MachineAxes.Default.X with { Homing = new AxisHoming { By = HomingMark.SwitchIndex, Zero = 5, BackOff = 2 } } } }, default, []);

    /// <summary>Rate of a serial line; 0 for a network.</summary>
    public int Baud { get; init; }

    public AxisSwitches[] Switches { get; init; } = [];

    public static IReadOnlyList<HandCase> All { get; } =
    [
        new("go to", (bench, session) => GoToAsync(bench, session)),
        new("go to and stop", (bench, session) => GoToAsync(bench, session, new WireStep(0.3, bench => bench.Stop.Cancel()))),
        new("go to a limit switch", (bench, session) => GoToAsync(bench, session, new WireStep(0.3, bench => bench.Controller.SetLimitSwitch(0, forward: true, active: true)))),
        new("go to over a serial line", (bench, session) => GoToAsync(bench, session)) { Baud = 19200 },
        new("jog", (bench, session) => JogAsync(bench, session, new WireStep(0.2, bench => bench.Key.Velocity = new JogVelocity(-900.0, 450.0)), new WireStep(0.5, bench => bench.Key.Release()))),
        new("jog to a limit switch", (bench, session) => JogAsync(bench, session, new WireStep(0.3, bench => bench.Controller.SetLimitSwitch(0, forward: false, active: true)))),
        new("jog and cut links", (bench, session) => JogAsync(bench, session, new WireStep(0.3, bench => bench.Controller.DropConnections()))),
        new("jogs kept ready", StandByAsync),
        new("jogs kept ready over a serial line", StandByAsync) { Baud = 19200 },
        new("homing", HomeAsync) { Switches = [new AxisSwitches(0) { HomeAt = -20000, IsHomeBelow = true, ReverseLimitAt = -24000, ForwardLimitAt = 90000, IndexAt = -19300, IndexPeriod = 4000 }] },
        new("homing without a switch", HomeAsync) { Switches = [new AxisSwitches(0) { ReverseLimitAt = -24000 }] },
        new("pulse of the tool", (bench, session) => JobRunner.PulseAsync(s_program, session, SimulatedBench.Job, bench.Stop.Token)),
    ];

    private static Task<JobResult> GoToAsync(WireBench bench, ControllerSession session, params WireStep[] steps) =>
        JobRunner.GoToAsync(s_program, new CountsPoint(30000, -20000, 4000), session, SimulatedBench.Job, new WireOperator(bench, steps), bench.Stop.Token, withHeight: true);

    private static Task<JobResult> JogAsync(WireBench bench, ControllerSession session, params WireStep[] steps) =>
        JobRunner.JogAsync(s_program, bench.Key, session, SimulatedBench.Job with { SoftLimits = [new SoftLimit('B', -90_000, 90_000)] }, new WireOperator(bench, steps), bench.Stop.Token);

    private static async Task<JobResult> HomeAsync(WireBench bench, ControllerSession session) => (await JobRunner.HomeAsync(s_homed, session, SimulatedBench.Job, null, bench.Stop.Token)).Result;

    /// <summary>Two jogs one after the other, a steered one and one that is stopped by a switch.</summary>
    private static Task<JobResult> StandByAsync(WireBench bench, ControllerSession session)
    {
        var second = new JogControl(new JogVelocity(0.0, 600.0));
        var standby = new JogStandby();
        return JobRunner.StandByAsync(s_program, standby, session, SimulatedBench.Job, new WireOperator(
            bench,
            new WireStep(0.1, bench => standby.Press(bench.Key)),
            new WireStep(0.4, bench => bench.Key.Velocity = new JogVelocity(-900.0, 450.0)),
            new WireStep(0.7, bench => bench.Key.Release()),
            new WireStep(1.3, _ => standby.Press(second)),
            new WireStep(1.6, _ => second.Release()),
            new WireStep(2.2, _ => standby.Leave())), bench.Stop.Token);
    }
}
