namespace Engraver.Core.Machines;

/// <summary>The controller does not respond: no reply, or no connection, within the time limit.</summary>
public sealed class ControllerTimeoutException : ControllerException
{
    public ControllerTimeoutException()
    {
    }

    public ControllerTimeoutException(string message)
        : base(message)
    {
    }

    public ControllerTimeoutException(string message, Exception inner)
        : base(message, inner)
    {
    }
}
