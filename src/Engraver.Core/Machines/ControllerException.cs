namespace Engraver.Core.Machines;

/// <summary>The link failed: it was lost, does not respond or carries invalid data. A refused command is not an exception but a
/// <see cref="MachineRefusal"/>.</summary>
public abstract class ControllerException : Exception
{
    protected ControllerException()
    {
    }

    protected ControllerException(string message)
        : base(message)
    {
    }

    protected ControllerException(string message, Exception inner)
        : base(message, inner)
    {
    }
}
