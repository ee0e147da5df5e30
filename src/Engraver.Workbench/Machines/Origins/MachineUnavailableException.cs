using Engraver.Core.Machines;

namespace Engraver.Workbench.Machines.Origins;

/// <summary>The machine answers but must not be moved by this host. Nothing was moved.</summary>
public abstract class MachineUnavailableException : ControllerException
{
    protected MachineUnavailableException()
    {
    }

    protected MachineUnavailableException(string message)
        : base(message)
    {
    }

    protected MachineUnavailableException(string message, Exception inner)
        : base(message, inner)
    {
    }
}
