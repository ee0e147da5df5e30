namespace Engraver.Workbench.Machines.Origins;

/// <summary>The stored state of a machine cannot be used. Without it the work origin is unknown, so nothing is moved.</summary>
public sealed class MachineMemoryException : MachineUnavailableException
{
    public MachineMemoryException()
    {
    }

    public MachineMemoryException(string message)
        : base(message)
    {
    }

    public MachineMemoryException(string message, Exception inner)
        : base(message, inner)
    {
    }

    /// <summary>The state cannot be written: nothing is moved, because the position would be unknown afterwards.</summary>
    internal static MachineMemoryException NotWritten(string failure) => new(Wording.Get("Origins.NotWritten", failure));
}
