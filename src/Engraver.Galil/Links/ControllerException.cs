using Engraver.Galil.Protocol;

namespace Engraver.Galil.Links;

/// <summary>The wire failed: gone, silent or speaking nonsense. A refused command is no exception but a <see cref="Rejected"/> reply.</summary>
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
