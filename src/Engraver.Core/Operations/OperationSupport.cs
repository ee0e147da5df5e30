using Engraver.Core.Diagnostics;

namespace Engraver.Core.Operations;

/// <summary>What a format, or the controllers of a family, can do of operations besides moving a tool and switching it on and off. Jobs are refused by it
/// before anything is written or moved.</summary>
/// <param name="Target">The format or the family, for messages.</param>
public sealed record OperationSupport(string Target)
{
    /// <summary>It can set the power of a beam.</summary>
    public bool HasPower { get; init; }

    /// <summary>It can switch a beam at a place of the path while the machine moves.</summary>
    public bool HasOverscan { get; init; }

    /// <summary>The operations that it cannot do, each with the field.</summary>
    public IReadOnlyList<Diagnostic> Refusals(IEnumerable<Operation> operations)
    {
        ArgumentNullException.ThrowIfNull(operations);
        return [.. operations.Distinct().SelectMany(operation => Unsupported(operation).Select(field => OperationRules.NotInFormat.At(default, Target, field, operation.Title)))];
    }

    private IEnumerable<string> Unsupported(Operation operation)
    {
        if (operation.Power is not null && !HasPower) yield return "power";
        if (operation.Overscan > 0.0 && !HasOverscan) yield return "overscan";
    }
}
