using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Galil.Language;
using Engraver.Galil.Tests.Jobs.Holds;

namespace Engraver.Galil.Tests.Jobs.Wires;

/// <summary>One job of the comparison: its program, its machine and its operator.</summary>
/// <param name="Name">One word or two.</param>
/// <param name="Program">The program of a mode.</param>
/// <param name="Steps">What happens in the first run.</param>
internal sealed record WireCase(string Name, Func<JobMode, MotionProgram> Program, params IReadOnlyList<WireStep> Steps)
{
    private static readonly MachineAxes s_otherAxes = new(new MachineAxis('B', 1000.0), new MachineAxis('D', -1000.0));

    /// <summary>A Z axis that the job does not move: an output is the tool.</summary>
    private static readonly MachineProfile s_idleHeight = MachineProfile.Default with { Axes = MachineAxes.Default with { Z = new MachineAxis('C', 800.0) } };

    private static readonly MachineProfile s_stepper = MachineProfile.Default with { Axes = new MachineAxes(new MachineAxis('A', 1000.0, 2.0), new MachineAxis('B', 1000.0, -2.0)) };

    /// <summary>Changes to the options of the first run.</summary>
    public Func<JobOptions, JobOptions> With { get; init; } = options => options;

    /// <summary>Rate of a serial line; 0 for a network.</summary>
    public int Baud { get; init; }

    public int ProgramLines { get; init; } = 1000;

    /// <summary>What arrives instead of a line that is sent; null: the line itself.</summary>
    public Func<string, string>? Harm { get; init; }

    /// <summary>Thirteen jobs; each is held, resumed, stopped, and resumed from the place where it was stopped.</summary>
    public static IReadOnlyList<WireCase> Jobs { get; } =
    [
        new("lines and an arc", _ => MotionPrograms.Paper, Hold(0.9), Resume(1.4), Stop(2.0)),
        new("arcs", _ => MotionPrograms.ArcChain(12, 1500), Hold(0.6), Resume(1.1), Hold(1.3), Resume(1.7), Stop(2.4)),
        new("short lines", mode => MotionPrograms.ShortLines(mode == JobMode.Calls ? 60 : 700), Hold(0.8), Resume(1.2), Stop(1.9)) { ProgramLines = 400 },
        new("late feeder", mode => MotionPrograms.CircleAndShortLines(mode switch { JobMode.Stream => 650, JobMode.Calls => 60, _ => 1500 }), Late(1.0), Late(1.4), Hold(1.9), Resume(2.2), Late(2.4), Stop(2.8)),
        new("frame and other axes", Rake(MachineProfile.Default with { Axes = s_otherAxes }), Hold(0.06), Resume(0.5), Hold(1.0), Resume(1.3), Stop(2.1)) { With = options => options with { Frame = new CountsPoint(-3000, 1230) } },
        new("tool axis", Height(HeightBench.Profile with { Spindle = null }), Hold(2.2), Resume(2.8), Stop(4.1)),
        new("tool axis and spindle", Height(HeightBench.Profile with { Spindle = new Spindle { Output = 3, SpinUpSeconds = 0.4, StopsInHold = true } }), Hold(2.5), Step(3.6), Resume(4.4), Stop(7.0)),
        new("moved by hand while held", Rake(s_idleHeight), Hold(0.9), Step(1.4), Press(2.2), Release(2.6), Resume(3.4), Stop(4.6)),
        new("output active low", Rake(MachineProfile.Default with { ToolActiveLow = true, ToolOffSettleSeconds = 0.02 }), Hold(0.5), Resume(0.9), Hold(1.2), Resume(1.5), Stop(2.2)),
        new("steppers and limits", Rake(s_stepper), Hold(0.7), Resume(1.1), Stop(1.6)) { With = options => options with { SoftLimits = [new SoftLimit('A', -90_000, 90_000), new SoftLimit('B', -90_000, 90_000)] } },
        new("serial line", Rake(MachineProfile.Default), Hold(1.1), Resume(1.9), Stop(2.8)) { Baud = 19200, With = options => options with { FollowedAxes = "AB" } },
        new("short lines over a serial line", mode => MotionPrograms.ShortLines(mode == JobMode.Stream ? 700 : 60, 200), Hold(6.5), Resume(7.2), Stop(9.0)) { Baud = 19200 },
        new("overrides in a dry run", Rake(MachineProfile.Default), Feed(0.3, 0.5), Rapid(0.4, 0.3), Hold(0.8), Feed(1.0, 1.5), Resume(1.1), Feed(1.4, 0.3), Stop(2.6)) { With = options => options with { DryRun = true, FollowedAxes = "AB" } },
    ];

    /// <summary>Jobs that something other than the operator ends, or that are disturbed.</summary>
    public static IReadOnlyList<WireCase> Faults { get; } =
    [
        Fault("limit switch", bench => bench.Controller.SetLimitSwitch(0, forward: true, active: true)),
        Fault("tool switched off", bench => bench.Interfere("CB 1")),
        Fault("program halted", bench => bench.Interfere("HX0")),
        Fault("watchdog halted", bench => bench.Interfere("HX1")),
        Fault("feed changed", bench => bench.Interfere("VS 60000")),
        Fault("motion withheld", bench => bench.Interfere("VR 0")),
        Fault("refused command", _ => { }) with { Harm = line => line.Replace("SB 1", "SB 99", StringComparison.Ordinal).Replace("XQ #JOB", "XQ #NONE", StringComparison.Ordinal) },
        Fault("abort input", bench => bench.Controller.SetAbortInput(true)),
        Fault("blocked motor", bench => bench.Controller.HoldMotor(0, true)),
        Fault("silent host", bench => bench.Controller.Advance(TimeSpan.FromSeconds(3))),
        Fault("cut links", bench => bench.Controller.DropConnections()),
        Fault("stop in a hold", bench => bench.Control.Hold(), Stop(1.5)),
        Fault("stop away from the path", bench => bench.Control.Hold(), Press(1.4), Stop(1.8)),
        Fault("fault in a hold", bench => bench.Control.Hold(), new WireStep(1.5, bench => bench.Interfere("HX0"))),
    ];

    private static WireCase Fault(string name, Action<WireBench> happens, params ReadOnlySpan<WireStep> more) => new(name, _ => MotionPrograms.LongLine(60000), [new WireStep(0.9, happens), .. more]);

    private static WireStep Hold(double at) => new(at, bench => bench.Control.Hold());

    private static WireStep Resume(double at) => new(at, bench => bench.Control.Resume());

    private static WireStep Stop(double at) => new(at, bench => bench.Stop.Cancel());

    private static WireStep Feed(double at, double ratio) => new(at, bench => bench.Control.FeedRatio = ratio);

    private static WireStep Rapid(double at, double ratio) => new(at, bench => bench.Control.RapidRatio = ratio);

    private static WireStep Step(double at) => new(at, bench => _ = bench.Control.MoveAsync(MoveInHold.By(new CountsPoint(2000, -1500, 400))));

    private static WireStep Press(double at) => new(at, bench => _ = bench.Control.MoveAsync(MoveInHold.While(bench.Key)));

    private static WireStep Release(double at) => new(at, bench => bench.Key.Release());

    /// <summary>The host is late by less than the watchdog allows, and by more than the buffer lasts.</summary>
    private static WireStep Late(double at) => new(at, bench => bench.Controller.Advance(TimeSpan.FromSeconds(0.8)));

    private static Func<JobMode, MotionProgram> Height(MachineProfile profile) => mode => HeightBench.Part(profile, Style(mode));

    /// <summary>Four lines beside each other and an arc, a stroke each, and back to the start.</summary>
    private static Func<JobMode, MotionProgram> Rake(MachineProfile profile) => mode => new MotionProgram(profile, default, MotionPrograms.InColumns(
    [
        .. Enumerable.Range(0, 4).Select(i => Stroke(i, new(1000, 2000 * (i + 1)), MotionPrograms.Line(9000, 2000 * (i + 1), i, 8000.0))),
        Stroke(4, new(1000, 12000), new VectorSegment(VectorSegmentKind.Arc, new(1000, 12000), 2000, 180.0, 360.0, 4, 4000.0 * Math.PI)),
    ])) { Finish = default(CountsPoint), Style = Style(mode) };

    private static MotionStroke Stroke(int index, CountsPoint start, VectorSegment segment) => new(index, start, [new VectorSequence(start, 20000, [segment])]);

    private static MotionStyle Style(JobMode mode) => mode == JobMode.Calls ? MotionStyle.Calls : MotionStyle.Continuous;
}
