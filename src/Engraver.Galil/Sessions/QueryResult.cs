using Engraver.Galil.Protocol;

namespace Engraver.Galil.Sessions;

/// <summary>The numbers in the reply to a query, or its refusal.</summary>
public readonly record struct QueryResult(IReadOnlyList<double> Values, Rejected? Refusal)
{
    /// <summary>The number in the reply to a query with one operand; null when the controller refuses it, because it does not have that feature.</summary>
    public double? ValuesOrEmpty => Refusal is null ? Values[0] : null;
}
