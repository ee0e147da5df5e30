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
/// <param name="Position">_RP of the axes, the controller's frame.</param>
/// <param name="Time">TIME, samples.</param>
/// <param name="StopCode">_SC of the first axis.</param>
/// <param name="ProgramRuns">_XQ0 is a line: the resident program lives.</param>
/// <param name="ProgramError">errcode: TC code of a rejected line of the resident program, 0 for none, <see cref="SupervisedProgram.Strayed"/> for a motion
/// that ended early, <see cref="PositionErrorProgram.Code"/> for an axis that cannot follow.</param>
/// <param name="WatchdogRuns">_XQ1 is a line: the watchdog lives, or has just tripped.</param>
/// <param name="Trip">wtrip: why the watchdog has stopped the machine (<see cref="WatchdogProgram"/>); 0 while it has not.</param>
/// <param name="Outputs">_OP0: outputs 1 to 8, bit 0 is output 1.</param>
internal readonly record struct MachineState(
    bool SequenceRunning, bool AxesRunning, int Counter, int Calls, int PathSpeed, CountsPoint Position, long Time, int StopCode, bool ProgramRuns, bool WatchdogRuns, int ProgramError, int Trip, int Outputs)
{
    /// <summary>_TE: commanded minus actual position of each axis, counts, 0 for those that are not read; null where it was not read with this position or
    /// just after it.</summary>
    public CountsPoint? Error { get; init; }

    public bool IsAtRest => !SequenceRunning && !AxesRunning;
}

/// <summary>What a poll queries, by the letters of the axes that the job moves.</summary>
internal sealed class StateQuestions
{
    /// <param name="isSlow">On a serial line the query is sent in two parts, so that the heartbeat fits between them.</param>
    /// <param name="followed">Letters of the axes whose position error is read; empty for none.</param>
    public StateQuestions(MachineAxes axes, bool isSlow, string followed)
    {
        var (running, places, code) = (DmcAxes.Operands(axes.Letters, "_BG"), DmcAxes.Operands(axes.Letters, "_RP"), $"_SC{axes.X.Letter}");
        var all = $"_BGS,{running},_CSS,{Variables.Sequence},_VMS,{places},TIME,{code},_XQ0,_XQ1,{Variables.ErrorCode},{Variables.WatchdogTripped},_OP0";
        IsOne = !isSlow && "MG ".Length + all.Length <= DmcLimits.LineLength;
        Program = new StateQuestion(isSlow ? $"{running},{Variables.Sequence},_XQ0,_XQ1,{Variables.ErrorCode}" : $"{running},_XQ0,_XQ1,{Variables.ErrorCode}");
        Motion = new StateQuestion(isSlow ? $"_BGS,_CSS,_VMS,{places},TIME,{code},{Variables.WatchdogTripped},_OP0" : $"_BGS,_CSS,{Variables.Sequence},_VMS,{places},TIME,{code},{Variables.WatchdogTripped},_OP0");
        Errors = followed.Length == 0 ? null : new StateQuestion(DmcAxes.Operands(followed, "_TE"), axes.Letters);
        MotionWithErrors = followed.Length == 0 || !isSlow ? null : new StateQuestion($"_BGS,_CSS,_VMS,{places},TIME,_OP0,{Errors!.Text}", axes.Letters);
        Whole = IsOne ? [new StateQuestion(all)] : [Program, Motion];
    }

    /// <summary>Everything, in the order of the queries. For two axes over a network one line, with MG exactly its 80 characters; wtrip is read after _XQ1:
    /// where the watchdog ended by its trip, wtrip is set by then.</summary>
    public IReadOnlyList<StateQuestion> Whole { get; }

    /// <summary>Sequence, counters and position are in one reply: they belong together.</summary>
    public bool IsOne { get; }

    /// <summary>In two parts: first what a program does ...</summary>
    public StateQuestion Program { get; }

    /// <summary>The position errors alone; null where they are not needed.</summary>
    public StateQuestion? Errors { get; }

    /// <summary>On a serial line, where another query would take the time of segments: what the path does, with the position errors instead of stop code
    /// and wtrip. Null over a network, and where the errors are not needed.</summary>
    public StateQuestion? MotionWithErrors { get; }

    /// <summary>... then, and on a serial line more often, what the path does. Read last: where the axes were at rest before, the position is final. Where
    /// it fits into the line, seq is read here too, with the position to which it belongs.</summary>
    public StateQuestion Motion { get; }
}

/// <summary>One line of operands, and the machine state that results from its reply.</summary>
/// <param name="Text">Operands separated by commas, as in MG.</param>
/// <param name="Letters">Of the axes that the job moves, where position errors are read.</param>
internal sealed record StateQuestion(string Text, string Letters = "")
{
    private readonly string[] _operands = Text.Split(',');

    /// <summary>The state with the numbers of the reply; the rest of it does not change.</summary>
    /// <param name="v">One number for each operand.</param>
    public MachineState Update(MachineState state, IReadOnlyList<double> v)
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
