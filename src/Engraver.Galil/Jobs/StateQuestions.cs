using Engraver.Core.Machines;
using Engraver.Galil.Language;
using static Engraver.Galil.Programs.Resident.ResidentProgram;

namespace Engraver.Galil.Jobs;

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
