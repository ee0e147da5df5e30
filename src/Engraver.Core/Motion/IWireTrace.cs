namespace Engraver.Core.Motion;

/// <summary>Receives every line sent to a controller and every reply. Several channels may write to one trace, from any thread.</summary>
public interface IWireTrace
{
    /// <param name="handle">Name of the channel.</param>
    /// <param name="direction"><c>&gt;</c> sent, <c>&lt;</c> received, <c>!</c> unsolicited.</param>
    void Write(string handle, char direction, string text);
}
