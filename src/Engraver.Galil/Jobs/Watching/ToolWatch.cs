namespace Engraver.Galil.Jobs.Watching;

/// <summary>Detects a tool output that is not as the job wants it: somebody else may have switched it, or the command for it was damaged.</summary>
/// <remarks>One poll is not enough: its operands are read one after the other, and between two of them the controller may have switched the tool off and
/// not yet set the reason (a refused line, an axis that cannot follow),
/// or a program may have ended its stroke. The next poll shows it. Where a program switches the tool, both polls must lie in the same part of it, as
/// <c>seq</c> says.</remarks>
internal sealed class ToolWatch
{
    private int? _callsWhenWrong;

    /// <summary>The last poll saw the tool off that should be on: what is counted meanwhile is not cut.</summary>
    public bool IsMissing { get; private set; }

    /// <summary>The last poll saw the output other than wanted; the next one should be a whole poll.</summary>
    public bool IsSuspicious => _callsWhenWrong is not null;

    /// <summary>Call with each poll; true when the output was wrong for long enough.</summary>
    /// <param name="wanted">Null where it is not known.</param>
    /// <param name="isSwitchedByProgram">A program in the controller switches it, not this job.</param>
    public bool IsWrong(in MachineState now, bool isOn, bool? wanted, bool isSwitchedByProgram)
    {
        IsMissing = wanted == true && !isOn;
        var isAgain = _callsWhenWrong is { } before && (!isSwitchedByProgram || before == now.Calls);
        _callsWhenWrong = wanted is { } state && state != isOn ? now.Calls : null;
        return isAgain && IsSuspicious;
    }
}
