namespace Engraver.SoftwarePlatform;

/// <summary>No window can be shown: the X server cannot be reached, has gone, or its library is missing. The message is one sentence for the user.</summary>
public sealed class DisplayUnavailableException : Exception
{
    public DisplayUnavailableException()
    {
    }

    public DisplayUnavailableException(string message) : base(message)
    {
    }

    public DisplayUnavailableException(string message, Exception innerException) : base(message, innerException)
    {
    }
}
