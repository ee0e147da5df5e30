using System.Text.Json;

namespace Engraver.Simulator;

/// <summary>A fault of a plan cannot occur.</summary>
public sealed class FaultPlanException : JsonException
{
    public FaultPlanException()
    {
    }

    public FaultPlanException(string message)
        : base(message)
    {
    }

    public FaultPlanException(string message, Exception inner)
        : base(message, inner)
    {
    }

    internal FaultPlanException(int fault, FaultError flaw)
        : base($"faults[{fault}].{flaw.Field}: {flaw.Reason}") => (Fault, Error) = (fault, flaw);

    /// <summary>Index of the fault in the list of faults, from 0.</summary>
    public int Fault { get; }

    public FaultError Error { get; }
}
