using Engraver.Core.Diagnostics;

namespace Engraver.Core.Operations;

/// <summary>What a format, or the controllers of a family, can do of operations besides moving a tool and switching it on and off. Jobs are refused by it
/// before anything is written or moved.</summary>
/// <param name="Target">The format or the family, for messages.</param>
public sealed record OperationSupport(string Target)
{
    /// <summary>It can set the power of a beam.</summary>
    public bool HasPower { get; init; }

    /// <summary>The operations that it cannot do, each with the field.</summary>
    public IReadOnlyList<Diagnostic> Refusals(IEnumerable<Operation> operations)
    {
        ArgumentNullException.ThrowIfNull(operations);
        return [.. operations.Distinct().Where(operation => operation.Power is not null && !HasPower).Select(operation => OperationRules.NotInFormat.At(default, Target, "power", operation.Title))];
    }
}
