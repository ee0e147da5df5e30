using Engraver.Galil.Protocol;

namespace Engraver.Galil.Sessions;

/// <summary>The numbers that answered a question, or the refusal to answer it.</summary>
public readonly record struct Reading(IReadOnlyList<double> Values, Rejected? Refusal)
{
    /// <summary>The single number of a question with one operand, or null when the controller does not know it: such a feature is not fitted.</summary>
    public double? OrNothing => Refusal is null ? Values[0] : null;
}
