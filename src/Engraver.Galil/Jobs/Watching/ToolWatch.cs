namespace Engraver.Galil.Jobs.Watching;

/// <summary>Detects a tool output that is not as planned: another host may have switched it, or the command for it was corrupted.</summary>
/// <remarks>One poll is not enough: its operands are read one after the other, and between two of them the controller may have switched the tool off and
/// not yet set the reason (a refused line, an axis that cannot follow), or a program may have ended its stroke. The next poll shows it. Where a program
/// switches the tool, both polls must be in the same part of it, according to <c>seq</c>.</remarks>
internal sealed class ToolWatch
{
    private int? _callsWhenWrong;

    /// <summary>The last poll saw the tool off that should be on: what is counted meanwhile was not cut.</summary>
    public bool IsMissing { get; private set; }

    /// <summary>The last poll saw the output other than planned; the next one should be a whole poll.</summary>
    public bool IsSuspicious => _callsWhenWrong is not null;

    /// <summary>Call with each poll; true when the output was wrong for long enough.</summary>
    /// <param name="wanted">Null where it is not known.</param>
    /// <param name="isSwitchedByProgram">A program in the controller switches it, not this job.</param>
    public bool IsWrong(in JobPoll now, bool isOn, bool? wanted, bool isSwitchedByProgram)
    {
        IsMissing = wanted == true && !isOn;
        var isAgain = _callsWhenWrong is { } before && (!isSwitchedByProgram || before == now.Calls);
        _callsWhenWrong = wanted is { } state && state != isOn ? now.Calls : null;
        return isAgain && IsSuspicious;
    }
}
