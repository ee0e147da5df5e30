namespace Engraver.Workbench.Sidecars;

/// <summary>The file has an unknown version.</summary>
public sealed class SidecarVersionException : Exception
{
    public SidecarVersionException()
    {
    }

    /// <param name="message">The version.</param>
    public SidecarVersionException(string message)
        : base(message)
    {
    }

    public SidecarVersionException(string message, Exception inner)
        : base(message, inner)
    {
    }
}
