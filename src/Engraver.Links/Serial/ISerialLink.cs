using Engraver.Core.Machines;

namespace Engraver.Links.Serial;

/// <summary>A link over a serial line.</summary>
public interface ISerialLink : IControllerLink
{
    /// <summary>Waits until the device has sent the accepted bytes. Closing then drops nothing: the system sends the bytes that are still in the
    /// adapter.</summary>
    /// <exception cref="IOException">The device was removed, or sent nothing within the time-out.</exception>
    ValueTask DrainAsync(CancellationToken cancellation);
}
