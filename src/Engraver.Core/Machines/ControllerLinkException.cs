namespace Engraver.Core.Machines;

/// <summary>The link to the controller is gone or never came up.</summary>
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
