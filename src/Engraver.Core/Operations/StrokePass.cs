namespace Engraver.Core.Operations;

/// <summary>A pass of a stroke.</summary>
/// <param name="Operation">Its operation.</param>
/// <param name="Stroke">Index of the stroke in its operation.</param>
/// <param name="Pass">Index of the pass, 0 is the first.</param>
/// <param name="Depth">Depth below the top of the work, mm.</param>
public sealed record StrokePass(Operation Operation, int Stroke, int Pass, double Depth)
{
    /// <summary>True when the machine stops between the stroke before and this one, because this one begins a repeat.</summary>
    /// <param name="before">Operation and pass of the stroke before.</param>
    public bool IsAfterStop(StrokePass before)
    {
        ArgumentNullException.ThrowIfNull(before);
        return Operation.StopsBetween && before.Pass != Pass && before.Operation.Id == Operation.Id && Operation.RepeatOf(Pass) > 1;
    }
}
