namespace Engraver.Galil.Jobs.Watching;

/// <summary>Whether the tool output is as the job wants it. Somebody else may have switched it, or the command for it arrived as another one.</summary>
/// <remarks>One poll proves nothing: its operands are read one after the other, and between two of them the controller may have switched the tool off and not yet said why (a refused line, an axis that cannot follow),
/// or a program may have ended its stroke. The next poll knows. Where a program switches, both polls must lie in the same part of it, which is what <c>seq</c> says.</remarks>
internal sealed class ToolWatch
{
    private int? _callsWhenWrong;

    /// <summary>Whether the last poll saw the tool off that should be on: what is counted meanwhile is not cut.</summary>
    public bool IsMissing { get; private set; }

    /// <summary>Whether the last poll saw the output other than wanted; the next one should be a whole one.</summary>
    public bool IsSuspicious => _callsWhenWrong is not null;

    /// <summary>To be called with each poll; true when the output has been seen wrong long enough.</summary>
    /// <param name="wanted">Null where nobody can say.</param>
    /// <param name="isSwitchedByProgram">A program in the controller switches it, not this job.</param>
    public bool IsWrong(in MachineState now, bool isOn, bool? wanted, bool isSwitchedByProgram)
    {
        IsMissing = wanted == true && !isOn;
        var isAgain = _callsWhenWrong is { } before && (!isSwitchedByProgram || before == now.Calls);
        _callsWhenWrong = wanted is { } state && state != isOn ? now.Calls : null;
        return isAgain && IsSuspicious;
    }
}
