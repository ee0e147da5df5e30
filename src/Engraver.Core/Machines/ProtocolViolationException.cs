namespace Engraver.Core.Machines;

/// <summary>The reply is not one that a Galil controller sends.</summary>
public sealed class ProtocolViolationException : ControllerException
{
    public ProtocolViolationException()
    {
    }

    public ProtocolViolationException(string message)
        : base(message)
    {
    }

    public ProtocolViolationException(string message, Exception inner)
        : base(message, inner)
    {
    }
}
