using Engraver.Core.Machines;

namespace Engraver.Galil.Protocol;

/// <summary>The controller heard something else than what was sent. The channel still carries the stop.</summary>
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
