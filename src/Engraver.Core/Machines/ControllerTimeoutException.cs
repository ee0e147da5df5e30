namespace Engraver.Core.Machines;

/// <summary>The controller is silent: no reply, or no connection, in time.</summary>
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
