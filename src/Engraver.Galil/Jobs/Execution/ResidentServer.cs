using Engraver.Core.Machines;
using Engraver.Galil.Jobs.Watching;
using Engraver.Galil.Language;
using Engraver.Galil.Programs;
using Engraver.Galil.Programs.Posting;
using Engraver.Galil.Programs.Resident;
using Engraver.Galil.Protocol;
using static Engraver.Galil.Programs.Resident.ResidentProgram;

namespace Engraver.Galil.Jobs.Execution;

/// <summary>The commands by which a job starts the program that was downloaded for it, and calls it (galil-dmc.md EX11, EX12, F.3).</summary>
internal static class ResidentServer
{
    /// <summary>Restarts the time of the watchdog.</summary>
    public static string HeartbeatCommand { get; } = DmcFormat.Text($"{Variables.Heartbeat}={HeartbeatTicks}");

    /// <summary>The same for a jog: the watchdog then trips 0.25 s after it.</summary>
    public static string CloseHeartbeatCommand { get; } = DmcFormat.Text($"{Variables.Heartbeat}={CloseHeartbeatTicks}");

    /// <summary>Gives every polled variable a value before it is read, because an undefined one is refused, and sets the watchdog's time before it
    /// starts.</summary>
    /// <param name="wait">The longest wait that an operation states, seconds.</param>
    public static string DefineVariables(MachineProfile profile, double wait) =>
        DmcFormat.Text($"{HeartbeatCommand};{Variables.WatchdogTripped}=0;{Variables.ErrorCode}=0;{Variables.ErrorLine}=0;{Variables.Sequence}=0;{Variables.Done}=0;{Variables.Hold}=0;{Variables.AtGate}=0;{Variables.JobMark}=0;{Variables.StandstillTickLimit}={StandstillLimit.ControllerTicks(profile, wait)}");

    /// <summary>By this number the variables that the watchdog leaves are known to be of this job.</summary>
    public static string MarkCommand(int mark) => DmcFormat.Text($"{Variables.JobMark}={mark}");

    /// <summary>Ends both threads of a job.</summary>
    public static IReadOnlyList<string> HaltCommands { get; } = [DmcFormat.Text($"HX{MainThread}"), DmcFormat.Text($"HX{WatchdogThread}")];

    /// <summary>A program that runs the job is left where it is, and its thread waits in a loop; its watchdog continues to run.</summary>
    public static string IdleCommand { get; } = DmcFormat.Text($"HX{MainThread};XQ {CommandErrorProgram.Halted},{MainThread}");

    public static string GoCommand { get; } = $"{Variables.Go}=1";

    /// <summary>A program that runs the job waits after its next rapid.</summary>
    public static string CloseGateCommand { get; } = $"{Variables.Hold}=1";

    public static string OpenGateCommand { get; } = $"{Variables.Hold}=0";

    public static ResidentProgram Program(JobMode mode, MachineProfile profile) => mode switch
    {
        JobMode.Stream => ForStream(profile),
        JobMode.Calls => ForCalls(profile),
        JobMode.Program => ForStream(profile), // runs until the first chunk is loaded
        _ => throw new ArgumentOutOfRangeException(nameof(mode)),
    };

    /// <summary>True for a resident program of a job with this profile, of any mode, and for its homing.</summary>
    /// <remarks>Whatever outputs the operations of that job switched: they are those that the program switches besides tool and spindle.</remarks>
    public static bool IsOwn(string program, MachineProfile profile)
    {
        profile = profile with { OperationOutputs = Subprograms.SwitchedIn(program).Where(output => !profile.IsToolOrSpindle(output)).Aggregate(0, (word, output) => word | (1 << (output - 1))) };
        return ProgramText.AreEquivalent(program, ForStream(profile).Text) || ProgramText.AreEquivalent(program, ForCalls(profile).Text) || (profile.HasHoming && ProgramText.AreEquivalent(program, ForHoming(profile).Text)) || SupervisedProgram.IsChunk(program, profile);
    }

    public static string StartCommand(ResidentProgram program) => DmcFormat.Text($"XQ {program.EntryLabel},{MainThread}");

    /// <summary>Operand for the line of the watchdog's thread; -1 while it does not run.</summary>
    public static string WatchdogLine { get; } = DmcFormat.Text($"_XQ{WatchdogThread}");

    /// <summary>Gives the watchdog the clearance height to which it raises the tool; for a program that does not cut, the lowest height there is, so that the
    /// watchdog does not change the height.</summary>
    /// <param name="frame">Controller counts at the drawing's zero; null before the frame is taken, when the machine is at the drawing's height 0.</param>
    /// <param name="lift">Of a dry run; a frame that is given includes it.</param>
    /// <param name="isCut">The program cuts.</param>
    public static IReadOnlyList<string> DefineHeight(MachineProfile profile, CountsPoint? frame, int lift, bool isCut)
    {
        if (profile.Axes.Z is not { } z || profile.Height is null) return [];
        if (!isCut) return [DmcFormat.Text($"{Subprograms.ClearanceHeight}={-profile.UpSign * (long)int.MaxValue}")];
        return [frame is { } at ? DmcFormat.Text($"{Subprograms.ClearanceHeight}={at.Z + profile.ClearanceCounts}") : DmcFormat.Text($"{Subprograms.ClearanceHeight}=_RP{z.Letter}{profile.ClearanceCounts + lift:+0;-0}")];
    }

    /// <summary>Arguments of one call; a line is relative to the machine's position.</summary>
    public static string Arguments(in VectorSegment segment, CountsPoint here, int speed, int acceleration) => IsSlope(segment, here)
        ? DmcFormat.Text($"{Variables.X}={(long)segment.End.X - here.X};{Variables.Y}={(long)segment.End.Y - here.Y};{Variables.Z}={(long)segment.End.Z - here.Z};{Variables.Feed}={speed};{Variables.Acceleration}={acceleration};{Variables.Operation}={Operations.Slope}")
        : segment.Kind == VectorSegmentKind.Line
        ? DmcFormat.Text($"{Variables.X}={(long)segment.End.X - here.X};{Variables.Y}={(long)segment.End.Y - here.Y};{Variables.Feed}={speed};{Variables.Acceleration}={acceleration};{Variables.Operation}={Operations.Line}")
        : DmcFormat.Text($"{Variables.Radius}={segment.Radius};{Variables.Theta}={DmcFormat.Number(segment.ThetaDegrees)};{Variables.Delta}={DmcFormat.Number(segment.DeltaDegrees)};{Variables.Feed}={speed};{Variables.Acceleration}={acceleration};{Variables.Operation}={Operations.Arc}");

    private static bool IsSlope(in VectorSegment segment, CountsPoint here) => segment.End.Z != here.Z;

    /// <summary>The variables that <see cref="Arguments"/> sets, with the values to be read back.</summary>
    public static IReadOnlyList<(string Operand, double Value, double Step)> Held(in VectorSegment segment, CountsPoint here, int speed, int acceleration)
    {
        const double Exact = SettingCheck.Exact;
        if (IsSlope(segment, here))
            return [(Variables.X, (double)segment.End.X - here.X, Exact), (Variables.Y, (double)segment.End.Y - here.Y, Exact), (Variables.Z, (double)segment.End.Z - here.Z, Exact), (Variables.Feed, speed, Exact), (Variables.Acceleration, acceleration, Exact), (Variables.Operation, Operations.Slope, Exact)];
        return segment.Kind == VectorSegmentKind.Line
            ? [(Variables.X, (double)segment.End.X - here.X, Exact), (Variables.Y, (double)segment.End.Y - here.Y, Exact), (Variables.Feed, speed, Exact), (Variables.Acceleration, acceleration, Exact), (Variables.Operation, Operations.Line, Exact)]
            : [(Variables.Radius, segment.Radius, Exact), (Variables.Theta, segment.ThetaDegrees, Exact), (Variables.Delta, segment.DeltaDegrees, Exact), (Variables.Feed, speed, Exact), (Variables.Acceleration, acceleration, Exact), (Variables.Operation, Operations.Arc, Exact)];
    }
}
