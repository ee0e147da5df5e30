using Engraver.Core.Machines;

namespace Engraver.Galil.Protocol;

/// <summary>The echo differs from the sent line: the controller received something else. The stop can still be sent over the channel.</summary>
public sealed class EchoException : ControllerException
{
    public EchoException()
    {
    }

    public EchoException(string message)
        : base(message)
    {
    }

    public EchoException(string message, Exception inner)
        : base(message, inner)
    {
    }
}
