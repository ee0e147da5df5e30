using Engraver.Core.Machines;

namespace Engraver.Galil.Programs.Resident;

/// <summary>The program in the controller while the host runs a job: a loop in thread 0 (on older firmware handlers run only while thread 0 runs, galil-dmc.md
/// C.3), the watchdog in thread 1, #POSERR and #CMDERR.</summary>
/// <remarks>
/// Start: halt both threads, download <see cref="Text"/>, assign <see cref="Variables.Heartbeat"/> and <see cref="Variables.StandstillTickLimit"/>, <c>XQ</c>
/// <see cref="EntryLabel"/> in <see cref="MainThread"/> (it starts the watchdog itself), then assign
/// <see cref="Variables.Heartbeat"/> at least every 300 ms. The constants hold every name that the host needs.
/// </remarks>
/// <param name="Text">Program lines, each ended with LF.</param>
/// <param name="EntryLabel">With its '#'.</param>
/// <param name="Labels">Every label, with its '#'.</param>
public sealed record ResidentProgram(string Text, string EntryLabel, IReadOnlyList<string> Labels)
{
    public const int MainThread = 0;
    public const int WatchdogThread = 1;

    /// <summary>Value to assign to the heartbeat: ticks of 50 ms (1.0 s in all) until the next assignment is overdue.</summary>
    public const int HeartbeatTicks = 20;

    /// <summary>The same for a jog, which must end when its key is released: 0.25 s in all, and never less than four ticks.</summary>
    public const int CloseHeartbeatTicks = 5;

    /// <summary>For a host that streams segments; the controller runs only the watchdog.</summary>
    public static ResidentProgram ForStream(MachineProfile profile) =>
        Compose(IdleProgram.Entry, IdleProgram.Lines, Guards(profile));

    /// <summary>For a host that assigns variables; the server calls #LINEAR, #CIRC and the rest.</summary>
    public static ResidentProgram ForCalls(MachineProfile profile) =>
        Compose(CallsServerProgram.Entry, CallsServerProgram.Lines(profile), Guards(profile));

    /// <summary>For homing, which the controller does alone after the host has assigned go.</summary>
    public static ResidentProgram ForHoming(MachineProfile profile) =>
        Compose(HomingProgram.Entry, HomingProgram.Lines(profile), Guards(profile));

    /// <summary>Programs that stop the machine when the host is lost, an axis cannot follow or a line is refused.</summary>
    internal static IReadOnlyList<string> Guards(MachineProfile profile) => [.. WatchdogProgram.Lines(profile), .. PositionErrorProgram.Lines(profile), .. CommandErrorProgram.Lines(profile)];

    private static ResidentProgram Compose(string entry, params IReadOnlyList<string>[] parts)
    {
        var lines = parts.SelectMany(part => part).ToList();
        return new ResidentProgram(string.Concat(lines.Select(line => line + "\n")), entry, [.. lines.Where(line => line[0] == '#')]);
    }

    /// <summary>Names of the variables, at most eight lower-case letters (galil-dmc.md E).</summary>
    public static class Variables
    {
        /// <summary>Ticks left until the watchdog trips.</summary>
        public const string Heartbeat = "hb";

        /// <summary>Number of ticks for which the tool has been on without motion.</summary>
        public const string StandstillTicks = "still";

        /// <summary>Number of these ticks that trips the watchdog.</summary>
        public const string StandstillTickLimit = "stillmax";

        /// <summary>0 until the watchdog has stopped the machine: <see cref="WatchdogProgram.HeartbeatLost"/> or
        /// <see cref="WatchdogProgram.ToolForgotten"/>.</summary>
        public const string WatchdogTripped = "wtrip";

        /// <summary>TC code of a refused program line, <see cref="PositionErrorProgram.Code"/> for an axis that cannot follow, 0 for neither. If it is not 0,
        /// the server has ended.</summary>
        public const string ErrorCode = "errcode";

        /// <summary>Line of the program that was refused.</summary>
        public const string ErrorLine = "errline";

        /// <summary>1 during a hold by the host: a program that runs the job waits after its next rapid.</summary>
        public const string Hold = "wh";

        /// <summary>1 while the program waits after a rapid.</summary>
        public const string AtGate = "wg";

        /// <summary>Number of the running job, also in its journal; 0 for a move by hand.</summary>
        public const string JobMark = "jm";

        /// <summary>Number of the job that the watchdog stopped last; the last of the trip's variables to be assigned.</summary>
        public const string TripMark = "wj";

        /// <summary>_CSS when the watchdog tripped.</summary>
        public const string TripCounter = "wc";

        /// <summary>Position of the first axis at that time, controller's counts.</summary>
        public const string TripX = "wx";

        public const string TripY = "wy";

        /// <summary>Height at that time, if an axis holds the tool.</summary>
        public const string TripZ = "wz";

        /// <summary>_AVS at that time: counts along the sequence.</summary>
        public const string TripDistance = "wd";

        /// <summary>The requested operation: one of <see cref="Operations"/>.</summary>
        public const string Operation = "op";

        /// <summary>Assigned 1 last: the server clears it and starts the operation.</summary>
        public const string Go = "go";

        /// <summary>1 while the server waits.</summary>
        public const string Done = "done";

        /// <summary>Number of completed operations. Wait for it to increase, then assign the next call (<see cref="Done"/> is still 1 just after go).</summary>
        public const string Sequence = "seq";

        /// <summary>Line: counts from the machine's position. Rapid: the controller's own coordinates. Tool: 1 on, 0 off.</summary>
        public const string X = "x";

        public const string Y = "y";

        /// <summary>For a line that changes height: counts from the machine's height.</summary>
        public const string Z = "z";

        public const string Radius = "r";

        public const string Theta = "th";

        public const string Delta = "da";

        /// <summary>Vector speed of lines and arcs, counts/s.</summary>
        public const string Feed = "f";

        /// <summary>Acceleration and deceleration of lines and arcs, counts/s2.</summary>
        public const string Acceleration = "va";
    }

    /// <summary>Values of <see cref="Variables.Operation"/>.</summary>
    public static class Operations
    {
        public const int Line = 1;
        public const int Arc = 2;
        public const int Rapid = 3;
        public const int Tool = 4;
        public const int Slope = 5;
    }
}

/// <summary>Thread 0 while the host streams: it starts the watchdog and then loops, so that #CMDERR can interrupt it.</summary>
public static class IdleProgram
{
    public const string Entry = "#IDLE";

    internal static IReadOnlyList<string> Lines { get; } =
        [Entry, CommandErrorProgram.ClearStatement, WatchdogProgram.StartStatement, "#ILOOP", "WT 10", "JP#ILOOP", "EN"];

    public static string Text => string.Join('\n', Lines) + "\n";
}
