namespace Engraver.Workbench.Machines.Origins;

/// <summary>Another host uses the machine.</summary>
public sealed class MachineInUseException : MachineUnavailableException
{
    public MachineInUseException()
    {
    }

    public MachineInUseException(string message)
        : base(message)
    {
    }

    public MachineInUseException(string message, Exception inner)
        : base(message, inner)
    {
    }
}
