namespace Engraver.Core.Machines;

/// <summary>The wire failed: gone, silent or speaking nonsense. A refused command is no exception but a <see cref="MachineRefusal"/>.</summary>
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
