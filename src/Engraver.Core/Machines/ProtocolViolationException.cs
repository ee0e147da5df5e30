namespace Engraver.Core.Machines;

/// <summary>What came back is not what a Galil controller says.</summary>
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
