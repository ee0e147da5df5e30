namespace Engraver.Core.Machines;

/// <summary>The link to the controller was lost or could not be opened.</summary>
public sealed class ControllerLinkException : ControllerException
{
    public ControllerLinkException()
    {
    }

    public ControllerLinkException(string message)
        : base(message)
    {
    }

    public ControllerLinkException(string message, Exception inner)
        : base(message, inner)
    {
    }
}
