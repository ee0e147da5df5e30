using Engraver.Core.Machines;
using Engraver.Galil.Jobs.Watching;
using Engraver.Galil.Language;
using Engraver.Galil.Programs.Posting;
using Engraver.Galil.Programs.Resident;
using Engraver.Galil.Protocol;
using static Engraver.Galil.Programs.Resident.ResidentProgram;

namespace Engraver.Galil.Jobs.Execution;

/// <summary>The commands by which a job starts the program that was downloaded for it, and calls it (galil-dmc.md EX11, EX12, F.3).</summary>
internal static class ResidentServer
{
    /// <summary>Restarts the time of the watchdog.</summary>
    public static string HeartbeatCommand { get; } = JobMachine.Text($"{Variables.Heartbeat}={HeartbeatTicks}");

    /// <summary>Gives every polled variable a value before it is read, because an undefined one is refused, and sets the watchdog's time before it starts.</summary>
    public static string DefineVariables(MachineProfile profile) =>
        JobMachine.Text($"{HeartbeatCommand};{Variables.WatchdogTripped}=0;{Variables.ErrorCode}=0;{Variables.ErrorLine}=0;{Variables.Sequence}=0;{Variables.Done}=0;{Variables.StillLimit}={StandstillLimit.ControllerTicks(profile)}");

    /// <summary>Ends both threads of a job.</summary>
    public static IReadOnlyList<string> HaltCommands { get; } = [JobMachine.Text($"HX{MainThread}"), JobMachine.Text($"HX{WatchdogThread}")];

    public static string GoCommand { get; } = $"{Variables.Go}=1";

    public static ResidentProgram Program(JobMode mode, MachineProfile profile) => mode switch
    {
        JobMode.Stream => ForStream(profile),
        JobMode.Calls => ForCalls(profile),
        JobMode.Program => ForStream(profile), // runs until the first chunk is loaded
        _ => throw new ArgumentOutOfRangeException(nameof(mode)),
    };

    /// <summary>True for a resident program of a job with this profile, of any mode.</summary>
    public static bool IsOurs(string program, MachineProfile profile) =>
        ProgramText.AreSame(program, ForStream(profile).Text) || ProgramText.AreSame(program, ForCalls(profile).Text) || SupervisedProgram.IsChunk(program, profile);

    public static string StartCommand(ResidentProgram program) => JobMachine.Text($"XQ {program.EntryLabel},{MainThread}");

    /// <summary>Operand for the line of the watchdog's thread; -1 while it does not run.</summary>
    public static string WatchdogLine { get; } = JobMachine.Text($"_XQ{WatchdogThread}");

    /// <summary>Arguments of one call; a line is relative to the machine's position.</summary>
    public static string Arguments(in VectorSegment segment, CountsPoint here, int speed) => segment.Kind == VectorSegmentKind.Line
        ? JobMachine.Text($"{Variables.X}={(long)segment.End.X - here.X};{Variables.Y}={(long)segment.End.Y - here.Y};{Variables.Feed}={speed};{Variables.Operation}={Operations.Line}")
        : JobMachine.Text($"{Variables.Radius}={segment.Radius};{Variables.Theta}={DmcFormat.Number(segment.ThetaDegrees)};{Variables.Delta}={DmcFormat.Number(segment.DeltaDegrees)};{Variables.Feed}={speed};{Variables.Operation}={Operations.Arc}");

    /// <summary>The variables that <see cref="Arguments"/> sets, with the values to be read back.</summary>
    public static IReadOnlyList<(string Operand, double Value, double Step)> Held(in VectorSegment segment, CountsPoint here, int speed)
    {
        const double Exact = SettingCheck.Exact;
        return segment.Kind == VectorSegmentKind.Line
            ? [(Variables.X, (double)segment.End.X - here.X, Exact), (Variables.Y, (double)segment.End.Y - here.Y, Exact), (Variables.Feed, speed, Exact), (Variables.Operation, Operations.Line, Exact)]
            : [(Variables.Radius, segment.Radius, Exact), (Variables.Theta, segment.ThetaDegrees, Exact), (Variables.Delta, segment.DeltaDegrees, Exact), (Variables.Feed, speed, Exact), (Variables.Operation, Operations.Arc, Exact)];
    }
}
