using Engraver.Core.Machines;
using Engraver.Galil.Language;
using Engraver.Galil.Programs.Posting;
using Engraver.Galil.Programs.Resident;
using static Engraver.Galil.Programs.Resident.ResidentProgram;

namespace Engraver.Galil.Jobs;

/// <summary>One poll of the controller.</summary>
/// <param name="SequenceRunning">_BGS.</param>
/// <param name="AxesRunning">_BG of an axis that the job moves.</param>
/// <param name="Counter">_CSS: segments of the sequence that are done.</param>
/// <param name="Calls">seq: calls that are done; in a watched job see <see cref="SupervisedProgram"/>.</param>
/// <param name="PathSpeed">_VMS, counts/s.</param>
/// <param name="Position">_RP of the two axes, the controller's frame.</param>
/// <param name="Time">TIME, samples.</param>
/// <param name="StopCode">_SC of the first axis.</param>
/// <param name="ProgramRuns">_XQ0 is a line: the resident program lives.</param>
/// <param name="ProgramError">errcode: TC code of a refused line of the resident program, 0 for none, <see cref="SupervisedProgram.Strayed"/> for a motion that ended early, <see cref="PositionErrorProgram.Code"/> for an axis that cannot follow.</param>
/// <param name="WatchdogRuns">_XQ1 is a line: the watchdog lives, or has just tripped.</param>
/// <param name="Trip">wtrip: why the watchdog has stopped the machine (<see cref="WatchdogProgram"/>); 0 while it has not.</param>
/// <param name="Outputs">_OP0: outputs 1 to 8, bit 0 is output 1.</param>
internal readonly record struct MachineState(
    bool SequenceRunning, bool AxesRunning, int Counter, int Calls, int PathSpeed, CountsPoint Position, long Time, int StopCode, bool ProgramRuns, bool WatchdogRuns, int ProgramError, int Trip, int Outputs)
{
    public bool Stands => !SequenceRunning && !AxesRunning;

    public MachineState WithProgram(IReadOnlyList<double> v) => this with
    {
        AxesRunning = v[0] != 0 || v[1] != 0,
        Calls = (int)v[2],
        ProgramRuns = v[3] >= 0,
        WatchdogRuns = v[4] >= 0,
        ProgramError = (int)v[5],
    };

    public MachineState WithMotion(IReadOnlyList<double> v) => this with
    {
        SequenceRunning = v[0] != 0,
        Counter = (int)v[1],
        PathSpeed = (int)v[2],
        Position = new CountsPoint((int)v[3], (int)v[4]),
        Time = (long)v[5],
        StopCode = (int)v[6],
        Trip = (int)v[7],
        Outputs = (int)v[8],
    };

    public static MachineState From(IReadOnlyList<double> v) => new(
        v[0] != 0, v[1] != 0 || v[2] != 0, (int)v[3], (int)v[4], (int)v[5], new CountsPoint((int)v[6], (int)v[7]), (long)v[8], (int)v[9], v[10] >= 0, v[11] >= 0, (int)v[12], (int)v[13], (int)v[14]);
}

/// <summary>What a poll asks for, by the letters of the axes that the job moves; the answers are read by <see cref="MachineState"/>.</summary>
internal sealed class StateQuestions(MachineAxes axes)
{
    private readonly string _running = DmcAxes.Operands(axes.Letters, "_BG");
    private readonly string _places = DmcAxes.Operands(axes.Letters, "_RP");

    /// <summary>All of it in the order of the parameters; with MG exactly the 80 characters of a line. wtrip is asked behind _XQ1: where the watchdog ended by its trip, that is already known.</summary>
    public string All => $"_BGS,{_running},_CSS,{Variables.Sequence},_VMS,{_places},TIME,{StopCode},_XQ0,_XQ1,{Variables.ErrorCode},{Variables.WatchdogTripped},_OP0";

    /// <summary>On a serial line the questions go in two parts, so that the heartbeat fits between them: first what a program does ...</summary>
    public string Program => $"{_running},{Variables.Sequence},_XQ0,_XQ1,{Variables.ErrorCode}";

    /// <summary>... then, and more often, what the path does. Asked last: where the axes stood before, the position is final.</summary>
    public string Motion => $"_BGS,_CSS,_VMS,{_places},TIME,{StopCode},{Variables.WatchdogTripped},_OP0";

    private string StopCode => $"_SC{axes.X.Letter}";
}
