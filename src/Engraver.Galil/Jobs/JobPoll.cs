using Engraver.Core.Machines;
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
/// <param name="Position">_RP of the axes, the controller's frame.</param>
/// <param name="Time">TIME, samples.</param>
/// <param name="StopCode">_SC of the first axis.</param>
/// <param name="ProgramRuns">_XQ0 is a line: the resident program lives.</param>
/// <param name="ProgramError">errcode: TC code of a rejected line of the resident program, 0 for none, <see cref="SupervisedProgram.EndedEarlyCode"/> for a
/// motion
/// that ended early, <see cref="PositionErrorProgram.Code"/> for an axis that cannot follow.</param>
/// <param name="WatchdogRuns">_XQ1 is a line: the watchdog lives, or has just tripped.</param>
/// <param name="Trip">wtrip: why the watchdog has stopped the machine (<see cref="WatchdogProgram"/>); 0 while it has not.</param>
/// <param name="Outputs">_OP0: outputs 1 to 8, bit 0 is output 1.</param>
internal readonly record struct JobPoll(
    bool SequenceRunning, bool AxesRunning, int Counter, int Calls, int PathSpeed, CountsPoint Position, long Time, int StopCode, bool ProgramRuns, bool WatchdogRuns, int ProgramError, int Trip, int Outputs)
{
    /// <summary>_TE: commanded minus actual position of each axis, counts, 0 for those that are not read; null where it was not read with this position or
    /// just after it.</summary>
    public CountsPoint? Error { get; init; }

    public bool IsAtRest => !SequenceRunning && !AxesRunning;
}

/// <summary>One line of operands, and the machine state that results from its reply.</summary>
/// <param name="Text">Operands separated by commas, as in MG.</param>
/// <param name="Letters">Of the axes that the job moves, where position errors are read.</param>
internal sealed record StateQuestion(string Text, string Letters = "")
{
    private readonly string[] _operands = Text.Split(',');

    /// <summary>The state with the numbers of the reply; the rest of it does not change.</summary>
    /// <param name="v">One number for each operand.</param>
    public JobPoll Update(JobPoll state, IReadOnlyList<double> v)
    {
        var (axis, areAxesAsked, runs) = (0, false, false);
        Span<double> place = stackalloc double[3];
        Span<double> error = stackalloc double[Math.Max(2, Letters.Length)];
        var areErrorsAsked = false;
        for (var i = 0; i < _operands.Length; i++)
        {
            switch (_operands[i])
            {
                case "_BGS": state = state with { SequenceRunning = v[i] != 0 }; break;
                case "_CSS": state = state with { Counter = (int)v[i] }; break;
                case "_VMS": state = state with { PathSpeed = (int)v[i] }; break;
                case "TIME": state = state with { Time = (long)v[i] }; break;
                case "_XQ0": state = state with { ProgramRuns = v[i] >= 0 }; break;
                case "_XQ1": state = state with { WatchdogRuns = v[i] >= 0 }; break;
                case "_OP0": state = state with { Outputs = (int)v[i] }; break;
                case Variables.Sequence: state = state with { Calls = (int)v[i] }; break;
                case Variables.ErrorCode: state = state with { ProgramError = (int)v[i] }; break;
                case Variables.WatchdogTripped: state = state with { Trip = (int)v[i] }; break;
                case ['_', 'B', 'G', _]: (areAxesAsked, runs) = (true, runs || v[i] != 0); break;
                case ['_', 'R', 'P', _]: place[axis++] = v[i]; break;
                case ['_', 'T', 'E', var letter]: (areErrorsAsked, error[Letters.IndexOf(letter, StringComparison.Ordinal)]) = (true, v[i]); break;
                case ['_', 'S', 'C', _]: state = state with { StopCode = (int)v[i] }; break;
                default: throw new InvalidOperationException(_operands[i]);
            }
        }

        if (areAxesAsked) state = state with { AxesRunning = runs };
        if (areErrorsAsked) state = state with { Error = CountsPoint.From(error) };
        else if (axis > 0) state = state with { Error = null };
        return axis == 0 ? state : state with { Position = CountsPoint.From(place[..axis]) };
    }
}
